"""The data of a running program seen from outside: values, paths, snapshots.

Data is what `model` describes: objects with slots, flat lists, plain Python values.
"""

from collections.abc import Callable, Mapping, Sequence
from operator import attrgetter
from typing import Any

from fbgen.lang.checked import VariableKind
from fbgen.lang.layout import holds_blocks
from fbgen.lang.types import (
    ArrayType,
    BlockType,
    Elementary,
    OpenArrayType,
    ReferenceType,
    Scalar,
    StringType,
    StructType,
    Type,
)
from harness.engine.compiled.data.cells import Cell
from harness.engine.compiled.data.model import Model, Part, Record, is_scalar
from harness.engine.compiled.library.placed import ByteStructure
from harness.engine.compiled.shortening.facts import Facts
from harness.engine.faults import (
    index_out_of_range,
    reference_not_set,
    unknown_name,
    wrong_path,
    wrong_value,
)
from harness.engine.interface import Value
from harness.engine.paths import FOLLOW, Step
from harness.engine.values import accept_scalar


class Location:
    """A variable or a part of one: something to read from and, for single values, to write to.

    `owner` is the object or the list that holds it and `key` its attribute or position there; the
    key is None for what is reached in another way.
    """

    __slots__ = ("_read", "_write", "key", "kind", "owner")

    def __init__(
        self,
        kind: Type,
        read: Callable[[], Any],
        write: Callable[[Any], None],
        owner: object = None,
        key: str | int | None = None,
    ) -> None:
        self.kind = kind
        self.owner = owner
        self.key = key
        self._read = read
        self._write = write

    def read(self) -> Any:
        """The Python object that holds the data."""
        return self._read()

    def write(self, value: Scalar | None) -> None:
        """Set a single value."""
        self._write(value)


