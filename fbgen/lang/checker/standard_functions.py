"""The standard functions: names, parameters, results. An engine implements every one of them.

A parameter typed `COMMON` has the function's common type: all such arguments are brought to one
type out of `common`, and a result typed `COMMON` has it too. The arguments of a `StandardCall` are
positional, in the order written here, all of the types written here. A `WholeNumber` argument keeps
whatever integer type (or, on S7, bit string type) it has.
Sources: IEC 61131-3 third edition, tables 22 to 36; TIA Portal help, "Instructions (SCL)".
"""

from dataclasses import dataclass
from enum import Enum
from typing import TypeAlias

from fbgen.lang.types import (
    BOOL,
    CHAR,
    DATE,
    DATE_AND_TIME,
    DINT,
    INT,
    LDT,
    LTIME,
    LTIME_OF_DAY,
    S5TIME,
    TIME,
    TIME_OF_DAY,
    WORD,
    Elementary,
    Family,
    StringType,
)


class Common(Enum):
    """Which types the common type of a function may be."""

    NUMBER = "a number"
    FLOATING = "REAL or LREAL"
    SHIFTED = "a bit string"
    SWAPPED = "WORD, DWORD or LWORD"
    ORDERED = "a number, bit string, time, date or text"
    ANY = "any elementary type or text"
    TEXT = "STRING or WSTRING"
    NONE = "none"


class Slot(Enum):
    """Parameter types that depend on the arguments."""

    COMMON = "the common type"
    WHOLE_NUMBER = "any integer"


COMMON = Slot.COMMON
WHOLE_NUMBER = Slot.WHOLE_NUMBER

ParameterType: TypeAlias = Slot | Elementary | StringType


@dataclass(frozen=True, slots=True)
class Function:
    """A standard function. `repeats`: further arguments follow the last parameter, numbered on."""

    name: str
    parameters: tuple[tuple[str, ParameterType], ...]
    result: ParameterType
    common: Common = Common.NONE
    repeats: bool = False


def _mathematical(name: str) -> Function:
    return Function(name, (("IN", COMMON),), COMMON, Common.FLOATING)


def _shift(name: str) -> Function:
    return Function(name, (("IN", COMMON), ("N", WHOLE_NUMBER)), COMMON, Common.SHIFTED)


_TWO_TEXTS = (("IN1", COMMON), ("IN2", COMMON))

