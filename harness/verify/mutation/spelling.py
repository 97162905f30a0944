"""Numbers and times as they are written in the PLC languages, with another value."""

import re
import struct

from fbgen.lang.ast import LiteralKind
from fbgen.lang.checked import Constant
from fbgen.lang.literals import BadLiteralError, LiteralValue, read_literal
from fbgen.lang.types import LTIME, TIME, Elementary

_BASED = re.compile(r"(?P<head>.*\b|)(?P<base>2|8|16)#(?P<digits>[0-9A-Fa-f_]+)\Z")
_DIGITS = {2: "b", 8: "o", 16: "X"}


def literal_of(constant: Constant) -> LiteralValue | None:
    """What is written where the constant stands; None for a name, or for a calculation."""
    try:
        return read_literal(constant.span.text.removeprefix("-"))
    except BadLiteralError:
        return None


def whole_number(constant: Constant, value: int) -> str | None:
    """The text of a constant with another whole number in it; None if it cannot be said so."""
    literal = literal_of(constant)
    if literal is None or literal.kind is not LiteralKind.INTEGER or value < 0:
        return None
    text = constant.span.text
    if text.startswith("-"):
        return None
    if found := _BASED.match(text):
        base = int(found["base"])
        digits = format(value, _DIGITS[base]).zfill(len(found["digits"].replace("_", "")))
        return f"{found['head']}{base}#{digits}"
    head, separator, _ = text.rpartition("#")
    return f"{head}{separator}{value}"


def duration(kind: Elementary, ticks: int) -> str | None:
    """A TIME or LTIME as a literal."""
    if kind == TIME:
        return f"T#{ticks}ms"
    return f"LT#{ticks}ns" if kind == LTIME else None


def real(value: float) -> str:
    """A number as a REAL literal."""
    text = f"{value:.7g}"
    return text if "." in text or "e" in text else f"{text}.0"


def read_real(text: str, kind: Elementary) -> float:
    """What a REAL or LREAL literal means."""
    value = float(text)
    if kind.bits == 64:
        return value
    rounded: float = struct.unpack("f", struct.pack("f", value))[0]
    return rounded
