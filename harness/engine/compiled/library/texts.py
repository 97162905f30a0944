"""Texts: the string functions, and numbers as text.

Every function gives the whole result; the caller cuts it to the length of its type.
Sources: IEC 61131-3 third edition, table 34; TIA Portal help, "String + Char".
"""

import math
import re

from harness.engine.compiled.library.stops import NoNumber

_WHOLE = re.compile(r"[+-]?[0-9]+\Z")
_REAL = re.compile(r"[+-]?[0-9]+(?:\.[0-9]*)?(?:[eE][+-]?[0-9]+)?\Z")


def left(text: str, length: int) -> str:
    """LEFT: the first `length` characters."""
    return text[:length] if length > 0 else ""


def right(text: str, length: int) -> str:
    """RIGHT: the last `length` characters."""
    return text[-length:] if length > 0 else ""


def middle(text: str, length: int, position: int) -> str:
    """MID: `length` characters from the 1-based position on."""
    if position < 1 or length <= 0:
        return ""
    return text[position - 1 : position - 1 + length]


def insert(text: str, other: str, position: int) -> str:
    """INSERT: `other` behind the first `position` characters."""
    return text[:position] + other + text[position:] if position >= 0 else ""


def delete(text: str, length: int, position: int) -> str:
    """DELETE: without `length` characters from the position on."""
    if length < 0 or position < 1:
        return ""
    return text[: position - 1] + text[position - 1 + length :]


def replace(text: str, other: str, length: int, position: int) -> str:
    """REPLACE: `length` characters from the position on become `other`."""
    if length < 0 or position < 1:
        return ""
    return text[: position - 1] + other + text[position - 1 + length :]


def find(text: str, part: str) -> int:
    """FIND: the 1-based position of `part`; 0 if it does not occur or is empty."""
    return text.find(part) + 1 if part else 0


def narrowed(text: str) -> str:
    """Wide characters in eight bits; what has no place there becomes `?`."""
    return "".join(character if character < "\u0100" else "?" for character in text)


def of_real(value: float, digits: int) -> str:
    """A floating point number with `digits` places behind the point and its exponent."""
    if math.isnan(value):
        return "NaN"
    if math.isinf(value):
        return "INF" if value > 0 else "-INF"
    mantissa, exponent = f"{value:.{digits}E}".split("E")
    return f"{mantissa}E{int(exponent):+d}"


def to_whole(text: str, low: int, high: int) -> int:
    """The whole number that a text is."""
    plain = text.strip(" ")
    if _WHOLE.match(plain) and low <= (number := int(plain)) <= high:
        return number
    raise NoNumber(text)


def to_real(text: str) -> float:
    """The floating point number that a text is."""
    plain = text.strip(" ")
    if _REAL.match(plain) and math.isfinite(number := float(plain)):
        return number
    raise NoNumber(text)


def first_character(text: str) -> str:
    """STRING_TO_CHAR."""
    return text[:1] or "\0"


def of_truth(value: bool) -> str:
    """BOOL_TO_STRING."""
    return "TRUE" if value else "FALSE"


def to_truth(text: str) -> bool:
    """STRING_TO_BOOL: TRUE, FALSE, 1 or 0."""
    plain = text.strip(" ").upper()
    if plain in ("TRUE", "1"):
        return True
    if plain in ("FALSE", "0"):
        return False
    raise NoNumber(text)
