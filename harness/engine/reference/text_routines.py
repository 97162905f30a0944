"""STRG_VAL and VAL_STRG, texts as arrays of characters, and hexadecimal digits.

FORMAT, bit by bit: 0 the decimal sign is a comma, 1 with an exponent, 2 the sign is always shown.
Where the CPU would say ENO = FALSE, a number is 0 and a text stays as it is.
Source: TIA Portal help, "String + Char".
"""

import math
import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from fbgen.lang.types import ArrayType, Elementary, Family, StringType, Type
from harness.engine.interface import Value
from harness.engine.reference.arithmetic import rounded
from harness.engine.reference.routine_operands import Operands

_COMMA, _EXPONENT, _SIGN = 1, 2, 4
_NUMBER = re.compile(r"([+-]?)([0-9]*)(?:\.([0-9]*))?(?:E([+-]?[0-9]+))?")
_NOT_HEXADECIMAL = 7
_NO_ROOM = 0x8182
_LARGEST_EXPONENT = 400

Routine = Callable[[Operands], Mapping[str, Value]]


def _text_to_value(operands: Operands) -> Mapping[str, Value]:
    """STRG_VAL: the number at position P; thousands separators before the decimal sign."""
    number = _number_in(operands)
    kind = operands.kinds["OUT"]
    assert isinstance(kind, Elementary)
    if number is None:
        return {"out": 0, "eno": False}
    if kind.family is Family.REAL:
        try:
            real = rounded(kind, float(number))
        except OverflowError:
            return {"out": 0.0, "eno": False}
        fits = math.isfinite(real)
        return {"out": real if fits else 0.0, "eno": fits}
    whole = math.trunc(number)
    fits = kind.minimum <= whole <= kind.maximum
    return {"out": whole if fits else 0, "eno": fits}


def _number_in(operands: Operands) -> Fraction | None:
    """The exact number that the text begins with behind position P."""
    form, position = operands.whole("FORMAT"), operands.whole("P")
    if position < 1:
        return None
    text = operands.text("IN")[position - 1 :].lstrip(" ")
    decimal, thousands = (",", ".") if form & _COMMA else (".", ",")
    allowed = "+-0123456789.," + ("eE" if form & _EXPONENT else "")
    length = next((n for n, one in enumerate(text) if one not in allowed), len(text))
    before, point, behind = text[:length].upper().partition(decimal)
    match = _NUMBER.match(before.replace(thousands, "") + ("." if point else "") + behind)
    if match is None:
        return None
    sign, whole, fraction, exponent = match.groups()
    digits = whole + (fraction or "")
    power = int(exponent or 0)
    if not digits or abs(power) > _LARGEST_EXPONENT:
        return None
    value = Fraction(f"{digits}E{power - len(fraction or '')}")
    return -value if sign == "-" else value


def _value_to_text(operands: Operands) -> Mapping[str, Value]:
    """VAL_STRG: SIZE characters from position P on, right-justified; the rest of OUT stays."""
    size, position = operands.whole("SIZE"), operands.whole("P")
    form, target = operands.whole("FORMAT"), operands.text("OUT")
    kind = operands.kinds["OUT"]
    assert isinstance(kind, StringType)
    shown = _shown(operands.values["IN"], operands.whole("PREC"), form)
    if shown is None or len(shown) > size:
        return {"eno": False}
    if position < 1 or position > len(target) + 1 or position - 1 + size > kind.length:
        return {"eno": False}
    text = target[: position - 1] + shown.rjust(size) + target[position - 1 + size :]
    return {"out": text}


def _shown(value: Value, precision: int, form: int) -> str | None:
    """A number with `precision` digits behind its point; for a whole number its last digits."""
    if isinstance(value, float):
        if not math.isfinite(value):
            return None
        exact, negative = Fraction(value), math.copysign(1.0, value) < 0
    else:
        assert isinstance(value, int)
        exact, negative = Fraction(value, 10**precision), value < 0
    exact = abs(exact)
    suffix = ""
    if form & _EXPONENT and isinstance(value, float):
        exact, power = _mantissa(exact, precision)
        suffix = f"E{power:+d}"
    digits = str(round(exact * 10**precision)).rjust(precision + 1, "0")
    point = "," if form & _COMMA else "."
    text = digits if precision == 0 else f"{digits[:-precision]}{point}{digits[-precision:]}"
    sign = "-" if negative else "+" if form & _SIGN else ""
    return sign + text + suffix


def _mantissa(exact: Fraction, precision: int) -> tuple[Fraction, int]:
    """The number between 1 and 10, after rounding, and its power of ten."""
    power = 0
    if exact:
        while exact >= 10:
            exact, power = exact / 10, power + 1
        while exact < 1:
            exact, power = exact * 10, power - 1
        if round(exact * 10**precision) >= 10 ** (precision + 1):
            exact, power = exact / 10, power + 1
    return exact, power


# --- characters -------------------------------------------------------------------------------


def _text_to_characters(operands: Operands) -> Mapping[str, Value]:
    """Strg_TO_Chars: from element pChars on, counted from 0, as many as there is room for."""
    text, first = operands.text("STRG"), operands.whole("PCHARS")
    elements, kind = _elements(operands, "CHARS")
    if first < 0 or first > len(elements):
        return {"cnt": 0}
    moved = text[: len(elements) - first]
    for number, character in enumerate(moved):
        elements[first + number] = _as_element(ord(character), kind)
    return {"chars": elements, "cnt": len(moved)}


