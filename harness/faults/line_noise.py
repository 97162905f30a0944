"""Noise on the line behind a gateway: each bit may be inverted, seeded."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Probability, Target
from harness.faults.holding import Holding
from harness.faults.line_pairs import Direction, pairs
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


class NoiseSettings(FaultSettings):
    """`bit_error_rate` is the probability for each bit, in this `direction`."""

    bit_error_rate: Probability = 0.01
    direction: Direction = "both"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, NoiseSettings)
    rates = [pair.interference.bit_errors for pair in pairs(plant, on, settings.direction)]
    return Holding(
        plant, *(attribute(rate, "probability", settings.bit_error_rate) for rate in rates)
    )


FAULT = FaultType(
    "line_noise", "Noise on the line behind a gateway", Target.LINE, _make, NoiseSettings
)
