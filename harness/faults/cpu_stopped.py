"""The CPU is in STOP, so the master sends zeros (CLEAR)."""

from typing import Literal

from harness.engine.interface import State
from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class StopSettings(FaultSettings):
    """`data` says what the restart finds in the data blocks.

    `initial`: their initial values, in what is not remanent. `kept`: all as it was at the STOP, as
    an S7-400 has it, an S7-300 that does not know NON_RETAIN, or a PLC that only goes on.
    """

    data: Literal["initial", "kept"] = "initial"


class CpuStopped:
    """The CPU is in STOP, so the master sends zeros (CLEAR)."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        assert isinstance(settings, StopSettings)
        self._plant = plant
        self._keeps = settings.data == "kept"
        self._state: State | None = None

    def inject(self) -> None:
        """It begins."""
        self._plant.cpu.stop()
        if self._keeps:
            self._state = self._plant.cpu.engine.snapshot()

    def clear(self) -> None:
        """It ends."""
        self._plant.cpu.start()
        if self._state is not None:
            self._plant.cpu.engine.restore(self._state)


FAULT = FaultType(
    "cpu_stopped",
    "The CPU is in STOP, so the master sends zeros (CLEAR)",
    Target.WHOLE,
    CpuStopped,
    StopSettings,
)
