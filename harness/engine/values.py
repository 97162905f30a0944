"""Values that come from outside: is this Python object a value of that type?

Nothing is converted on the way but whole numbers to floating point, and REAL to 32 bit.
"""

from collections.abc import Mapping, Sequence
from ctypes import c_float

from fbgen.lang.checked import Program
from fbgen.lang.types import (
    AnyType,
    ArrayType,
    BlockType,
    Elementary,
    Family,
    Scalar,
    StringType,
    StructType,
    Type,
)
from harness.engine.faults import unknown_name, wrong_value
from harness.engine.interface import Value

_FAMILIES_OF_NUMBERS = (
    Family.BITS,
    Family.SIGNED,
    Family.UNSIGNED,
    Family.DURATION,
    Family.DATE,
)


def accept(program: Program, path: str, kind: Type, value: object) -> Value:
    """The value as a variable of the type takes it, names as declared. Raises FB6020, FB6021."""
    if isinstance(kind, ArrayType):
        if isinstance(value, str | bytes) or not isinstance(value, Sequence):
            raise wrong_value(path, value, kind, "it is a flat sequence of its elements")
        if len(value) != kind.count:
            raise wrong_value(path, value, kind, f"it has {kind.count} elements")
        return [
            accept(program, f"{path}[{position}]", kind.element, element)
            for position, element in enumerate(value)
        ]
    if isinstance(kind, StructType | BlockType):
        parts = _parts(program, kind)
        if not isinstance(value, Mapping):
            raise wrong_value(path, value, kind, "it is a mapping from names to values")
        by_key = {name.casefold(): name for name in parts}
        accepted: dict[str, Value] = {}
        for given, part in value.items():
            name = by_key.get(str(given).casefold())
            if name is None:
                raise unknown_name(f"part of {path}", str(given), list(parts))
            accepted[name] = accept(program, f"{path}.{name}", parts[name], part)
        return accepted
    if isinstance(kind, AnyType):
        raise wrong_value(path, value, kind, "an area cannot come from outside")
    return accept_scalar(path, kind, value)


def _parts(program: Program, kind: StructType | BlockType) -> dict[str, Type]:
    if isinstance(kind, StructType):
        return {field.name: field.type for field in kind.fields}
    return {variable.name: variable.type for variable in program.block_of(kind.name).variables}


def accept_scalar(path: str, kind: Type, value: object) -> Scalar:
    """The value as a variable of the type holds it; `path` is for the message. Raises FB6021."""
    if isinstance(kind, StringType):
        return _accept_text(path, kind, value, kind.length, kind.wide)
    if not isinstance(kind, Elementary):
        raise wrong_value(path, value, kind, "it has parts, give a mapping or a sequence")
    if kind.family is Family.BOOL:
        if isinstance(value, bool):
            return value
        raise wrong_value(path, value, kind, "it is True or False")
    if kind.family is Family.REAL:
        return _accept_real(path, kind, value)
    if kind.family is Family.CHAR:
        text = _accept_text(path, kind, value, 1, kind.bits == 16)
        if len(text) != 1:
            raise wrong_value(path, value, kind, "it is exactly one character")
        return text
    if kind.family in _FAMILIES_OF_NUMBERS:
        if isinstance(value, bool) or not isinstance(value, int):
            raise wrong_value(path, value, kind, "it is a whole number")
        if not kind.minimum <= value <= kind.maximum:
            reason = f"it goes from {kind.minimum} to {kind.maximum}"
            raise wrong_value(path, value, kind, reason)
        return value
    raise wrong_value(path, value, kind, "it holds nothing")


def _accept_real(path: str, kind: Elementary, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise wrong_value(path, value, kind, "it is a number")
    try:
        number = float(value)
    except OverflowError:
        raise wrong_value(path, value, kind, "it is too large") from None
    return c_float(number).value if kind.bits == 32 else number


def _accept_text(path: str, kind: Type, value: object, length: int, wide: bool) -> str:
    if not isinstance(value, str):
        raise wrong_value(path, value, kind, "it is a text")
    if len(value) > length:
        raise wrong_value(path, value, kind, f"it has room for {length} characters")
    last = 0xFFFF if wide else 0xFF
    if any(ord(character) > last for character in value):
        raise wrong_value(path, value, kind, f"its characters end at 16#{last:X}")
    return value