def _characters_to_text(operands: Operands) -> Mapping[str, Value]:
    """Chars_TO_Strg: Cnt elements, all with Cnt = 0, but not beyond a character 0."""
    first, count = operands.whole("PCHARS"), operands.whole("CNT")
    elements, _ = _elements(operands, "CHARS")
    if first < 0:
        return {"strg": ""}
    codes = [_code(element) for element in elements[first : first + count if count else None]]
    text = "".join(chr(code) for code in codes)
    return {"strg": text.partition("\0")[0]}


def _elements(operands: Operands, name: str) -> tuple[list[Value], Type]:
    """The elements of an array, or a single value as one element, and their type."""
    value, kind = operands.values[name], operands.kinds[name]
    if isinstance(kind, ArrayType):
        assert isinstance(value, Sequence)
        return list(value), kind.element
    return [value], kind


def _code(value: Value) -> int:
    if isinstance(value, str):
        return ord(value)
    assert isinstance(value, int)
    return value


def _as_element(code: int, kind: Type) -> Value:
    assert isinstance(kind, Elementary)
    code &= (1 << kind.bits) - 1
    return chr(code) if kind.family is Family.CHAR else code


# --- hexadecimal digits -----------------------------------------------------------------------


def _octets(value: Value, kind: Type) -> bytes:
    """A text, a number or an array of such as bytes, big endian."""
    if isinstance(value, str):
        return value.encode("latin-1", "replace")
    if isinstance(kind, ArrayType):
        assert isinstance(value, Sequence)
        return b"".join(_octets(element, kind.element) for element in value)
    assert isinstance(kind, Elementary)
    assert isinstance(value, int)
    width = max(kind.bits // 8, 1)
    return (value & ((1 << 8 * width) - 1)).to_bytes(width, "big")


def _from_octets(data: bytes, kind: Type) -> Value:
    if isinstance(kind, StringType):
        return data.decode("latin-1")
    if isinstance(kind, ArrayType):
        width = len(data) // kind.count
        pieces = range(0, width * kind.count, width)
        return [_from_octets(data[start : start + width], kind.element) for start in pieces]
    assert isinstance(kind, Elementary)
    number = int.from_bytes(data, "big", signed=kind.is_signed)
    return chr(number) if kind.family is Family.CHAR else number


def _room(kind: Type) -> int | None:
    """The bytes of a type that this module can fill; None for another one."""
    if isinstance(kind, StringType):
        return None if kind.wide else kind.length
    if isinstance(kind, ArrayType):
        element = _room(kind.element) if isinstance(kind.element, Elementary) else None
        return None if element is None else element * kind.count
    if isinstance(kind, Elementary) and kind.family not in (Family.REAL, Family.BOOL):
        return kind.bits // 8
    return None


def _written(operands: Operands, data: bytes, status: int) -> Mapping[str, Value]:
    """The first bytes of OUT; a text becomes just these, anything else keeps what is behind."""
    value, kind = operands.values["OUT"], operands.kinds["OUT"]
    room = _room(kind)
    if room is None or room < len(data):
        return {"ret_val": _NO_ROOM}
    if not isinstance(kind, StringType):
        data += _octets(value, kind)[len(data) :]
    return {"out": _from_octets(data, kind), "ret_val": status}


def _from_hexadecimal(operands: Operands) -> Mapping[str, Value]:
    """ATH: N digits as half bytes; what is no digit counts as 0 and gives status 7."""
    kind = operands.kinds["IN"]
    if not isinstance(kind, StringType) and _room(kind) is None:
        return {"ret_val": _NO_ROOM}
    count = max(operands.whole("N"), 0)
    given = _octets(operands.values["IN"], kind)
    digits = given[:count].decode("latin-1")
    status = (
        0 if re.fullmatch("[0-9A-Fa-f]*", digits) and len(digits) == count else _NOT_HEXADECIMAL
    )
    halves = [int(one, 16) if one in "0123456789abcdefABCDEF" else 0 for one in digits]
    halves += [0] * (len(halves) % 2)
    data = bytes(high << 4 | low for high, low in zip(halves[::2], halves[1::2], strict=True))
    return _written(operands, data, status)


def _to_hexadecimal(operands: Operands) -> Mapping[str, Value]:
    """HTA: the first N bytes as two digits each."""
    kind = operands.kinds["IN"]
    if not isinstance(kind, StringType) and _room(kind) is None:
        return {"ret_val": _NO_ROOM}
    given = _octets(operands.values["IN"], kind)
    count = operands.whole("N")
    if not 0 <= count <= len(given):
        return {"ret_val": _NO_ROOM}
    return _written(operands, given[:count].hex().upper().encode(), 0)


TEXT_ROUTINES: dict[str, Routine] = {
    "STRG_VAL": _text_to_value,
    "VAL_STRG": _value_to_text,
    "STRG_TO_CHARS": _text_to_characters,
    "CHARS_TO_STRG": _characters_to_text,
    "ATH": _from_hexadecimal,
    "HTA": _to_hexadecimal,
}
"""By canonical name."""
