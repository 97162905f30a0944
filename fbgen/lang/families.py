"""What the S7 CPU families lack: types and constructs of the language.

Instructions: see `instruction_families`.

Sources: TIA Portal help, "Overview of the valid data types", "Slice access", "REGION", "Value
assignments" and "References"; for S7-300/400 also the STEP 7 V5 manual "S7-SCL".
"""

from enum import Enum
from types import MappingProxyType


class Cpu(Enum):
    """A CPU family, by the name that the command line takes."""

    S7_300 = "s7-300"
    S7_400 = "s7-400"
    S7_1200 = "s7-1200"
    S7_1500 = "s7-1500"

    @property
    def is_classic(self) -> bool:
        """S7-300 and S7-400: the language as STEP 7 V5 had it."""
        return self in (Cpu.S7_300, Cpu.S7_400)


class Construct(Enum):
    """Something that not every family has; the value is how a person calls it."""

    REGIONS = "REGION"
    SLICES = "slices such as .%X0"
    COMPOUND = "assignments with += -= *= /="
    OPEN_ARRAYS = "ARRAY[*]"
    REFERENCES = "REF_TO"


_LONG = frozenset(
    ["LWORD", "LINT", "ULINT", "LTIME", "LTIME_OF_DAY", "LTOD", "LDT", "LDATE_AND_TIME"],
)
_ONLY_NEW = _LONG | frozenset(
    ["SINT", "USINT", "UINT", "UDINT", "LREAL", "DTL", "WSTRING", "WCHAR", "VARIANT"],
)
_NOT_ON_1200 = _LONG | {"S5TIME", "DATE_AND_TIME", "DT", "ANY", "POINTER", "TIMER", "COUNTER"}

MISSING_TYPES = MappingProxyType(
    {
        Cpu.S7_300: _ONLY_NEW,
        Cpu.S7_400: _ONLY_NEW,
        Cpu.S7_1200: _NOT_ON_1200,
        Cpu.S7_1500: frozenset[str](),
    }
)
"""Upper-case names of the types that a family does not have."""

MISSING_CONSTRUCTS = MappingProxyType(
    {
        Cpu.S7_300: frozenset(Construct),
        Cpu.S7_400: frozenset(Construct),
        Cpu.S7_1200: frozenset((Construct.REFERENCES,)),
        Cpu.S7_1500: frozenset[Construct](),
    }
)
"""ARRAY[*] needs firmware V4.2 on an S7-1200 and V2.0 on an S7-1500; older ones are not told."""
