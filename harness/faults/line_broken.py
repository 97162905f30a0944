"""The line behind a gateway is broken in both directions."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.line_pairs import pairs
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, *(attribute(pair, "broken", True) for pair in pairs(plant, on)))


FAULT = FaultType(
    "line_broken",
    "The line behind a gateway is broken in both directions",
    Target.LINE,
    _make,
)
