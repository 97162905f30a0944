"""ANY and POINTER that lie in bytes: their value is the bytes, read when they are followed."""

from collections.abc import Callable

from fbgen.lang.types import ReferenceType, Type
from fbgen.source import Span
from harness.engine.area_memories import AreaMemories
from harness.engine.area_pointers import (
    NOWHERE,
    NULL_ANY,
    NULL_POINTER,
    NoAreaError,
    is_null,
)
from harness.engine.faults import no_such_area
from harness.engine.interface import State, Value
from harness.engine.reference.memory import MemoryCell
from harness.engine.reference.placed import ByteCell
from harness.engine.reference.pointers import Pointed
from harness.engine.reference.storage import Array, Storage


class Pointers:
    """Bytes to storages and back, on one controller."""

    __slots__ = ("_memories", "_view")

    def __init__(
        self, memories: AreaMemories, view: Callable[[Type, bytearray, int], Storage]
    ) -> None:
        self._memories = memories
        self._view = view

    def find(self, pattern: bytes, span: Span | None) -> Storage:
        """What a pointer that is not NULL refers to. Raises FB6017."""
        try:
            found = self._memories.find(pattern)
        except NoAreaError as problem:
            raise no_such_area(span, pattern, problem.reason) from None
        return self._view(*found)

    def pattern(self, storage: Storage, is_any: bool) -> bytes:
        """The bytes that refer to a variable."""
        place = _place(storage)
        pointer = NOWHERE if place is None else self._memories.pointer(storage.kind, *place)
        return pointer.any_bytes if is_any else pointer.pointer_bytes


def _place(storage: Storage) -> tuple[bytearray, int] | None:
    if isinstance(storage, ByteCell | MemoryCell | PointerCell):
        return storage.place()
    if isinstance(storage, Array) and storage.elements:
        return _place(storage.elements[0])
    stretch = storage.stretch
    return None if stretch is None else (stretch.memory, 8 * stretch.start)


class PlacedPointed(Pointed):
    """A reference as it was found in memory."""

    pattern: bytes
    _pointers: Pointers

    @classmethod
    def read(cls, pattern: bytes, pointers: Pointers) -> "PlacedPointed":
        """The value of some bytes."""
        self = int.__new__(cls, not is_null(pattern))
        self.pattern = pattern
        self._pointers = pointers
        return self

    def find(self, span: Span | None) -> Storage | None:
        """What the bytes mean. Raises FB6017."""
        return self._pointers.find(self.pattern, span) if self else None


class PointerCell(Storage):
    """An ANY or POINTER at a byte of a memory, which is remembered by whoever it belongs to."""

    __slots__ = ("_kind", "_memory", "_pointers", "_start")

    def __init__(
        self, kind: ReferenceType, pointers: Pointers, memory: bytearray, start: int
    ) -> None:
        self._kind = kind
        self._pointers = pointers
        self._memory = memory
        self._start = start

    @property
    def kind(self) -> ReferenceType:
        """ANY or POINTER."""
        return self._kind

    @property
    def _is_any(self) -> bool:
        return self._kind.keyword == "ANY"

    @property
    def _size(self) -> int:
        return len(NULL_ANY if self._is_any else NULL_POINTER)

    def place(self) -> tuple[bytearray, int]:
        """The memory and the first bit."""
        return self._memory, 8 * self._start

    def read(self) -> Value:
        """What the bytes say."""
        data = bytes(self._memory[self._start : self._start + self._size])
        return PlacedPointed.read(data, self._pointers)

    def write(self, value: Value) -> None:
        """Refer to something else; what comes from other bytes is taken as it stands there."""
        self._memory[self._start : self._start + self._size] = self._pattern(value)

    def _pattern(self, value: Value) -> bytes:
        if isinstance(value, PlacedPointed) and len(value.pattern) == self._size:
            return value.pattern
        target = value.find(None) if isinstance(value, Pointed) else None
        if target is None:
            return NULL_ANY if self._is_any else NULL_POINTER
        return self._pointers.pattern(target, self._is_any)

    def reset(self, fresh: Storage, warm: bool) -> None:
        """The bytes of a fresh cell."""
        self.write(fresh.read())

    def snapshot(self) -> State:
        """The value is in the memory."""
        return None

    def restore(self, state: State) -> None:
        """The value is in the memory."""
