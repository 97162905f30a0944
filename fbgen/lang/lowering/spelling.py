"""Words that TIA and IEC spell differently: types, functions, literals.

Source: TIA Portal help, "Overview of the valid data types" and the lists of instructions; IEC
61131-3 second edition, elementary types and standard functions.
"""

import re

from fbgen.lang.ast import Literal, LiteralKind
from fbgen.lang.dialects.words import words
from fbgen.lang.literals import duration_text
from fbgen.lang.lowering.target import Target

TYPES = {
    "TON_TIME": "TON",
    "TOF_TIME": "TOF",
    "TP_TIME": "TP",
    "CTU_INT": "CTU",
    "CTD_INT": "CTD",
    "CTUD_INT": "CTUD",
}
"""Instances of system blocks that S7 names after their type of time or counter."""

S7_NAMES = {plain: name for name, plain in TYPES.items()}
"""The other way round."""

STANDARD_BLOCKS = words("TON TOF TP CTU CTD CTUD R_TRIG F_TRIG SR RS")
FUNCTIONS = words(
    "ABS SQRT LN LOG EXP SIN COS TAN ASIN ACOS ATAN EXPT ADD MUL SUB DIV MOD MOVE SHL SHR ROR ROL "
    "AND OR XOR NOT SEL MAX MIN LIMIT MUX GT GE EQ LE LT NE LEN LEFT RIGHT MID CONCAT INSERT "
    "DELETE REPLACE FIND TRUNC"
)
RENAMED_FUNCTIONS = {"ROUND": "REAL_TO_DINT"}
"""ROUND goes to the nearest DINT, ties to even, which is what the IEC conversion does."""

_CONVERSION = re.compile(r"([A-Z_]+)_TO_([A-Z_]+)")


def is_standard_function(name: str, target: Target) -> bool:
    """Whether the target has this function; the name is upper case."""
    conversion = _CONVERSION.fullmatch(name)
    if conversion:
        return all(kind in target.elementary or kind == "STRING" for kind in conversion.groups())
    return name in FUNCTIONS


def literal_text(literal: Literal, target: Target) -> str | None:
    """How the target writes a literal; None if it has no such literal."""
    if literal.kind is LiteralKind.DURATION:
        if literal.type_name not in target.elementary:
            return None
        text = duration_text(int(literal.value))
        return text if literal.type_name == "TIME" else f"L{text}"
    if literal.type_name and literal.kind is not LiteralKind.STRING:
        if literal.type_name not in target.elementary:
            return None
        rest = literal.text.partition("#")[2]
        if rest.startswith("(") or literal.text[:2] in ("C#", "c#"):
            rest = str(literal.value)
        short = {"DATE": "D", "TIME_OF_DAY": "TOD", "DATE_AND_TIME": "DT"}
        return f"{short.get(literal.type_name, literal.type_name)}#{rest.upper()}"
    if literal.kind is LiteralKind.WSTRING or literal.type_name:
        return None
    return literal.text.upper() if literal.kind is not LiteralKind.STRING else literal.text