_FUNCTIONS = (
    Function("ABS", (("IN", COMMON),), COMMON, Common.NUMBER),
    *map(_mathematical, ("SQRT", "LN", "LOG", "EXP", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN")),
    _mathematical("SQR"),
    _mathematical("FRAC"),
    *map(_shift, ("SHL", "SHR", "ROL", "ROR")),
    Function("MIN", (("IN1", COMMON), ("IN2", COMMON)), COMMON, Common.ORDERED, repeats=True),
    Function("MAX", (("IN1", COMMON), ("IN2", COMMON)), COMMON, Common.ORDERED, repeats=True),
    Function("LIMIT", (("MN", COMMON), ("IN", COMMON), ("MX", COMMON)), COMMON, Common.ORDERED),
    Function("SEL", (("G", BOOL), ("IN0", COMMON), ("IN1", COMMON)), COMMON, Common.ANY),
    Function(
        "MUX",
        (("K", WHOLE_NUMBER), ("IN0", COMMON), ("IN1", COMMON)),
        COMMON,
        Common.ANY,
        repeats=True,
    ),
    Function("SWAP", (("IN", COMMON),), COMMON, Common.SWAPPED),
    Function("LEN", (("IN", COMMON),), INT, Common.TEXT),
    Function("LEFT", (("IN", COMMON), ("L", WHOLE_NUMBER)), COMMON, Common.TEXT),
    Function("RIGHT", (("IN", COMMON), ("L", WHOLE_NUMBER)), COMMON, Common.TEXT),
    Function(
        "MID", (("IN", COMMON), ("L", WHOLE_NUMBER), ("P", WHOLE_NUMBER)), COMMON, Common.TEXT
    ),
    Function("CONCAT", _TWO_TEXTS, COMMON, Common.TEXT, repeats=True),
    Function("INSERT", (*_TWO_TEXTS, ("P", WHOLE_NUMBER)), COMMON, Common.TEXT),
    Function(
        "DELETE", (("IN", COMMON), ("L", WHOLE_NUMBER), ("P", WHOLE_NUMBER)), COMMON, Common.TEXT
    ),
    Function(
        "REPLACE",
        (*_TWO_TEXTS, ("L", WHOLE_NUMBER), ("P", WHOLE_NUMBER)),
        COMMON,
        Common.TEXT,
    ),
    Function("FIND", _TWO_TEXTS, INT, Common.TEXT),
    Function("CONCAT_DATE_TOD", (("IN1", DATE), ("IN2", TIME_OF_DAY)), DATE_AND_TIME),
    Function("S5TIME_TO_TIME", (("IN", S5TIME),), TIME),
    Function("TIME_TO_S5TIME", (("IN", TIME),), S5TIME),
    Function("BCD16_TO_INT", (("IN", WORD),), INT),
    Function("INT_TO_BCD16", (("IN", INT),), WORD),
    Function("STRING_TO_CHAR", (("IN", StringType()),), CHAR),
)

STANDARD_FUNCTIONS: dict[str, Function] = {function.name: function for function in _FUNCTIONS}
"""What can be called by name."""

ALIASES = {"WORD_BCD_TO_INT": "BCD16_TO_INT", "INT_TO_BCD_WORD": "INT_TO_BCD16"}
"""Other spellings of canonical names."""

ROUNDED_UP_OR_DOWN: dict[str, Function] = {
    name: Function(name, (("IN", COMMON),), DINT, Common.FLOATING) for name in ("CEIL", "FLOOR")
}
"""To whole numbers like ROUND and TRUNC (which are `Convert`), as StandardCalls giving DINT."""

DATE_ARITHMETIC: dict[tuple[str, Elementary, Elementary], tuple[str, Elementary]] = {
    ("+", TIME_OF_DAY, TIME): ("ADD_TOD_TIME", TIME_OF_DAY),
    ("+", LTIME_OF_DAY, LTIME): ("ADD_LTOD_LTIME", LTIME_OF_DAY),
    ("+", DATE_AND_TIME, TIME): ("ADD_DT_TIME", DATE_AND_TIME),
    ("+", LDT, LTIME): ("ADD_LDT_LTIME", LDT),
    ("-", TIME_OF_DAY, TIME): ("SUB_TOD_TIME", TIME_OF_DAY),
    ("-", LTIME_OF_DAY, LTIME): ("SUB_LTOD_LTIME", LTIME_OF_DAY),
    ("-", DATE_AND_TIME, TIME): ("SUB_DT_TIME", DATE_AND_TIME),
    ("-", LDT, LTIME): ("SUB_LDT_LTIME", LDT),
    ("-", TIME_OF_DAY, TIME_OF_DAY): ("SUB_TOD_TOD", TIME),
    ("-", LTIME_OF_DAY, LTIME_OF_DAY): ("SUB_LTOD_LTOD", LTIME),
    ("-", DATE, DATE): ("SUB_DATE_DATE", TIME),
    ("-", DATE_AND_TIME, DATE_AND_TIME): ("SUB_DT_DT", TIME),
    ("-", LDT, LDT): ("SUB_LDT_LDT", LTIME),
}
"""Dates and times of different types: the standard function that calculates, and its result."""

DATE_FUNCTIONS: dict[str, Function] = {
    name: Function(name, (("IN1", left), ("IN2", right)), result)
    for (_, left, right), (name, result) in DATE_ARITHMETIC.items()
}
"""Dates and times of day with durations: by name, and what + and - on these types become."""

_TEXT_NUMBERS = (
    *("SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT"),
    *("REAL", "LREAL"),
)
TEXT_CONVERSIONS: dict[str, tuple[str, str]] = {
    f"{source}_TO_{target}": (source, target)
    for number in _TEXT_NUMBERS
    for text in ("STRING", "WSTRING")
    for source, target in ((number, text), (text, number))
}
"""Numbers to text and back: StandardCalls with one argument and a result of these types."""

OPERATORS_BY_NAME: dict[str, str] = {
    "ADD": "+",
    "SUB": "-",
    "MUL": "*",
    "DIV": "/",
    "MOD": "MOD",
    "EXPT": "**",
    "AND": "AND",
    "OR": "OR",
    "XOR": "XOR",
    "EQ": "=",
    "NE": "<>",
    "LT": "<",
    "GT": ">",
    "LE": "<=",
    "GE": ">=",
    "ADD_TIME": "+",
    "SUB_TIME": "-",
    "MUL_TIME": "*",
    "MULTIME": "*",
    "DIV_TIME": "/",
    "DIVTIME": "/",
    "T_ADD": "+",
    "T_SUB": "-",
    "T_DIFF": "-",
}
"""Functions that are operators; their calls become `Binary`."""

CHAINED = ("ADD", "MUL", "AND", "OR", "XOR")
"""Those that take more than two arguments."""

FAMILIES: dict[Common, tuple[Family, ...]] = {
    Common.NUMBER: (Family.SIGNED, Family.UNSIGNED, Family.REAL),
    Common.FLOATING: (Family.REAL,),
    Common.SHIFTED: (Family.BITS,),
    Common.SWAPPED: (Family.BITS,),
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


def canonical_names() -> frozenset[str]:
    """Every name that a `StandardCall` can carry."""
    return frozenset((*STANDARD_FUNCTIONS, *ROUNDED_UP_OR_DOWN, *DATE_FUNCTIONS, *TEXT_CONVERSIONS))
