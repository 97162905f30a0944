"""Standard functions on numbers and bit strings, and selection.

Sources: IEC 61131-3 third edition, tables 22 and 28 to 33; TIA Portal help, "Math functions",
"Conversion operations" (NORM_X, SCALE_X), "Word logic operations" (DECO, ENCO), "BITSUM".
"""

from fbgen.lang.checker.supplied.function_signatures import (
    COMMON,
    EXPECTED,
    FLOATING,
    WHOLE_NUMBER,
    Common,
    Function,
)
from fbgen.lang.types import (
    BOOL,
    BYTE,
    DINT,
    DWORD,
    INT,
    LINT,
    LREAL,
    LWORD,
    REAL,
    SINT,
    UDINT,
    UINT,
    ULINT,
    USINT,
    WORD,
)

_NUMBERS = (SINT, INT, DINT, LINT, USINT, UINT, UDINT, ULINT, REAL, LREAL)


def _mathematical(name: str) -> Function:
    return Function(name, (("IN", COMMON),), COMMON, Common.FLOATING)


def _shift(name: str) -> Function:
    return Function(name, (("IN", COMMON), ("N", WHOLE_NUMBER)), COMMON, Common.SHIFTED)


def _byte_order(name: str) -> Function:
    return Function(name, (("IN", COMMON),), COMMON, Common.COUNTED)


NUMERIC_FUNCTIONS = (
    Function("ABS", (("IN", COMMON),), COMMON, Common.NUMBER),
    *map(_mathematical, ("SQRT", "LN", "LOG", "EXP", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN")),
    _mathematical("SQR"),
    _mathematical("FRAC"),
    Function("ATAN2", (("IN1", COMMON), ("IN2", COMMON)), COMMON, Common.FLOATING),
    Function("IS_VALID", (("IN", COMMON),), BOOL, Common.FLOATING),
    *map(_shift, ("SHL", "SHR", "ROL", "ROR")),
    Function("SWAP", (("IN", COMMON),), COMMON, Common.SWAPPED),
    *map(_byte_order, ("TO_BIG_ENDIAN", "TO_LITTLE_ENDIAN")),
    *map(_byte_order, ("FROM_BIG_ENDIAN", "FROM_LITTLE_ENDIAN")),
    Function("BITSUM", (("IN", COMMON),), INT, Common.SHIFTED),
    Function("ENCO", (("IN", COMMON),), INT, Common.SHIFTED),
    Function("DECO", (("IN", WHOLE_NUMBER),), EXPECTED, results=(DWORD, BYTE, WORD, LWORD)),
    Function(
        "NORM_X",
        (("MIN", COMMON), ("VALUE", COMMON), ("MAX", COMMON)),
        EXPECTED,
        Common.NUMBER,
        results=(REAL, LREAL),
    ),
    Function(
        "SCALE_X",
        (("MIN", COMMON), ("VALUE", FLOATING), ("MAX", COMMON)),
        EXPECTED,
        Common.NUMBER,
        results=(COMMON, *_NUMBERS),
    ),
)

SELECTION_FUNCTIONS = (
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
)

RANKED = ("GT", "GE", "EQ", "LE", "LT")
"""Comparisons that as functions take any number of arguments: each with the next one."""

CHAINED_COMPARISONS: dict[str, Function] = {
    name: Function(
        name,
        (("IN1", COMMON), ("IN2", COMMON), ("IN3", COMMON)),
        BOOL,
        Common.ORDERED,
        repeats=True,
    )
    for name in RANKED
}
"""With three arguments and more they are StandardCalls."""
