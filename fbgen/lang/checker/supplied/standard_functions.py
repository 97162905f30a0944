"""The standard functions: names, parameters, results. An engine implements every one of them.

The tables stand in `numeric_functions`, `text_functions`, `date_functions` and `bcd_functions`; how
to read them in `function_signatures`. Functions with several outputs: `routines`.
"""

from fbgen.lang.checker.supplied.bcd_functions import BCD_ALIASES, BCD_FUNCTIONS, UNSIGNED_BCD
from fbgen.lang.checker.supplied.date_functions import (
    CALENDAR_FUNCTIONS,
    DATE_ARITHMETIC,
    DATE_FUNCTIONS,
)
from fbgen.lang.checker.supplied.function_signatures import COMMON, Common, Function
from fbgen.lang.checker.supplied.numeric_functions import (
    CHAINED_COMPARISONS,
    NUMERIC_FUNCTIONS,
    RANKED,
    SELECTION_FUNCTIONS,
)
from fbgen.lang.checker.supplied.text_functions import TEXT_CONVERSIONS, TEXT_FUNCTIONS
from fbgen.lang.types import DINT, LREAL, REAL

__all__ = [
    "ALIASES",
    "CHAINED",
    "CHAINED_COMPARISONS",
    "DATE_ARITHMETIC",
    "DATE_FUNCTIONS",
    "OPERATORS_BY_NAME",
    "RANKED",
    "RENAMED",
    "ROUNDED_UP_OR_DOWN",
    "ROUNDED_TO_REAL",
    "STANDARD_FUNCTIONS",
    "TEXT_CONVERSIONS",
    "UNSIGNED_BCD",
    "canonical_names",
]

STANDARD_FUNCTIONS: dict[str, Function] = {
    function.name: function
    for function in (
        *NUMERIC_FUNCTIONS,
        *SELECTION_FUNCTIONS,
        *TEXT_FUNCTIONS,
        *CALENDAR_FUNCTIONS,
        *BCD_FUNCTIONS,
    )
}
"""What can be called by name."""

ALIASES = {
    **BCD_ALIASES,
    "CONCAT_DATE_LT": "CONCAT_DATE_LTOD",
    "DT_DAY": "DAY_OF_WEEK",
    "DT_DATE": "DATE_AND_TIME_TO_DATE",
    "DT_TOD": "DATE_AND_TIME_TO_TIME_OF_DAY",
    "S_MOVE": "MOVE",
    "S5TI_TIM": "S5TIME_TO_TIME",
    "TIM_S5TI": "TIME_TO_S5TIME",
    "DT_TO_STRING": "DATE_AND_TIME_TO_STRING",
    "DT_TO_WSTRING": "DATE_AND_TIME_TO_WSTRING",
    "TOD_TO_STRING": "TIME_OF_DAY_TO_STRING",
    "TOD_TO_WSTRING": "TIME_OF_DAY_TO_WSTRING",
    "LTOD_TO_STRING": "LTIME_OF_DAY_TO_STRING",
    "LTOD_TO_WSTRING": "LTIME_OF_DAY_TO_WSTRING",
}
"""Other spellings of canonical names."""

RENAMED: dict[str, tuple[str, dict[str, str]]] = {
    "AD_DT_TM": ("ADD_DT_TIME", {"T": "IN1", "D": "IN2"}),
    "SB_DT_TM": ("SUB_DT_TIME", {"T": "IN1", "D": "IN2"}),
    "SB_DT_DT": ("SUB_DT_DT", {"DT1": "IN1", "DT2": "IN2"}),
    "D_TOD_DT": ("CONCAT_DATE_TOD", {}),
    "I_STRNG": ("INT_TO_STRING", {"I": "IN"}),
    "DI_STRNG": ("DINT_TO_STRING", {"I": "IN"}),
    "R_STRNG": ("REAL_TO_STRING", {"IN": "IN"}),
    "STRNG_I": ("STRING_TO_INT", {"S": "IN"}),
    "STRNG_DI": ("STRING_TO_DINT", {"S": "IN"}),
    "STRNG_R": ("STRING_TO_REAL", {"S": "IN"}),
    **{
        f"{name}_{suffix}": (name, {f"{prefix}1": "IN1", f"{prefix}2": "IN2"})
        for name in ("EQ", "NE", "GT", "GE", "LT", "LE")
        for suffix, prefix in (("DT", "DT"), ("STRNG", "S"))
    },
}
"""The blocks of STEP 7's IEC library: the standard function, and what its parameters are called."""

ROUNDED_UP_OR_DOWN: dict[str, Function] = {
    name: Function(name, (("IN", COMMON),), DINT, Common.FLOATING) for name in ("CEIL", "FLOOR")
}
"""To whole numbers like ROUND and TRUNC (which are `Convert`), as StandardCalls giving DINT."""

ROUNDED_TO_REAL: dict[str, Function] = {
    f"{name}_{kind.name}": Function(f"{name}_REAL", (("IN", COMMON),), COMMON, Common.FLOATING)
    for name in ("ROUND", "TRUNC", "CEIL", "FLOOR")
    for kind in (REAL, LREAL)
}
"""To a floating point number without fraction: StandardCalls ROUND_REAL, TRUNC_REAL ..."""

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
    "T_ADD": "+",
    "T_SUB": "-",
    "T_DIFF": "-",
    "ADD_LTIME": "+",
    "SUB_LTIME": "-",
    "MUL_LTIME": "*",
    "DIV_LTIME": "/",
    "ADD_TIME": "+",
    "SUB_TIME": "-",
    "MUL_TIME": "*",
    "MULTIME": "*",
    "DIV_TIME": "/",
    "DIVTIME": "/",
}
"""Functions that are operators; their calls become `Binary`."""

CHAINED = ("ADD", "MUL", "AND", "OR", "XOR")
"""Those that take more than two arguments."""

MUX_WITH_ELSE = "MUX_ELSE"
"""MUX with INELSE: the last argument is what is taken for any other selector."""

LIMIT_OR_IN = "LIMIT_OR_IN"
"""LIMIT where limits that cross limit nothing."""


_ONE_TEXT = {"STR": "IN"}
_TWO_TEXTS = {"STR1": "IN1", "STR2": "IN2"}
_SIDE = {**_ONE_TEXT, "SIZE": "L"}
_PIECE = {**_ONE_TEXT, "LEN": "L", "POS": "P"}
TEXT_PARAMETERS: dict[str, dict[str, str]] = {
    "LEN": _ONE_TEXT,
    "LEFT": _SIDE,
    "RIGHT": _SIDE,
    "MID": _PIECE,
    "DELETE": _PIECE,
    "CONCAT": _TWO_TEXTS,
    "FIND": _TWO_TEXTS,
    "REPLACE": _TWO_TEXTS,
    "INSERT": {**_TWO_TEXTS, "POS": "P"},
}
"""What CODESYS and TwinCAT call the parameters of the text functions."""


def canonical_names() -> frozenset[str]:
    """Every name that a `StandardCall` can carry."""
    rounded = (function.name for function in ROUNDED_TO_REAL.values())
    return frozenset(
        (
            *(STANDARD_FUNCTIONS | ROUNDED_UP_OR_DOWN | DATE_FUNCTIONS),
            *(*TEXT_CONVERSIONS, *RANKED, MUX_WITH_ELSE, LIMIT_OR_IN, *rounded),
        )
    )
