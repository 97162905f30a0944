"""Where values live: a tree of storages, with one cell for each scalar.

A place in the program evaluates to a storage; an in-out is bound to the storage of its argument,
which is what "by reference" means. Keys of parts are casefolded names.
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from fbgen.dataclass import dataclass
from fbgen.lang.checked import AnyBlock, Variable
from fbgen.lang.types import ArrayType, Elementary, Scalar, StringType, StructType, Type
from harness.engine.faults import reference_not_set
from harness.engine.interface import State, Value

if TYPE_CHECKING:
    from harness.engine.reference.behaviour import Behaviour


@dataclass(frozen=True, slots=True)
class Stretch:
    """`size` bytes of a memory from byte `start` on."""

    memory: bytearray
    start: int
    size: int

    def read(self) -> bytes:
        """All bytes."""
        return bytes(self.memory[self.start : self.start + self.size])

    def write(self, data: bytes) -> None:
        """The first bytes; what is too much is left out."""
        data = data[: self.size]
        self.memory[self.start : self.start + len(data)] = data


class Storage(ABC):
    """Something that holds a value of a type."""

    __slots__ = ()

    @property
    @abstractmethod
    def kind(self) -> Type:
        """The type of what it holds."""

    @abstractmethod
    def read(self) -> Value:
        """A copy of the value."""

    @abstractmethod
    def write(self, value: Value) -> None:
        """Take over a value of the right type; of a mapping only what it names."""

    @property
    def stretch(self) -> "Stretch | None":
        """The bytes that it lies in; None if it lies in none."""
        return None

    @abstractmethod
    def snapshot(self) -> State:
        """What `restore` needs to bring back the present value."""

    @abstractmethod
    def restore(self, state: State) -> None:
        """Go back to a snapshot of a storage of the same type."""

    def reset(self, fresh: "Storage", warm: bool) -> None:
        """Take over the initial values in `fresh`; a warm start leaves remanent parts alone."""
        self.restore(fresh.snapshot())


class Cell(Storage):
    """A scalar."""

    __slots__ = ("_kind", "_value")

    def __init__(self, kind: Elementary | StringType, value: Scalar) -> None:
        self._kind = kind
        self._value: Scalar = value

    @property
    def kind(self) -> Elementary | StringType:
        """The type of the scalar."""
        return self._kind

    def read(self) -> Scalar:
        """The scalar."""
        return self._value

    def write(self, value: Value) -> None:
        """A text that is too long loses its end."""
        assert isinstance(value, bool | int | float | str)
        if isinstance(self._kind, StringType):
            value = str(value)[: self._kind.length]
        self._value = value

    def snapshot(self) -> State:
        """The scalar itself."""
        return self._value

    def restore(self, state: State) -> None:
        """The scalar itself."""
        assert isinstance(state, bool | int | float | str)
        self._value = state


class Structure(Storage):
    """The parts of a structure, in their order."""

    __slots__ = ("_kind", "_stretch", "parts")

    def __init__(
        self, kind: StructType, parts: dict[str, Storage], stretch: Stretch | None = None
    ) -> None:
        self._kind = kind
        self._stretch = stretch
        self.parts = parts

    @property
    def stretch(self) -> Stretch | None:
        """The bytes that it lies in."""
        return self._stretch

    @property
    def kind(self) -> StructType:
        """The structure's type."""
        return self._kind

    def read(self) -> dict[str, Value]:
        """All parts by their declared names."""
        parts = zip(self._kind.fields, self.parts.values(), strict=True)
        return {field.name: part.read() for field, part in parts}

    def write(self, value: Value) -> None:
        """Only the parts that are named."""
        assert isinstance(value, Mapping)
        for name, part in value.items():
            self.parts[name.casefold()].write(part)

    def snapshot(self) -> State:
        """One snapshot per part."""
        return tuple(part.snapshot() for part in self.parts.values())

    def restore(self, state: State) -> None:
        """One snapshot per part."""
        assert isinstance(state, tuple)
        for part, saved in zip(self.parts.values(), state, strict=True):
            part.restore(saved)

    def reset(self, fresh: Storage, warm: bool) -> None:
        """Part by part."""
        assert isinstance(fresh, Structure)
        for key, part in self.parts.items():
            part.reset(fresh.parts[key], warm)


class UnionValue(dict[str, Value]):
    """The parts of a union with the bytes that they were read from, so that none are lost."""

    def __init__(self, parts: Mapping[str, Value], data: bytes) -> None:
        super().__init__(parts)
        self.data = data


