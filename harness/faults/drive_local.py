"""A drive is switched to local control at a terminal."""

from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class DriveLocal:
    """Run and stop come from the panel or the terminals, whatever the network says."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._drive = plant.drives[on]

    def inject(self) -> None:
        """It is switched to local."""
        self._drive.switch_to_local(True)

    def clear(self) -> None:
        """It is switched back; the command word is as it was written last."""
        self._drive.switch_to_local(False)


FAULT = FaultType("drive_local", "A drive is switched to local control", Target.DRIVE, DriveLocal)
