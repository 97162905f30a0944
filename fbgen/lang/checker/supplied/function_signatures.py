"""What the tables of standard functions are made of.

A parameter typed `COMMON` has the function's common type: all such arguments are brought to one
type out of `common`, and a result typed `COMMON` has it too. The arguments of a `StandardCall` are
positional, in the order written here, all of the types written here. A `WHOLE_NUMBER` argument
keeps whatever integer type (or, on S7, bit string type) it has, a `FLOATING` one REAL or LREAL.
A result typed `EXPECTED` has the type that the call is used as, if it is one of `results`, or that
its name ends in; else the first of them, or the common type if `results` starts with that.
"""

from enum import Enum
from typing import TypeAlias

from fbgen.dataclass import dataclass
from fbgen.lang.types import Elementary, Family, StringType


class Common(Enum):
    """Which types the common type of a function may be."""

    NUMBER = "a number"
    FLOATING = "REAL or LREAL"
    SHIFTED = "a bit string"
    SWAPPED = "WORD, DWORD or LWORD"
    COUNTED = "an integer or bit string"
    UNSIGNED = "an unsigned integer"
    DAYS = "DATE, LDATE, DATE_AND_TIME or LDT"
    ORDERED = "a number, bit string, time, date or text"
    ANY = "any elementary type or text"
    TEXT = "STRING or WSTRING"
    NONE = "none"


class Slot(Enum):
    """Parameter types that depend on the arguments."""

    COMMON = "the common type"
    WHOLE_NUMBER = "any integer"
    FLOATING = "REAL or LREAL"
    EXPECTED = "the type that is asked for"


COMMON = Slot.COMMON
WHOLE_NUMBER = Slot.WHOLE_NUMBER
FLOATING = Slot.FLOATING
EXPECTED = Slot.EXPECTED

ParameterType: TypeAlias = Slot | Elementary | StringType


@dataclass(frozen=True, slots=True)
class Function:
    """A standard function. `repeats`: further arguments follow the last parameter, numbered on."""

    name: str
    parameters: tuple[tuple[str, ParameterType], ...]
    result: ParameterType
    common: Common = Common.NONE
    repeats: bool = False
    results: tuple[ParameterType, ...] = ()


FAMILIES: dict[Common, tuple[Family, ...]] = {
    Common.NUMBER: (Family.SIGNED, Family.UNSIGNED, Family.REAL),
    Common.FLOATING: (Family.REAL,),
    Common.SHIFTED: (Family.BITS,),
    Common.SWAPPED: (Family.BITS,),
    Common.COUNTED: (Family.SIGNED, Family.UNSIGNED, Family.BITS),
    Common.UNSIGNED: (Family.UNSIGNED,),
    Common.DAYS: (Family.DATE,),
    Common.ORDERED: (
        *(Family.SIGNED, Family.UNSIGNED, Family.REAL, Family.BITS),
        *(Family.DURATION, Family.DATE, Family.CHAR),
    ),
    Common.ANY: (
        *(Family.SIGNED, Family.UNSIGNED, Family.REAL, Family.BITS, Family.BOOL),
        *(Family.DURATION, Family.DATE, Family.CHAR),
    ),
    Common.TEXT: (),
    Common.NONE: (),
}
"""The families of elementary types that a common type may come from."""

WITH_TEXT = (Common.ORDERED, Common.ANY, Common.TEXT)
"""The common types that may be STRING or WSTRING."""
