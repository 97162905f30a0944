"""PROFIBUS is interrupted: nothing passes between master and slaves."""

from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class ProfibusInterrupted:
    """PROFIBUS is interrupted: nothing passes between master and slaves."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._plant = plant
        self._on = on

    def inject(self) -> None:
        """It begins."""
        self._plant.master.connected = False

    def clear(self) -> None:
        """It ends."""
        self._plant.master.connected = True


FAULT = FaultType(
    "profibus_interrupted",
    "PROFIBUS is interrupted: nothing passes between master and slaves",
    Target.WHOLE,
    ProfibusInterrupted,
)
