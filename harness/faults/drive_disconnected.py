"""The stub from the line to one drive is broken; the others go on."""

from typing import Literal

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


class StubSettings(FaultSettings):
    """`direction` in which nothing gets through: to the drive, from it, or both."""

    direction: Literal["both", "to_drive", "from_drive"] = "both"


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, StubSettings)
    port = plant.drives[on].communication.port
    receive = attribute(port, "receive_open", True)
    transmit = attribute(port, "transmit_open", True)
    chosen = {"to_drive": (receive,), "from_drive": (transmit,)}
    return Holding(plant, *chosen.get(settings.direction, (receive, transmit)))


FAULT = FaultType(
    "drive_disconnected",
    "The stub from the line to a drive is broken",
    Target.DRIVE,
    _make,
    StubSettings,
)
