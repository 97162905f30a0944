"""Data that lies in bytes, with the faces of data that does not.

A structure has the attributes that its plain class has, an array of single values the items of a
list, a single value is a cell or an attribute. So generated code does not know the difference.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from struct import Struct
from typing import Any, NamedTuple, TypeAlias

from fbgen.lang.types import ArrayType, Elementary, Family, Scalar, Type
from harness.engine.layout import Layout

_STRUCT_LETTERS = {
    (Family.BITS, 8): "B",
    (Family.BITS, 16): "H",
    (Family.BITS, 32): "I",
    (Family.BITS, 64): "Q",
    (Family.UNSIGNED, 8): "B",
    (Family.UNSIGNED, 16): "H",
    (Family.UNSIGNED, 32): "I",
    (Family.UNSIGNED, 64): "Q",
    (Family.SIGNED, 8): "b",
    (Family.SIGNED, 16): "h",
    (Family.SIGNED, 32): "i",
    (Family.SIGNED, 64): "q",
    (Family.DURATION, 32): "i",
    (Family.DURATION, 64): "q",
    (Family.REAL, 32): "f",
    (Family.REAL, 64): "d",
}

Get: TypeAlias = Callable[[bytearray, int], Any]
Set: TypeAlias = Callable[[bytearray, int, Any], None]


class Codec(NamedTuple):
    """How a single value is read at a bit of a memory, and written there."""

    get: Get
    set: Set


def codec(kind: Type, layout: Layout) -> Codec:
    """The codec of an elementary type or a text."""
    if isinstance(kind, Elementary):
        if kind.family is Family.BOOL:
            return _BIT if layout.is_s7 else _BYTE_BOOL
        letter = _STRUCT_LETTERS.get((kind.family, kind.bits))
        if letter is not None:
            return _of_struct(Struct((">" if layout.is_s7 else "<") + letter))

    def get(memory: bytearray, bit: int) -> Any:
        return layout.read(memory, bit, kind)

    def put(memory: bytearray, bit: int, value: Any) -> None:
        layout.write(memory, bit, kind, value)

    return Codec(get, put)


def _of_struct(form: Struct) -> Codec:
    unpack, pack = form.unpack_from, form.pack_into

    def get(memory: bytearray, bit: int) -> Any:
        return unpack(memory, bit >> 3)[0]

    def put(memory: bytearray, bit: int, value: Any) -> None:
        pack(memory, bit >> 3, value)

    return Codec(get, put)


def _get_bit(memory: bytearray, bit: int) -> bool:
    return memory[bit >> 3] >> (bit & 7) & 1 == 1


def _set_bit(memory: bytearray, bit: int, value: object) -> None:
    mask = 1 << (bit & 7)
    if value:
        memory[bit >> 3] |= mask
    else:
        memory[bit >> 3] &= 0xFF ^ mask


def _get_byte_bool(memory: bytearray, bit: int) -> bool:
    return memory[bit >> 3] & 1 == 1


def _set_byte_bool(memory: bytearray, bit: int, value: object) -> None:
    memory[bit >> 3] = 1 if value else 0


_BIT = Codec(_get_bit, _set_bit)
_BYTE_BOOL = Codec(_get_byte_bool, _set_byte_bool)


class ByteCell:
    """A single value."""

    __slots__ = ("_bit", "_codec", "_memory")

    def __init__(self, memory: bytearray, bit: int, way: Codec) -> None:
        self._memory = memory
        self._bit = bit
        self._codec = way

    def place(self) -> tuple[bytearray, int]:
        """The memory and the bit."""
        return self._memory, self._bit

    @property
    def value(self) -> Scalar:
        """The value in the bytes."""
        value: Scalar = self._codec.get(self._memory, self._bit)
        return value

    @value.setter
    def value(self, content: Scalar) -> None:
        self._codec.set(self._memory, self._bit, content)


class ByteArray:
    """An array of single values; `offsets` has the first bit of each behind that of the array."""

    __slots__ = ("_codec", "_first", "_memory", "_offsets", "size")

    def __init__(
        self, memory: bytearray, first: int, offsets: Sequence[int], way: Codec, size: int
    ) -> None:
        self._memory = memory
        self._first = first
        self._offsets = offsets
        self._codec = way
        self.size = size

    def place(self, position: int = 0) -> tuple[bytearray, int]:
        """The memory and the first bit of an element."""
        return self._memory, self._first + self._offsets[position]

    def __len__(self) -> int:
        return len(self._offsets)

    def __iter__(self) -> Iterator[Any]:
        get, memory, first = self._codec.get, self._memory, self._first
        return iter([get(memory, first + offset) for offset in self._offsets])

    def __getitem__(self, index: Any) -> Any:
        """An element, or a list of all of them for `[:]`."""
        if isinstance(index, slice):
            return list(self)
        return self._codec.get(self._memory, self._first + self._offsets[index])

    def __setitem__(self, index: Any, value: Any) -> None:
        """An element, or all of them by `[:]`."""
        if not isinstance(index, slice):
            self._codec.set(self._memory, self._first + self._offsets[index], value)
            return
        put, memory, first = self._codec.set, self._memory, self._first
        # What is copied may be this very memory.
        for offset, element in zip(self._offsets, list(value), strict=True):
            put(memory, first + offset, element)

    def read(self) -> bytes:
        """All bytes."""
        start = self._first >> 3
        return bytes(self._memory[start : start + self.size])

    def write(self, data: bytes) -> None:
        """The first bytes."""
        start = self._first >> 3
        self._memory[start : start + len(data)] = data


class ByteStructure:
    """A structure; classes for each type are made of it.

    `_plain` is the name of the same structure's class outside of bytes, among the `_names`.
    """

    __slots__ = ("_at", "_memory")

    _size: int
    _is_union: bool
    _slots: tuple[tuple[str, Type], ...]
    _plain: str
    _names: Mapping[str, Any]
    _first_bytes: bytes
    _parts: tuple[tuple[str, int, Callable[[bytearray, int], Any]], ...]

    def __init__(self, memory: bytearray | None = None, bit: int = 0) -> None:
        """In a memory from a bit on; without one in a memory of its own, with initial values."""
        self._memory = bytearray(self._first_bytes) if memory is None else memory
        self._at = bit
        for slot, offset, make in self._parts:
            setattr(self, slot, make(self._memory, bit + offset))

    def _assign(self, other: Any) -> None:
        if self._is_union and type(other) is type(self):
            self.write(other.read())
            return
        for slot, kind in self._slots:
            content = getattr(other, slot)
            if not isinstance(kind, ArrayType | Elementary) and hasattr(content, "_assign"):
                getattr(self, slot)._assign(content)
            elif isinstance(kind, ArrayType):
                fill(getattr(self, slot), content)
            else:
                setattr(self, slot, content)

    def _copy(self) -> Any:
        copy = self._names[self._plain]()
        copy._assign(self)
        return copy

    def place(self) -> tuple[bytearray, int]:
        """The memory and the first bit."""
        return self._memory, self._at

    @property
    def size(self) -> int:
        """The length in bytes."""
        return self._size

    def read(self) -> bytes:
        """All bytes."""
        start = self._at >> 3
        return bytes(self._memory[start : start + self._size])

    def write(self, data: bytes) -> None:
        """The first bytes."""
        start = self._at >> 3
        self._memory[start : start + len(data)] = data


def fill(target: Any, source: Any) -> None:
    """Copy an array into another one of the same type."""
    if isinstance(target, ByteArray) or not target or not hasattr(target[0], "_assign"):
        if isinstance(target, list) and target and isinstance(target[0], list | ByteArray):
            for one, two in zip(target, source, strict=True):
                fill(one, two)
        else:
            target[:] = source
        return
    for one, two in zip(target, source, strict=True):
        one._assign(two)


def byte_attribute(way: Codec, bit: int) -> property:
    """A property of an object with `_memory` and `_at`: a single value so many bits behind."""
    get, put = way

    def read(self: Any) -> Any:
        return get(self._memory, self._at + bit)

    def write(self: Any, value: Any) -> None:
        put(self._memory, self._at + bit, value)

    read.__dict__[_BIT_OF] = bit
    return property(read, write)


_BIT_OF = "first_bit"
"""Where the getter of such a property remembers its bit."""


def bit_of_attribute(owner: type, name: str) -> int | None:
    """How far behind the object an attribute of such a class lies; None for any other one."""
    found = getattr(owner, name, None)
    bit: int | None = None
    if isinstance(found, property) and found.fget is not None:
        bit = found.fget.__dict__.get(_BIT_OF)
    return bit
