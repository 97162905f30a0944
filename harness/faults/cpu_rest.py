"""The CPU at rest, in STOP or without supply: shared by the faults that bring it there."""

from enum import IntEnum
from functools import partial

from fbgen.dataclass import dataclass
from harness.installation import Installation
from harness.installation.holds import Hold
from harness.plc import Cpu, Restart


class Rest(IntEnum):
    """How much of the CPU is left; the greatest counts if several faults hold it."""

    NONE = 0
    STOPPED = 1
    UNPOWERED = 2


@dataclass(frozen=True, slots=True)
class Awakening:
    """How the CPU is started again. With `keeps_data` all data are as they were, initial or not.

    So an S7-400 has it, an S7-300 that does not know NON_RETAIN, or a PLC that only goes on.
    """

    restart: Restart = Restart.WARM
    keeps_data: bool = False


_WARM = Awakening()


def cpu_at_rest(plant: Installation, rest: Rest, awakening: Awakening = _WARM) -> Hold[Rest]:
    """Hold the CPU at rest, from its cycle checkpoint on. The fault that ends last starts it."""
    cpu = plant.cpu
    return Hold(
        (cpu, "rest"),
        rest,
        lambda: Rest.NONE,
        lambda now: cpu.at_checkpoint(partial(_put, cpu, now, awakening)),
    )


def _put(cpu: Cpu, now: Rest, awakening: Awakening) -> None:
    if now is Rest.UNPOWERED:
        cpu.power_off()
    elif now is Rest.STOPPED:
        cpu.power_on()
    else:
        data = cpu.engine.snapshot()
        cpu.start(awakening.restart)
        if awakening.keeps_data:
            cpu.engine.restore(data)
