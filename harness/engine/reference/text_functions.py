"""Standard functions on texts, and numbers to text and back.

Positions count from 1. The caller cuts a result to the room of its type. What lies outside of the
text is as on S7: a negative length or a position before the text gives the empty text.
Sources: IEC 61131-3 third edition, table 34; TIA Portal help, "Character string"; the form of
floating-point texts after the examples of S_CONV in the S7-1200 manual (`9.123456E+3`).
"""

import math
import re
from collections.abc import Sequence

from fbgen.lang.types import Elementary, Family, Scalar
from harness.engine.faults import not_a_number
from harness.engine.reference.arithmetic import rounded
from harness.engine.reference.functions import Function, Signature
from harness.engine.reference.time_texts import TIME_TEXTS

_WHOLE_NUMBER = re.compile(r"[+-]?[0-9]+")
_REAL_NUMBER = re.compile(r"[+-]?[0-9]+(\.[0-9]*)?([eE][+-]?[0-9]+)?")
_TRUTHS = {"TRUE": True, "FALSE": False, "1": True, "0": False}
_DIGITS = {32: 6, 64: 14}


def _text(value: Scalar) -> str:
    assert isinstance(value, str)
    return value


def _count(value: Scalar) -> int:
    assert isinstance(value, int)
    return value


def _length(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return len(_text(values[0]))


def _left(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return _text(values[0])[: max(_count(values[1]), 0)]


def _right(values: Sequence[Scalar], signature: Signature) -> Scalar:
    text, length = _text(values[0]), max(_count(values[1]), 0)
    return text[max(len(text) - length, 0) :]


def _middle(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """MID(IN, L, P)."""
    text, length, position = _text(values[0]), _count(values[1]), _count(values[2])
    if position < 1 or length < 0:
        return ""
    return text[position - 1 : position - 1 + length]


def _concatenate(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return "".join(_text(value) for value in values)


def _insert(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """INSERT(IN1, IN2, P): IN2 behind the P-th character of IN1."""
    text, part, position = _text(values[0]), _text(values[1]), _count(values[2])
    return "" if position < 0 else text[:position] + part + text[position:]


def _delete(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """DELETE(IN, L, P)."""
    text, length, position = _text(values[0]), _count(values[1]), _count(values[2])
    if position < 1 or length < 0:
        return ""
    return text[: position - 1] + text[position - 1 + length :]


def _replace(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """REPLACE(IN1, IN2, L, P)."""
    text, part = _text(values[0]), _text(values[1])
    length, position = _count(values[2]), _count(values[3])
    if position < 1 or length < 0:
        return ""
    return text[: position - 1] + part + text[position - 1 + length :]


def _find(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """FIND(IN1, IN2): where IN2 begins in IN1; 0 if nowhere or if IN2 is empty."""
    text, part = _text(values[0]), _text(values[1])
    return text.find(part) + 1 if part else 0


def _first_character(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """STRING_TO_CHAR: the first character, or character 0 of an empty text."""
    return _text(values[0])[:1] or "\0"


def _number_to_text(values: Sequence[Scalar], signature: Signature) -> Scalar:
    number = values[0]
    if isinstance(number, bool):
        return "TRUE" if number else "FALSE"
    if not isinstance(number, float):
        return str(number)
    if math.isnan(number):
        return "NaN"
    if math.isinf(number):
        return "INF" if number > 0 else "-INF"
    mantissa, _, exponent = f"{number:.{_DIGITS[signature.number.bits]}E}".partition("E")
    return f"{mantissa}E{int(exponent):+d}"


def _text_to_number(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """The whole text must be a number in the range of the type. Raises FB6007."""
    text, target = _text(values[0]).strip(" "), signature.result
    assert isinstance(target, Elementary)
    if target.family is Family.BOOL:
        if text.upper() in _TRUTHS:
            return _TRUTHS[text.upper()]
        raise not_a_number(signature.span, _text(values[0]), target)
    if target.family is Family.REAL:
        if _REAL_NUMBER.fullmatch(text):
            real = rounded(target, float(text))
            if math.isfinite(real):
                return real
    elif _WHOLE_NUMBER.fullmatch(text):
        number = int(text)
        if target.minimum <= number <= target.maximum:
            return number
    raise not_a_number(signature.span, _text(values[0]), target)


_NUMBERS = (
    *("SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT", "REAL", "LREAL"),
    *("BOOL", "BYTE", "WORD", "DWORD", "LWORD"),
)

TEXT_FUNCTIONS: dict[str, Function] = {
    "LEN": _length,
    "LEFT": _left,
    "RIGHT": _right,
    "MID": _middle,
    "CONCAT": _concatenate,
    "INSERT": _insert,
    "DELETE": _delete,
    "REPLACE": _replace,
    "FIND": _find,
    "STRING_TO_CHAR": _first_character,
    "WSTRING_TO_WCHAR": _first_character,
    **TIME_TEXTS,
    **{f"{kind}_TO_{text}": _number_to_text for kind in _NUMBERS for text in ("STRING", "WSTRING")},
    **{f"{text}_TO_{kind}": _text_to_number for kind in _NUMBERS for text in ("STRING", "WSTRING")},
}
"""By canonical name."""
