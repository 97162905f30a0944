"""STRG_VAL, VAL_STRG, Strg_TO_Chars, Chars_TO_Strg, ATH and HTA.

Source: TIA Portal help, "String + Char".
"""

import re
from collections.abc import Callable, Mapping
from decimal import ROUND_HALF_EVEN, Context
from math import isfinite
from typing import Any

from fbgen.lang.types import ArrayType, Elementary, Family, StringType, Type
from harness.engine.compiled.library.reals import rounded

_PLAIN = re.compile(r" *([-+.,0-9]*)")
_SCIENTIFIC = re.compile(r" *([-+.,0-9eE]*)")
_START = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_EXACT = Context(prec=1200, rounding=ROUND_HALF_EVEN, Emax=999_999, Emin=-999_999)
_WRONG_DIGIT = 0x0007
_TOO_SHORT = 0x8182
_EXPONENTS = 400

Inputs = Mapping[str, Any]
Kinds = Mapping[str, Type]
Results = Mapping[str, Any]


def _string_to_value(inputs: Inputs, kinds: Kinds) -> Results:
    kind = kinds["OUT"]
    assert isinstance(kind, Elementary)
    text = _number_text(inputs["IN"], inputs["FORMAT"], inputs["P"])
    if text is None:
        return {"out": 0, "eno": False}
    if kind.family is Family.REAL:
        number = float(text)
        held = rounded(number) if kind.bits == 32 else number
        return {"out": number, "eno": True} if isfinite(held) else {"out": 0.0, "eno": False}
    whole = int(_EXACT.create_decimal(text))
    if whole < kind.minimum or whole > kind.maximum:
        return {"out": 0, "eno": False}
    return {"out": whole, "eno": True}


def _number_text(text: str, form: int, position: int) -> str | None:
    """The number that stands at the position, as Python writes it."""
    if position < 1:
        return None
    found = (_SCIENTIFIC if form & 2 else _PLAIN).match(text, position - 1)
    run = found[1] if found is not None else ""
    decimal = "," if form & 1 else "."
    whole, point, rest = run.partition(decimal)
    whole = whole.replace("." if form & 1 else ",", "")
    match = _START.match(whole + ("." if point else "") + rest)
    if match is None:
        return None
    exponent = re.search(r"[eE](.*)", match[0])
    return None if exponent and abs(int(exponent[1])) > _EXPONENTS else match[0]


def _value_to_string(inputs: Inputs, kinds: Kinds) -> Results:
    kind = kinds["OUT"]
    assert isinstance(kind, StringType)
    value, size, position, old = inputs["IN"], inputs["SIZE"], inputs["P"], inputs["OUT"]
    if isinstance(value, float) and not isfinite(value):
        return {"eno": False}
    digits = _digits(value, inputs["PREC"], inputs["FORMAT"])
    start = position - 1
    if len(digits) > size or not 0 <= start <= len(old) or start + size > kind.length:
        return {"eno": False}
    return {"out": f"{old[:start]}{digits:>{size}}{old[start + size :]}"}


def _digits(value: float, precision: int, form: int) -> str:
    sign = "+" if form & 4 else ""
    if isinstance(value, int):
        # A sign that Python would give to a zero before the point is given here.
        shown = f"{abs(value):0{precision + 1}}"
        if precision:
            shown = f"{shown[:-precision]}.{shown[-precision:]}"
        shown = ("-" if value < 0 else sign) + shown
    elif form & 2:
        mantissa, power = f"{value:{sign}.{precision}e}".split("e")
        shown = f"{mantissa}E{int(power):+d}"
    else:
        shown = f"{value:{sign}.{precision}f}"
    return shown.replace(".", ",") if form & 1 else shown


# --- arrays of characters -----------------------------------------------------------------------


def _string_to_characters(inputs: Inputs, kinds: Kinds) -> Results:
    text, start = inputs["STRG"], inputs["PCHARS"]
    kind, given = kinds["CHARS"], inputs["CHARS"]
    array = list(given) if isinstance(kind, ArrayType) else [given]
    element = kind.element if isinstance(kind, ArrayType) else kind
    assert isinstance(element, Elementary)
    if not 0 <= start <= len(array):
        return {"cnt": 0}
    mask = (1 << element.bits) - 1
    is_text = element.family is Family.CHAR
    new = [chr(ord(one) & mask) if is_text else ord(one) & mask for one in text]
    new = new[: len(array) - start]
    return {"chars": array[:start] + new + array[start + len(new) :], "cnt": len(new)}


