"""Telegrams in the buffer of a gateway are overwritten before they go out (its manual, section 9).

What goes out instead are zeros, as after a CLEAR; no drive obeys them and none answers.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Probability, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


class BufferSettings(FaultSettings):
    """`probability` for each telegram."""

    probability: Probability = 0.1


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, BufferSettings)
    overwrites = plant.gateways[on].overwrites
    return Holding(plant, attribute(overwrites, "probability", settings.probability))


FAULT = FaultType(
    "gateway_buffer_overwritten",
    "Telegrams that wait in a gateway are overwritten",
    Target.TELEGRAMS,
    _make,
    BufferSettings,
)
