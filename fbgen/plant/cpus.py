"""Work memory of the CPUs of each family, for the estimate of what a plant takes.

S7-1200 and S7-300 have one work memory for code and data, the others one for each. A figure belongs
to the latest order number of a CPU; older ones have less, so compare it with the data sheet.

Sources: "documented" figures stand in a public text with the order number (S7-1200, firmware 4:
6ES7 21x-1xx40; S7-1500: comparison of 1513 and 1515; S7-300: 6ES7 315-2AH14 and 315-2AF03; S7-400:
6ES7 412-1XF03, 412-2XG00, 414-3EM05, 416-2FK02). All others are recalled from the CPU manuals and
were found in no document at hand.
"""

from types import MappingProxyType

from fbgen.dataclass import dataclass
from fbgen.plant.families import PlcFamily


@dataclass(frozen=True, slots=True)
class Cpu:
    """A CPU: its work memory in KiB. `data_kib` is None where `code_kib` is for both."""

    name: str
    family: PlcFamily
    code_kib: int
    data_kib: int | None
    documented: bool


def _listed(family: PlcFamily, documented: bool, **sizes: int | tuple[int, int]) -> tuple[Cpu, ...]:
    found = []
    for keyword, size in sizes.items():
        code, data = (size, None) if isinstance(size, int) else size
        found.append(Cpu(_name(keyword), family, code, data, documented))
    return tuple(found)


def _name(keyword: str) -> str:
    return keyword.removeprefix("cpu_").replace("_", "-")


CPUS = MappingProxyType(
    {
        cpu.name: cpu
        for cpu in (
            *_listed("s7-1200", True, cpu_1211C=50, cpu_1212C=75, cpu_1214C=100, cpu_1215C=125),
            *_listed("s7-1200", True, cpu_1217C=150),
            *_listed("s7-1500", False, cpu_1511_1=(150, 1024)),
            *_listed("s7-1500", True, cpu_1513_1=(300, 1536), cpu_1515_2=(500, 3072)),
            *_listed("s7-1500", False, cpu_1516_3=(1024, 5120), cpu_1517_3=(2048, 8192)),
            *_listed("s7-300", True, cpu_315_2AF03=64),
            *_listed("s7-300", False, cpu_313C_2=128, cpu_314C_2=192),
            *_listed("s7-300", True, cpu_315_2AH14=256),
            *_listed("s7-300", False, cpu_317_2=1024, cpu_319_3=2048),
            *_listed("s7-400", True, cpu_412_1XF03=(48, 48), cpu_412_2XG00=(72, 72)),
            *_listed("s7-400", True, cpu_416_2FK02=(819, 819), cpu_414_3EM05=(1433, 1433)),
        )
    }
)
"""All CPUs by name, the smallest of a family first."""


def cpus_of(family: str) -> tuple[Cpu, ...]:
    """The CPUs of a family, the smallest first; none for PLCs that are not of the S7 kind."""
    return tuple(cpu for cpu in CPUS.values() if cpu.family == family)
