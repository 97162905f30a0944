"""The stub from the line to one drive is broken; the others go on.

At a PBDP-110 it is the cable to the drive: in both directions it takes the supply away as well.
On DeviceNet it is the drop to the drive.
"""

from typing import Literal

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.on_a_line import require_telegrams
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


class StubSettings(FaultSettings):
    """`direction` in which nothing gets through: to the drive, from it, or both."""

    direction: Literal["both", "to_drive", "from_drive"] = "both"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, StubSettings)
    if settings.direction != "both":
        require_telegrams(plant, on, "a cable has no directions")
    port = plant.drives[on].communication.port
    receive = attribute(port, "receive_open", True)
    transmit = attribute(port, "transmit_open", True)
    chosen = {"to_drive": (receive,), "from_drive": (transmit,)}
    held = chosen.get(settings.direction)
    if held is None:
        return Holding(plant, receive, transmit, *plant.cable(on))
    return Holding(plant, *held)


FAULT = FaultType(
    "drive_disconnected",
    "The stub from the line to a drive is broken",
    Target.DRIVE,
    _make,
    StubSettings,
)
