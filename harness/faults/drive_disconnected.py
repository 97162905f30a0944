"""The stub from the line to one drive is broken; the others go on.

At a PBDP-110 it is the cable to the drive: in both directions it takes the supply away as well.
"""

from collections.abc import Iterator
from functools import partial
from typing import Literal

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import Hold, attribute, switched


class StubSettings(FaultSettings):
    """`direction` in which nothing gets through: to the drive, from it, or both."""

    direction: Literal["both", "to_drive", "from_drive"] = "both"


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, StubSettings)
    port = plant.drives[on].communication.port
    receive = attribute(port, "receive_open", True)
    transmit = attribute(port, "transmit_open", True)
    chosen = {"to_drive": (receive,), "from_drive": (transmit,)}
    held = chosen.get(settings.direction)
    if held is None:
        return Holding(plant, receive, transmit, *_cable(plant, on))
    return Holding(plant, *held)


def _cable(plant: Installation, drive: str) -> Iterator[Hold[bool]]:
    """The cable to a drive at an interface: the supply comes through it, too."""
    for entry in plant.interface_entries:
        device = plant.interfaces[entry.name]
        for item in entry.drives:
            if item.name == drive and item.channel is not None:
                channel = item.channel.lower()
                begin, end = partial(device.unplug, channel), partial(device.plug, channel)
                yield switched(device, f"cable {channel}", begin, end)


FAULT = FaultType(
    "drive_disconnected",
    "The stub from the line to a drive is broken",
    Target.DRIVE,
    _make,
    StubSettings,
)