class Memory:
    """Reads and writes the data of one program."""

    __slots__ = ("_facts", "_getters", "_model", "namespace")

    def __init__(self, model: Model, facts: Facts, namespace: Mapping[str, Any]) -> None:
        self._model = model
        self._facts = facts
        self.namespace = namespace
        self._getters: dict[Record, Callable[[object], Any]] = {}

    # --- values -------------------------------------------------------------------------------

    def export(self, kind: Type, data: Any) -> Value:
        """A copy of the data in the shape that `interface.Value` describes."""
        if isinstance(kind, ArrayType):
            if is_scalar(kind.element) and not isinstance(kind.element, ReferenceType):
                return list(data)
            return [self.export(kind.element, element) for element in data]
        if isinstance(kind, ReferenceType):
            return data is not None
        if isinstance(kind, OpenArrayType):
            return self.export(ArrayType(data.bounds, kind.element), data.elements)
        if isinstance(kind, StructType | BlockType):
            record = self._model.record_of(kind)
            if record.block is None:
                return {
                    part.name: getattr(data, part.slot)
                    if isinstance(part.type, Elementary | StringType)
                    else self.export(part.type, getattr(data, part.slot))
                    for part in record.parts
                }
            return {
                part.name: self.export(part.type, self.location(data, part).read())
                for part in record.parts
                if part.kind is not VariableKind.IN_OUT or hasattr(data, part.slot)
            }
        value: Scalar = data
        return value

    def load(self, path: str, location: Location, value: Value) -> None:
        """Set a variable from a value; parts of a structure that are not named stay."""
        kind = location.kind
        if is_scalar(kind):
            accepted = accept_scalar(path, kind, value)
            location.write(None if isinstance(kind, ReferenceType) and not accepted else accepted)
        else:
            self.fill(path, kind, location.read(), value)

    def fill(self, path: str, kind: Type, data: Any, value: Value) -> None:
        """Set a structure or an array in place."""
        if isinstance(kind, OpenArrayType):
            kind, data = ArrayType(data.bounds, kind.element), data.elements
        if isinstance(kind, ArrayType):
            if not isinstance(value, Sequence) or isinstance(value, str | bytes):
                raise wrong_value(path, value, kind, "it is a sequence of the elements")
            if len(value) != kind.count:
                raise wrong_value(path, value, kind, f"it has {kind.count} elements")
            if is_scalar(kind.element):
                data[:] = [
                    accept_scalar(f"{path}[{number}]", kind.element, element)
                    for number, element in enumerate(value)
                ]
            else:
                for number, element in enumerate(value):
                    self.fill(f"{path}[{number}]", kind.element, data[number], element)
            return
        assert isinstance(kind, StructType | BlockType)
        if not isinstance(value, Mapping):
            raise wrong_value(path, value, kind, "it is a mapping of names to values")
        record = self._model.record_of(kind)
        for name, part_value in value.items():
            part = self._part(record, name)
            if not _stays(record, data, part, part_value):
                self.load(f"{path}.{name}", self.location(data, part), part_value)

    # --- paths --------------------------------------------------------------------------------

    def location(self, owner: Any, part: Part) -> Location:
        """Where a part of a record is."""
        slot = part.slot
        if part.kind is VariableKind.IN_OUT and part.variable in self._facts.cells:
            cell: Cell | None = getattr(owner, slot, None)

            def read() -> Scalar:
                if cell is None:
                    raise reference_not_set(None, part.name)
                return cell.value

            def write(value: Scalar) -> None:
                if cell is None:
                    raise reference_not_set(None, part.name)
                cell.value = value

            return Location(part.type, read, write)

        def read_slot() -> Any:
            try:
                return getattr(owner, slot)
            except AttributeError:
                raise reference_not_set(None, part.name) from None

        def write_slot(value: Any) -> None:
            setattr(owner, slot, value)

        return Location(part.type, read_slot, write_slot, owner, slot)

    def find(self, path: str, location: Location, steps: Sequence[Step]) -> Location:
        """The part of a variable that the rest of a path leads to."""
        for step in steps:
            if step == FOLLOW:
                location = _followed(path, location)
            elif isinstance(step, tuple):
                location = self._element(path, location, step)
            elif isinstance(location.kind, StructType | BlockType):
                record = self._model.record_of(location.kind)
                location = self.location(location.read(), self._part(record, step))
            else:
                raise wrong_path(path, f"{location.kind} has no part '{step}'")
        return location

    def find_in(self, path: str, owner: Any, record: Record, steps: Sequence[Step]) -> Location:
        """The variable of an instance, or the part of it, that a path leads to."""
        first = steps[0]
        if isinstance(first, tuple):
            raise wrong_path(path, "it starts with an index")
        return self.find(path, self.location(owner, self._part(record, first)), steps[1:])

    def _part(self, record: Record, name: str) -> Part:
        part = record.part(name) if isinstance(name, str) else None
        if part is None:
            raise unknown_name("variable", str(name), [known.name for known in record.parts])
        return part

    def _element(self, path: str, location: Location, indices: tuple[int, ...]) -> Location:
        kind = location.kind
        elements = location.read()
        if isinstance(kind, OpenArrayType):
            kind, elements = ArrayType(elements.bounds, kind.element), elements.elements
        if not isinstance(kind, ArrayType):
            raise wrong_path(path, f"{kind} has no elements")
        if len(indices) != len(kind.bounds):
            raise wrong_path(path, f"{kind} needs {len(kind.bounds)} indices")
        position = 0
        for dimension, (index, (first, last)) in enumerate(
            zip(indices, kind.bounds, strict=True), 1
        ):
            if not first <= index <= last:
                raise index_out_of_range(None, index, first, last, dimension)
            position = position * (last - first + 1) + index - first
        return Location(
            kind.element,
            lambda: elements[position],
            lambda value: elements.__setitem__(position, value),
            elements,
            position,
        )

    # --- snapshots ----------------------------------------------------------------------------

    def snapshot(self, record: Record, owner: object) -> tuple[object, ...]:
        """All that a record remembers, without what its in-outs refer to."""
        kept = _kept(record)
        getter = self._getters.get(record)
        if getter is None:
            slots = [part.slot for part in kept if is_scalar(part.type)] + list(record.hidden)
            if not slots:
                getter = lambda _: ()  # noqa: E731  # an attrgetter needs a name
            else:
                getter = attrgetter(*slots)
            self._getters[record] = getter
        composite = tuple(
            self._snapshot(part.type, getattr(owner, part.slot))
            for part in kept
            if not is_scalar(part.type)
        )
        if record.size:
            return (getter(owner), *composite, _bytes_of(record, owner))
        return (getter(owner), *composite)

    def _snapshot(self, kind: Type, data: Any) -> object:
        if isinstance(data, ByteStructure):
            return data.read()
        if isinstance(kind, ArrayType):
            if is_scalar(kind.element):
                return tuple(data)
            return tuple(self._snapshot(kind.element, element) for element in data)
        assert isinstance(kind, StructType | BlockType)
        return self.snapshot(self._model.record_of(kind), data)

    def restore(self, record: Record, owner: object, state: Any, *, remanent_too: bool) -> None:
        """Go back to a snapshot; remanent variables stay unless `remanent_too`."""
        kept = _kept(record)
        slots = [part.slot for part in kept if is_scalar(part.type)] + list(record.hidden)
        values = state[0] if len(slots) != 1 else (state[0],)
        stays = {part.slot for part in kept if part.remanent and not remanent_too}
        for slot, value in zip(slots, values, strict=True):
            if slot not in stays:
                setattr(owner, slot, value)
        if record.size:
            self._restore_bytes(record, owner, state[-1], remanent_too)
            state = state[:-1]
        composite = [part for part in kept if not is_scalar(part.type)]
        for part, content in zip(composite, state[1:], strict=True):
            if part.slot not in stays:
                data = getattr(owner, part.slot)
                self._restore(part.type, data, content, remanent_too)

    def _restore_bytes(self, record: Record, owner: Any, data: bytes, remanent_too: bool) -> None:
        """The bytes of an instance; remanent variables among them stay unless `remanent_too`."""
        stays = [
            (part, self.export(part.type, getattr(owner, part.slot)))
            for part in record.parts
            if part.bit is not None and part.remanent and not remanent_too
        ]
        start = owner._at >> 3
        owner._memory[start : start + len(data)] = data
        for part, value in stays:
            self.load(part.name, self.location(owner, part), value)

    def _restore(self, kind: Type, data: Any, state: Any, remanent_too: bool) -> None:
        if isinstance(data, ByteStructure):
            data.write(state)
            return
        if isinstance(kind, ArrayType):
            if is_scalar(kind.element):
                data[:] = state
            else:
                for element, content in zip(data, state, strict=True):
                    self._restore(kind.element, element, content, remanent_too)
            return
        assert isinstance(kind, StructType | BlockType)
        record = self._model.record_of(kind)
        self.restore(record, data, state, remanent_too=remanent_too)


def _stays(record: Record, owner: object, part: Part, value: Value) -> bool:
    """Whether a part of a structure holds this very value, which then was accepted before."""
    return value is not None and record.block is None and getattr(owner, part.slot) is value


def _kept(record: Record) -> list[Part]:
    """The parts that a snapshot has one by one: not what others connect, and not the bytes."""
    return [
        part
        for part in record.parts
        if part.kind is not VariableKind.IN_OUT
        and (part.bit is None or part.kind is VariableKind.GLOBAL or holds_blocks(part.type))
    ]


def _bytes_of(record: Record, owner: Any) -> bytes:
    start = owner._at >> 3
    return bytes(owner._memory[start : start + record.size])


def _followed(path: str, location: Location) -> Location:
    """What a reference refers to."""
    kind, reference = location.kind, location.read()
    if not isinstance(kind, ReferenceType) or reference is None:
        raise wrong_path(path, "there is no reference in front of ^, or it refers to nothing")
    if not is_scalar(kind.target):
        return Location(kind.target, lambda: reference, lambda _: None)
    return Location(
        kind.target, lambda: reference.value, lambda value: setattr(reference, "value", value)
    )
