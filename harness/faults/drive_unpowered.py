"""A drive has no supply."""

from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class DriveUnpowered:
    """A drive has no supply."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._plant = plant
        self._on = on

    def inject(self) -> None:
        """It begins."""
        self._plant.drives[self._on].power_off()

    def clear(self) -> None:
        """It ends."""
        self._plant.drives[self._on].power_on()


FAULT = FaultType("drive_unpowered", "A drive has no supply", Target.DRIVE, DriveUnpowered)
