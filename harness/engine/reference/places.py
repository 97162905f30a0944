"""Places in the program to storages: variables, parts, elements, slices, absolute addresses."""

from collections.abc import Callable, Mapping

from fbgen.lang.checked import (
    AddressRef,
    Dereference,
    Expression,
    FieldRef,
    IndexRef,
    MemoryRef,
    Place,
    SliceRef,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.layout import no_layout
from fbgen.lang.types import Elementary, Family
from fbgen.source import Span
from harness.engine.faults import index_out_of_range, null_reference, reference_not_set
from harness.engine.interface import State, Value
from harness.engine.reference.addresses import Addresses
from harness.engine.reference.frames import Frame
from harness.engine.reference.memory import Memory, MemoryCell
from harness.engine.reference.pointers import Pointed
from harness.engine.reference.standard_blocks import update_timer
from harness.engine.reference.storage import Array, InstanceStorage, Storage, Structure


class SliceStorage(Storage):
    """Some bits of a whole number or bit string."""

    __slots__ = ("_base", "_kind", "_shift")

    def __init__(self, base: Storage, kind: Elementary, index: int) -> None:
        self._base = base
        self._kind = kind
        self._shift = index * kind.bits

    @property
    def kind(self) -> Elementary:
        """The type of the part."""
        return self._kind

    def read(self) -> Value:
        """The bits as a value of the part's type."""
        part = self._whole() >> self._shift & ((1 << self._kind.bits) - 1)
        return bool(part) if self._kind.family is Family.BOOL else part

    def write(self, value: Value) -> None:
        """Replace the bits; the others stay."""
        assert isinstance(value, int)
        base = self._base.kind
        assert isinstance(base, Elementary)
        mask = ((1 << self._kind.bits) - 1) << self._shift
        pattern = self._whole() & ((1 << base.bits) - 1) & ~mask | int(value) << self._shift
        signed = base.is_signed and pattern > base.maximum
        self._base.write(pattern - (1 << base.bits) if signed else pattern)

    def snapshot(self) -> State:
        """The bits belong to the variable around them."""
        return None

    def restore(self, state: State) -> None:
        """The bits belong to the variable around them."""

    def _whole(self) -> int:
        whole = self._base.read()
        assert isinstance(whole, int)
        return whole


_FOLLOWING = ("q", "et")
"""What a timer shows of the time that has passed."""


class Places:
    """Finds the storage that a place means at this moment."""

    __slots__ = ("_addresses", "_globals", "_index", "_memory")

    def __init__(
        self,
        memory: Memory,
        addresses: Addresses,
        program_globals: Mapping[Variable, Storage],
        index: Callable[[Expression, Frame], int],
    ) -> None:
        self._memory = memory
        self._addresses = addresses
        self._globals = program_globals
        self._index = index

    @property
    def addresses(self) -> Addresses:
        """Where absolute addresses lead."""
        return self._addresses

    def find(self, place: Place, frame: Frame) -> Storage:
        """The storage behind a place. Raises FB6002 and FB6012."""
        match place:
            case VariableRef():
                if place.variable.kind is VariableKind.GLOBAL:
                    return self._globals[place.variable]
                if place.variable.kind is VariableKind.THIS:
                    assert frame.instance is not None
                    return frame.instance
                return frame.find(place.variable, place.span)
            case FieldRef():
                return self._part(self.find(place.base, frame), place)
            case IndexRef():
                return self._element(self.find(place.base, frame), place, frame)
            case SliceRef():
                return SliceStorage(self.find(place.base, frame), place.type, place.index)
            case Dereference():
                pointed = self.find(place.base, frame).read()
                assert isinstance(pointed, Pointed)
                target = pointed.find(place.span)
                if target is None:
                    raise null_reference(place.span)
                return target
            case AddressRef():
                return MemoryCell(place.type, place.address, self._memory, place.span)
            case MemoryRef():
                return self._addresses.find(place, frame)

    def _part(self, base: Storage, place: FieldRef) -> Storage:
        key = place.name.casefold()
        if isinstance(base, Structure):
            return base.parts[key]
        assert isinstance(base, InstanceStorage)
        if base.standard is not None and key in _FOLLOWING:
            update_timer(base, self._memory.environment.now_ns)
        if key not in base.parts and key not in base.connections:
            raise reference_not_set(place.span, place.name)
        return base.part(key)

    def _element(self, base: Storage, place: IndexRef, frame: Frame) -> Storage:
        array, position = self._position(base, place, frame)
        return array.elements[position]

    def elements_from(self, place: IndexRef, frame: Frame) -> list[Storage]:
        """An element of an array and those behind it. Raises FB6002 and FB6012."""
        array, position = self._position(self.find(place.base, frame), place, frame)
        return array.elements[position:]

    def _position(self, base: Storage, place: IndexRef, frame: Frame) -> tuple[Array, int]:
        if not isinstance(base, Array):
            raise no_layout(place.span, base.kind)
        indices = [self._index(index, frame) for index in place.indices]
        return base, flat_index(base.kind.bounds, indices, place.span)


def flat_index(
    bounds: tuple[tuple[int, int], ...], indices: "list[int] | tuple[int, ...]", span: Span | None
) -> int:
    """Where an element lies, the last index fastest. Raises FB6002."""
    position = 0
    for dimension, (index, (first, last)) in enumerate(zip(indices, bounds, strict=True), start=1):
        if not first <= index <= last:
            raise index_out_of_range(span, index, first, last, dimension)
        position = position * (last - first + 1) + index - first
    return position
