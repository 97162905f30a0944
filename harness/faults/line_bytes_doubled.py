"""Bytes arrive twice on the line behind a gateway, seeded."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Probability, Target
from harness.faults.holding import Holding
from harness.faults.line_pairs import Direction, pairs
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


class DoublingSettings(FaultSettings):
    """`byte_doubling_rate` is the probability for each byte, in this `direction`."""

    byte_doubling_rate: Probability = 0.01
    direction: Direction = "both"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, DoublingSettings)
    rates = [pair.interference.byte_doublings for pair in pairs(plant, on, settings.direction)]
    return Holding(
        plant, *(attribute(rate, "probability", settings.byte_doubling_rate) for rate in rates)
    )


FAULT = FaultType(
    "line_bytes_doubled",
    "Bytes arrive twice on the line behind a gateway",
    Target.LINE,
    _make,
    DoublingSettings,
)