class Union(Structure):
    """A structure whose parts share their bytes."""

    __slots__ = ("_bytes",)

    def __init__(self, kind: StructType, parts: dict[str, Storage], stretch: Stretch) -> None:
        super().__init__(kind, parts, stretch)
        self._bytes = stretch

    def read(self) -> dict[str, Value]:
        """All parts by their declared names."""
        return UnionValue(super().read(), self._bytes.read())

    def write(self, value: Value) -> None:
        """Another union byte by byte; else the parts that are named, one behind the other."""
        if isinstance(value, UnionValue):
            self._bytes.write(value.data)
        else:
            super().write(value)

    def snapshot(self) -> State:
        """The bytes."""
        return self._bytes.read()

    def restore(self, state: State) -> None:
        """The bytes."""
        assert isinstance(state, bytes)
        self._bytes.write(state)

    def reset(self, fresh: Storage, warm: bool) -> None:
        """The bytes."""
        self.restore(fresh.snapshot())


class Array(Storage):
    """The elements of an array, the last index fastest."""

    __slots__ = ("_kind", "_stretch", "elements")

    def __init__(
        self, kind: ArrayType, elements: list[Storage], stretch: Stretch | None = None
    ) -> None:
        self._kind = kind
        self._stretch = stretch
        self.elements = elements

    @property
    def stretch(self) -> Stretch | None:
        """The bytes that it lies in."""
        return self._stretch

    @property
    def kind(self) -> ArrayType:
        """The array's type."""
        return self._kind

    def read(self) -> list[Value]:
        """All elements in flat order."""
        return [element.read() for element in self.elements]

    def write(self, value: Value) -> None:
        """All elements in flat order."""
        assert isinstance(value, Sequence)
        for element, item in zip(self.elements, value, strict=True):
            element.write(item)

    def snapshot(self) -> State:
        """One snapshot per element."""
        return tuple(element.snapshot() for element in self.elements)

    def restore(self, state: State) -> None:
        """One snapshot per element."""
        assert isinstance(state, tuple)
        for element, saved in zip(self.elements, state, strict=True):
            element.restore(saved)

    def reset(self, fresh: Storage, warm: bool) -> None:
        """Element by element."""
        assert isinstance(fresh, Array)
        for element, initial in zip(self.elements, fresh.elements, strict=True):
            element.reset(initial, warm)


class InstanceStorage(Storage):
    """The variables of a function block, PROGRAM or organization block that outlive a call.

    `connections` has the storages that are connected to the in-outs during a call, and copies of
    them behind it; they are not part of the state. `standard` is the memory of a standard block
    that is not visible as a variable, `memory` has the variables that lie in bytes, unless the
    instance lies in a data block itself.
    """

    __slots__ = ("_kind", "_memory", "_variables", "block", "connections", "parts", "standard")

    def __init__(
        self,
        kind: Type,
        block: AnyBlock,
        parts: dict[str, Storage],
        standard: "Behaviour | None",
        memory: bytearray | None = None,
    ) -> None:
        self._kind = kind
        self._memory = memory
        self.block = block
        self.parts = parts
        self.connections: dict[str, Storage] = {}
        self.standard = standard
        self._variables: dict[str, Variable] = {
            variable.name.casefold(): variable for variable in block.variables
        }

    @property
    def kind(self) -> Type:
        """The type of the instance."""
        return self._kind

    def variable(self, key: str) -> Variable | None:
        """The declared variable of a casefolded name."""
        return self._variables.get(key)

    def part(self, key: str) -> Storage:
        """The storage of a variable, for an in-out the connected one. Raises FB6012."""
        if key in self.parts:
            return self.parts[key]
        if key not in self.connections:
            raise reference_not_set(None, self._variables[key].name)
        return self.connections[key]

    def read(self) -> dict[str, Value]:
        """All variables that live on, and what the in-outs are connected to."""
        return {
            variable.name: self.part(key).read()
            for key, variable in self._variables.items()
            if key in self.parts or key in self.connections
        }

    def write(self, value: Value) -> None:
        """Only the variables that are named."""
        assert isinstance(value, Mapping)
        for name, part in value.items():
            self.part(name.casefold()).write(part)

    def snapshot(self) -> State:
        """The variables that live on and the memory of a standard block."""
        saved = tuple(part.snapshot() for part in self.parts.values())
        data = None if self._memory is None else bytes(self._memory)
        return saved, None if self.standard is None else self.standard.snapshot(), data

    def restore(self, state: State) -> None:
        """The variables that live on and the memory of a standard block."""
        assert isinstance(state, tuple)
        saved, standard, data = state
        if self._memory is not None:
            self._memory[:] = data
        for part, part_saved in zip(self.parts.values(), saved, strict=True):
            part.restore(part_saved)
        if self.standard is not None:
            self.standard.restore(standard)

    def reset(self, fresh: Storage, warm: bool) -> None:
        """Variable by variable; a warm start leaves the remanent ones."""
        assert isinstance(fresh, InstanceStorage)
        for key, part in self.parts.items():
            variable = self._variables[key]
            if variable.overlay is None and not (warm and variable.remanent):
                part.reset(fresh.parts[key], warm)
        if self.standard is not None and fresh.standard is not None:
            self.standard.restore(fresh.standard.snapshot())
        self.connections.clear()
