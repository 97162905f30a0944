"""The CPU is in STOP, so the master sends zeros (CLEAR)."""

from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class CpuStopped:
    """The CPU is in STOP, so the master sends zeros (CLEAR)."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._plant = plant
        self._on = on

    def inject(self) -> None:
        """It begins."""
        self._plant.cpu.stop()

    def clear(self) -> None:
        """It ends."""
        self._plant.cpu.start()


FAULT = FaultType(
    "cpu_stopped", "The CPU is in STOP, so the master sends zeros (CLEAR)", Target.WHOLE, CpuStopped
)
