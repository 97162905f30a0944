"""Which CPU it is and how long things take on it. Times in nanoseconds.

Default times are plant settings, not facts of a CPU: the cycle is held at a minimum cycle time of
10 ms, the program is done after 1 ms, the cycle monitoring time is 150 ms, the default of S7.
"""

from dataclasses import field
from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from harness.engine.organization import ObSettings
from harness.kernel import NS_PER_MS, NS_PER_US
from harness.plc.error_events import ImageErrors


class CpuFamily(Enum):
    """The families that differ in how they reach consistent data."""

    S7_300 = "s7-300"
    S7_400 = "s7-400"
    S7_1200 = "s7-1200"
    S7_1500 = "s7-1500"
    IEC = "iec"
    TWINCAT = "twincat"

    @property
    def classic(self) -> bool:
        """True for S7-300 and S7-400, programmed with STEP 7 V5."""
        return self in (CpuFamily.S7_300, CpuFamily.S7_400)

    @property
    def image_errors(self) -> ImageErrors:
        """When OB85 is called for the process image, unless the project says otherwise."""
        return ImageErrors.EACH if self is CpuFamily.S7_400 else ImageErrors.NONE

    @property
    def consistent_instructions(self) -> bool:
        """True if there are DPRD_DAT and DPWR_DAT, as on every S7."""
        return self not in (CpuFamily.IEC, CpuFamily.TWINCAT)


class DpInterface(Enum):
    """Where the DP master sits: in the CPU, or in a communication processor beside it."""

    INTEGRATED = "integrated"
    EXTERNAL = "external"


@dataclass(frozen=True, slots=True)
class CpuSettings:
    """One CPU.

    `cycle_ns` is the minimum cycle time; `execution_ns` with up to `execution_jitter_ns` more is
    how long the program runs until the outputs are written. `instruction_ns` is the time of one
    DPRD_DAT or DPWR_DAT, `peripheral_ns` that of one direct access. `tear_probability` is the
    chance that the master's cycle falls into a transfer that can be torn. `image_errors` says when
    a station that fails in the process image calls OB85; None is the default of the family.
    `remanent_marker_bytes` of the bit memory survive a warm restart. `obs` has numbers and periods
    of organization blocks.
    """

    family: CpuFamily = CpuFamily.S7_1500
    dp_interface: DpInterface = DpInterface.INTEGRATED
    cycle_ns: int = 10 * NS_PER_MS
    execution_ns: int = NS_PER_MS
    execution_jitter_ns: int = 0
    watchdog_ns: int = 150 * NS_PER_MS
    instruction_ns: int = 20 * NS_PER_US
    peripheral_ns: int = 2 * NS_PER_US
    tear_probability: float = 0.0
    image_errors: ImageErrors | None = None
    memory_bytes: int = 1024
    remanent_marker_bytes: int = 0
    obs: ObSettings = field(default_factory=ObSettings)

    def __post_init__(self) -> None:
        if self.cycle_ns <= 0 or self.execution_ns < 0 or self.execution_jitter_ns < 0:
            longest_ns = self.execution_ns + self.execution_jitter_ns
            raise error(
                "FB7401",
                f"a CPU with a cycle of {self.cycle_ns / NS_PER_MS:g} ms and a program of "
                f"{self.execution_ns / NS_PER_MS:g} to {longest_ns / NS_PER_MS:g} ms "
                "is not possible",
                None,
                "the cycle takes some time, and no time is negative",
            )
