"""ANY and POINTER that lie in bytes: a VARIANT that looks up what it is bound to when asked."""

from collections.abc import Callable
from typing import Any

from fbgen.lang.types import ReferenceType, Type
from harness.engine.area_memories import AreaMemories
from harness.engine.area_pointers import NOWHERE, NULL_ANY, NULL_POINTER, NoAreaError, is_null
from harness.engine.compiled.data.cells import AttributeCell, ElementCell
from harness.engine.compiled.expressions.bound_variants import Variant
from harness.engine.compiled.library import stops
from harness.engine.compiled.library.placed import (
    ByteArray,
    ByteCell,
    ByteStructure,
    Codec,
    bit_of_attribute,
)


class PlacedVariant(Variant):
    """What stands in some bytes; asking for its type or target may raise stops.NoArea."""

    __slots__ = ("_pointers", "pattern")

    def __init__(self, pattern: bytes, pointers: "Pointers") -> None:
        self.pattern = pattern
        self._pointers = pointers

    @property
    def kind(self) -> Type:  # type: ignore[override]  # worked out, where a Variant keeps it
        """The type of what it means."""
        return self._pointers.bound(self.pattern)[0]

    @property
    def target(self) -> Any:
        """What it means."""
        return self._pointers.bound(self.pattern)[1]


class Pointers:
    """Bytes to VARIANTs and back, on one controller; `view` makes data of what lies in bytes."""

    __slots__ = ("_memories", "_view")

    def __init__(self, memories: AreaMemories, view: Callable[[Type, bytearray, int], Any]) -> None:
        self._memories = memories
        self._view = view

    def codec(self, kind: ReferenceType) -> Codec:
        """How a pointer is read and written."""
        null = NULL_ANY if kind.keyword == "ANY" else NULL_POINTER
        size = len(null)

        def get(memory: bytearray, bit: int) -> Any:
            pattern = bytes(memory[bit >> 3 : (bit >> 3) + size])
            return None if is_null(pattern) else PlacedVariant(pattern, self)

        def put(memory: bytearray, bit: int, value: Variant | None) -> None:
            pattern = null if value is None else self._pattern(value, size)
            memory[bit >> 3 : (bit >> 3) + size] = pattern

        return Codec(get, put)

    def bound(self, pattern: bytes) -> tuple[Type, Any]:
        """The type of what a pointer means, and that itself."""
        try:
            kind, memory, bit = self._memories.find(pattern)
        except NoAreaError as problem:
            raise stops.NoArea(pattern, problem.reason) from None
        return kind, self._view(kind, memory, bit)

    def _pattern(self, value: Variant, size: int) -> bytes:
        if isinstance(value, PlacedVariant) and len(value.pattern) == size:
            return value.pattern
        place = _place(value.target)
        pointer = NOWHERE if place is None else self._memories.pointer(value.kind, *place)
        return pointer.any_bytes if size == len(NULL_ANY) else pointer.pointer_bytes


def _place(target: Any) -> tuple[bytearray, int] | None:
    """The memory and the first bit of what lies in bytes."""
    if isinstance(target, ByteCell | ByteArray | ByteStructure):
        return target.place()
    if isinstance(target, AttributeCell):
        bit = bit_of_attribute(type(target.owner), target.name)
        return None if bit is None else (target.owner._memory, target.owner._at + bit)
    if isinstance(target, ElementCell):
        elements: Any = target.elements
        return elements.place(target.position) if isinstance(elements, ByteArray) else None
    if isinstance(target, list) and target:
        return _place(target[0])
    return None
