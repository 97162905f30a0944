"""What the dates of each dialect count, and from when on.

| type | `tia`, `step7` | `iec`, `twincat` |
|---|---|---|
| DATE | days since 1990-01-01 in 16 bit | seconds since 1970-01-01 in 32 bit |
| DATE_AND_TIME | nanoseconds since 1970-01-01; 1990 to 2089 | seconds since 1970-01-01 in 32 bit |
| LDT | nanoseconds since 1970-01-01 | the same |
| LDATE | none | nanoseconds since 1970-01-01 |

Each of the engines has its own table: they share no arithmetic.
Sources: TIA Portal help, "DATE", "DT (DATE_AND_TIME)", "LDT"; CODESYS and TwinCAT 3 help, "Date and
time data types". IEC 61131-3 leaves range and resolution to the implementation.
"""

from datetime import date
from typing import TypeVar

from fbgen.lang.types import (
    DATE,
    DATE_AND_TIME,
    LDATE,
    LDT,
    PC_DATE,
    PC_DATE_AND_TIME,
    Elementary,
)

NS_PER_S = 1_000_000_000
NS_PER_DAY = 86_400 * NS_PER_S


def _midnight(year: int) -> int:
    """Nanoseconds since 1970-01-01 of the beginning of a year."""
    return (date(year, 1, 1) - date(1970, 1, 1)).days * NS_PER_DAY


_FIRST_AND_UNIT_NS = {
    DATE: (_midnight(1990), NS_PER_DAY),
    DATE_AND_TIME: (0, 1),
    LDT: (0, 1),
    LDATE: (0, 1),
    PC_DATE: (0, NS_PER_S),
    PC_DATE_AND_TIME: (0, NS_PER_S),
}
_LIMITS_NS = {DATE_AND_TIME: (_midnight(1990), _midnight(2090) - 1)}
"""Where the type has more room than the controller takes."""
_ON_PC = {DATE: PC_DATE, DATE_AND_TIME: PC_DATE_AND_TIME}
_S7 = ("tia", "step7")
_T = TypeVar("_T")

DAYS = (DATE, PC_DATE, LDATE)
"""The types of dates without a time."""
STAMPS = (DATE_AND_TIME, PC_DATE_AND_TIME, LDT)
"""The types of dates with a time."""


def of_dialect(kind: _T, dialect: str) -> Elementary | _T:
    """DATE and DATE_AND_TIME as the dialect has them; any other type as it is."""
    if dialect in _S7 or not isinstance(kind, Elementary):
        return kind
    return _ON_PC.get(kind, kind)


def exists_in(kind: Elementary, dialect: str) -> bool:
    """False for LDATE on S7."""
    return kind != LDATE or dialect not in _S7


def counted_in(kind: Elementary) -> bool:
    """True for the types that this module knows."""
    return kind in _FIRST_AND_UNIT_NS


def instant_of(kind: Elementary, count: int) -> int:
    """Nanoseconds since 1970-01-01."""
    first, unit = _FIRST_AND_UNIT_NS[kind]
    return first + count * unit


def count_of(kind: Elementary, instant_ns: int) -> int:
    """What a variable holds for an instant; the part that it has no room for is cut off."""
    first, unit = _FIRST_AND_UNIT_NS[kind]
    return (instant_ns - first) // unit


def is_in_range(kind: Elementary, instant_ns: int) -> bool:
    """True if the controller has this instant in that type."""
    first, last = limits_ns(kind)
    return first <= instant_ns <= last


def limits_ns(kind: Elementary) -> tuple[int, int]:
    """The first and the last instant of a type."""
    _, unit = _FIRST_AND_UNIT_NS[kind]
    ends = (instant_of(kind, 0), instant_of(kind, kind.maximum) + unit - 1)
    return _LIMITS_NS.get(kind, ends)
