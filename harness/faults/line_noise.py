"""Noise on the line behind a gateway: each bit may be inverted, seeded."""

from typing import Annotated

from pydantic import Field

from fbgen.catalog.scalars import Real
from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class NoiseSettings(FaultSettings):
    """`bit_error_rate` is the probability for each bit, both directions."""

    bit_error_rate: Annotated[Real, Field(gt=0, le=1)] = 0.01


class LineNoise:
    """Noise on both pairs of a line."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        assert isinstance(settings, NoiseSettings)
        line = plant.lines[on]
        self._pairs = (line.master_pair, line.slave_pair)
        self._rate = settings.bit_error_rate

    def inject(self) -> None:
        """It begins."""
        for pair in self._pairs:
            pair.interference.bit_errors.probability = self._rate

    def clear(self) -> None:
        """It ends."""
        for pair in self._pairs:
            pair.interference.bit_errors.probability = 0.0


FAULT = FaultType(
    "line_noise", "Noise on the line behind a gateway", Target.GATEWAY, LineNoise, NoiseSettings
)
