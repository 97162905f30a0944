"""Bytes are lost on the line behind a gateway, seeded."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Probability, Target
from harness.faults.holding import Holding
from harness.faults.line_pairs import Direction, pairs
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


class LossSettings(FaultSettings):
    """`byte_loss_rate` is the probability for each byte, in this `direction`."""

    byte_loss_rate: Probability = 0.01
    direction: Direction = "both"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, LossSettings)
    rates = [pair.interference.byte_losses for pair in pairs(plant, on, settings.direction)]
    return Holding(
        plant, *(attribute(rate, "probability", settings.byte_loss_rate) for rate in rates)
    )


FAULT = FaultType(
    "line_bytes_lost",
    "Bytes are lost on the line behind a gateway",
    Target.LINE,
    _make,
    LossSettings,
)
