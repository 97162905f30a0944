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
    Enumeration,
    Family,
    OpenArrayType,
    ReferenceType,
    Scalar,
    StringType,
    StructType,
    Subrange,
    Type,
    refers_to_anything,
)
from harness.engine.faults import unknown_name, wrong_value
from harness.engine.interface import Reference, Value

_FAMILIES_OF_NUMBERS = (
    Family.BITS,
    Family.SIGNED,
    Family.UNSIGNED,
    Family.DURATION,
    Family.DATE,
)


def accept(program: Program, path: str, kind: Type, value: object) -> Value:
    """The value as a variable of the type takes it, names as declared. Raises FB6020, FB6021."""
    if isinstance(kind, Elementary):
        return accept_scalar(path, kind, value)
    if isinstance(kind, OpenArrayType):
        kind = array_of(path, kind, value)
        value = _flat(value, len(kind.bounds))
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


def array_of(path: str, kind: OpenArrayType, value: object) -> ArrayType:
    """The array that a value is for an ARRAY[*]: nested sequences, indices from 0. Raises FB6021.

    Without a value there are no elements.
    """
    bounds: list[tuple[int, int]] = []
    rows: list[object] = [value]
    for _ in range(kind.dimensions):
        lengths = set()
        inner: list[object] = []
        for row in rows:
            if isinstance(row, str | bytes) or not isinstance(row, Sequence):
                reason = f"it is sequences nested {kind.dimensions} deep"
                raise wrong_value(path, value, kind, reason)
            lengths.add(len(row))
            inner += row
        if len(lengths) > 1:
            raise wrong_value(path, value, kind, "its rows have different lengths")
        rows = inner
        bounds.append((0, lengths.pop() - 1 if lengths else -1))
    return ArrayType(tuple(bounds), kind.element)


def _flat(value: object, dimensions: int) -> object:
    """The elements of nested sequences."""
    for _ in range(dimensions - 1):
        assert isinstance(value, Sequence)
        value = [element for row in value for element in row]
    return value


def _parts(program: Program, kind: StructType | BlockType) -> dict[str, Type]:
    if isinstance(kind, StructType):
        return {field.name: field.type for field in kind.fields}
    return {variable.name: variable.type for variable in program.block_of(kind.name).variables}


def _accept_reference(path: str, kind: ReferenceType, value: object) -> Scalar:
    if value is False:
        return False
    if not refers_to_anything(kind):
        raise wrong_value(path, value, kind, "only False, which unbinds it, comes from outside")
    if isinstance(value, Reference):
        target: Scalar = value.target
        return target
    raise wrong_value(
        path,
        value,
        kind,
        "hand over program.variant('INT', 5), or program.reference('DB.member') for a variable"
        " of the program",
    )


def accept_scalar(path: str, kind: Type, value: object) -> Scalar:
    """The value as a variable of the type holds it; `path` is for the message. Raises FB6021."""
    if isinstance(kind, StringType):
        return _accept_text(path, kind, value, kind.length, kind.wide)
    if isinstance(kind, ReferenceType):
        return _accept_reference(path, kind, value)
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
    if isinstance(kind, Enumeration) and isinstance(value, str):
        return _accept_name(path, kind, value)
    if kind.family in _FAMILIES_OF_NUMBERS:
        if isinstance(value, bool) or not isinstance(value, int):
            raise wrong_value(path, value, kind, "it is a whole number")
        lowest, highest = kind.minimum, kind.maximum
        if isinstance(kind, Subrange):
            lowest, highest = kind.lowest, kind.highest
        if not lowest <= value <= highest:
            reason = f"it goes from {lowest} to {highest}"
            raise wrong_value(path, value, kind, reason)
        return value
    raise wrong_value(path, value, kind, "it holds nothing")


class Enumerator(int):
    """A value of an enumeration as it reads from outside: a number that knows its `name`.

    The name is "" for a number that no enumerator has.
    """

    name: str

    def __new__(cls, kind: Enumeration, value: int) -> "Enumerator":
        self = super().__new__(cls, value)
        self.name = kind.name_of(value) or ""
        return self

    def __repr__(self) -> str:
        """The number, and the name behind it."""
        return f"{int(self)} ({self.name})" if self.name else str(int(self))


def shown(kind: Type | None, value: Scalar) -> Scalar:
    """A scalar as it reads from outside: enumerators by their names."""
    return Enumerator(kind, int(value)) if isinstance(kind, Enumeration) else value


def _accept_name(path: str, kind: Enumeration, name: str) -> int:
    value = kind.value_of(name.rpartition("#")[2].rpartition(".")[2])
    if value is None:
        known = ", ".join(known for known, _ in kind.members[:12])
        raise wrong_value(path, name, kind, f"its enumerators are {known}")
    return value


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