def _characters_to_string(inputs: Inputs, kinds: Kinds) -> Results:
    given = inputs["CHARS"]
    array = given if isinstance(kinds["CHARS"], ArrayType) else [given]
    start, count = inputs["PCHARS"], inputs["CNT"]
    if start < 0:
        return {"strg": ""}
    text = ""
    for one in array[start:][: count or None]:
        if one in ("\0", 0):
            break
        text += one if isinstance(one, str) else chr(one)
    return {"strg": text}


# --- hexadecimal --------------------------------------------------------------------------------


def _size(kind: Type) -> int:
    """The bytes of a type that these functions fill; -1 for another one."""
    match kind:
        case StringType():
            return -1 if kind.wide else kind.length
        case ArrayType():
            one = _size(kind.element) if isinstance(kind.element, Elementary) else -1
            return -1 if one < 0 else one * kind.count
        case Elementary():
            usable = kind.family not in (Family.REAL, Family.BOOL)
            return kind.bits // 8 if usable else -1
        case _:
            return -1


def _pack(value: Any, kind: Type) -> bytes:
    if isinstance(kind, ArrayType):
        return bytes(octet for one in value for octet in _pack(one, kind.element))
    if isinstance(value, str):
        return bytes(ord(one) if ord(one) < 256 else ord("?") for one in value)
    assert isinstance(kind, Elementary)
    return bytes((value >> shift) & 255 for shift in range(kind.bits - 8, -1, -8))


def _unpack(data: bytes, kind: Type) -> Any:
    if isinstance(kind, StringType):
        return "".join(map(chr, data))
    if isinstance(kind, ArrayType):
        step = len(data) // kind.count
        return [_unpack(data[at : at + step], kind.element) for at in range(0, len(data), step)]
    assert isinstance(kind, Elementary)
    number = 0
    for octet in data:
        number = number << 8 | octet
    if kind.family is Family.CHAR:
        return chr(number)
    return number - (1 << kind.bits) if kind.is_signed and number > kind.maximum else number


def _put(inputs: Inputs, kinds: Kinds, data: bytes, status: int) -> Results:
    kind = kinds["OUT"]
    if _size(kind) < len(data):
        return {"ret_val": _TOO_SHORT}
    rest = b"" if isinstance(kind, StringType) else _pack(inputs["OUT"], kind)[len(data) :]
    return {"out": _unpack(data + rest, kind), "ret_val": status}


def _from_digits(inputs: Inputs, kinds: Kinds) -> Results:
    count = max(inputs["N"], 0)
    if _size(kinds["IN"]) < 0:
        return {"ret_val": _TOO_SHORT}
    given = _pack(inputs["IN"], kinds["IN"])[:count]
    status = 0 if len(given) == count else _WRONG_DIGIT
    number = 0
    for octet in given:
        digit = "0123456789ABCDEF".find(chr(octet).upper()) if octet < 128 else -1
        if digit < 0:
            digit, status = 0, _WRONG_DIGIT
        number = number << 4 | digit
    if len(given) % 2:
        number <<= 4
    return _put(inputs, kinds, number.to_bytes((len(given) + 1) // 2, "big"), status)


def _to_digits(inputs: Inputs, kinds: Kinds) -> Results:
    if _size(kinds["IN"]) < 0:
        return {"ret_val": _TOO_SHORT}
    given, count = _pack(inputs["IN"], kinds["IN"]), inputs["N"]
    if not 0 <= count <= len(given):
        return {"ret_val": _TOO_SHORT}
    text = "".join(f"{octet:02X}" for octet in given[:count])
    return _put(inputs, kinds, bytes(map(ord, text)), 0)


CALCULATIONS: dict[str, Callable[[Inputs, Kinds], Results]] = {
    "STRG_VAL": _string_to_value,
    "VAL_STRG": _value_to_string,
    "STRG_TO_CHARS": _string_to_characters,
    "CHARS_TO_STRG": _characters_to_string,
    "ATH": _from_digits,
    "HTA": _to_digits,
}
"""By canonical name."""
