"""The line behind a gateway is broken in both directions."""

from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation
from harness.line import Pair


class LineBroken:
    """The line behind a gateway is broken in both directions."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._plant = plant
        self._on = on

    def inject(self) -> None:
        """It begins."""
        for pair in self._pairs():
            pair.broken = True

    def clear(self) -> None:
        """It ends."""
        for pair in self._pairs():
            pair.broken = False

    def _pairs(self) -> tuple[Pair, Pair]:
        line = self._plant.lines[self._on]
        return line.master_pair, line.slave_pair


FAULT = FaultType(
    "line_broken",
    "The line behind a gateway is broken in both directions",
    Target.GATEWAY,
    LineBroken,
)
