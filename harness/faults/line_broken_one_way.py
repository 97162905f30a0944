"""One pair of the line behind a gateway is broken, so that only one direction is left."""

from typing import Literal

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.line_pairs import pairs
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


class OneWaySettings(FaultSettings):
    """`direction` is the one in which nothing gets through."""

    direction: Literal["to_drives", "from_drives"] = "from_drives"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, OneWaySettings)
    broken = pairs(plant, on, settings.direction)
    return Holding(plant, *(attribute(pair, "broken", True) for pair in broken))


FAULT = FaultType(
    "line_broken_one_way",
    "The line behind a gateway is broken in one direction",
    Target.LINE,
    _make,
    OneWaySettings,
)
