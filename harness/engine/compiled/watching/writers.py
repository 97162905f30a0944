"""Who wrote what: the statement that was the last to write each variable, and each output byte.

An entry is the number of a statement and the instance whose code it is, None for a block without
one. It stands beside the variable, in an attribute of the same Python object; where there is no
room for one it stands in a table, which goes by that object. Both tell instances apart.
`write_notes` makes the generated code fill them.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple, TypeAlias

from fbgen.lang.checked import Block, StandardBlock
from fbgen.source import Span
from harness.engine.compiled.data.cells import AttributeCell, ElementCell
from harness.engine.compiled.data.model import BESIDE, Record, is_scalar

Entry: TypeAlias = tuple[int, Any]
"""The number of a statement, and the instance that ran it."""
Shape: TypeAlias = "int | Elements | tuple[tuple[str, Shape], ...]"
"""What there is in some data: one value of so many bytes, an array, or attributes with theirs."""


class Elements(NamedTuple):
    """An array of so shaped elements."""

    shape: "Shape"


class Writing(NamedTuple):
    """A statement that writes, and the block in which it stands."""

    span: Span
    block: Block


_ELEMENTS = "[]"


class Writers:
    """The last writers of one program.

    `statements` are those that entries number. `outputs` has the entry of each byte of the outputs
    by its address, `records` those of the bytes of a module by its LADDR. `instances` are the paths
    of instances by their `id`, once somebody has asked for one. `in_tables` tells that all entries
    stand in tables: some variables of the program lie in bytes.
    """

    __slots__ = (
        "_numbers",
        "_tables",
        "in_tables",
        "instances",
        "outputs",
        "records",
        "statements",
    )

    def __init__(self) -> None:
        self.statements: list[Writing] = []
        self.outputs: dict[int, Entry] = {}
        self.records: dict[int, list[Entry]] = {}
        self.instances: dict[int, str] = {}
        self.in_tables = True
        self._numbers: dict[tuple[int, int, Block], int] = {}
        self._tables: dict[str, dict[Any, Entry]] = {}

    def of(self, owner: object, key: str | int) -> Entry | None:
        """The last writer of an attribute, or of an element of a list; None if nobody wrote it."""
        if isinstance(key, int):
            return self.elements.get((id(owner), key))
        if (beside := self.beside(key)) is not None:
            found: Entry | None = getattr(owner, beside, None)
            return found
        return self.table(key).get(id(owner))

    def forget(self, held: Iterable[tuple[Record, Any]]) -> None:
        """All variables have their initial values again: nobody has written them.

        `held` are the objects that hold them.
        """
        for record, owner in held if not self.in_tables else ():
            for beside in self.room_in(record):
                setattr(owner, beside, None)
        for table in self._tables.values():
            table.clear()
        self.outputs.clear()
        self.records.clear()

    def with_room(
        self, library: Mapping[str, type], blocks: Iterable[StandardBlock]
    ) -> dict[str, type]:
        """The classes of the library, those of these blocks with attributes for entries."""
        room = {
            block.name: tuple(BESIDE + one.name for one in block.variables if is_scalar(one.type))
            for block in blocks
        }
        return {
            name: type(name, (kind,), {"__slots__": room[name]}) if name in room else kind
            for name, kind in library.items()
        }

    # --- for the generated code ---------------------------------------------------------------

    def beside(self, slot: str) -> str | None:
        """The attribute with the entry of this one; None if that stands in a table."""
        return None if self.in_tables else BESIDE + slot

    def room_in(self, record: Record) -> Iterator[str]:
        """The attributes that objects of a record have for entries."""
        for part in record.parts:
            if is_scalar(part.type) and (beside := self.beside(part.slot)) is not None:
                yield beside

    @property
    def names(self) -> dict[str, object]:
        """What the generated code calls, beside the tables."""
        return {
            "_wrote_whole": self.wrote_whole,
            "_wrote_cell": self.wrote_cell,
            "_wrote_elements": self.wrote_elements,
            "_wrote_outputs": self.wrote_outputs,
            "_wrote_record": self.wrote_record,
            "_taken_from": self.taken_from,
        }

    def number(self, span: Span, block: Block) -> int:
        """The number of a statement."""
        key = (span.start, span.end, block)
        number = self._numbers.setdefault(key, len(self.statements))
        if number == len(self.statements):
            self.statements.append(Writing(span, block))
        return number

    def table(self, slot: str) -> dict[Any, Entry]:
        """The entries of what is held in attributes of this name, by the `id` of their objects."""
        return self._tables.setdefault(slot, {})

    @property
    def elements(self) -> dict[Any, Entry]:
        """The entries of elements of arrays, by the `id` of their lists and the position."""
        return self.table(_ELEMENTS)

    def wrote_whole(self, data: Any, shape: Shape, entry: Entry) -> None:
        """A structure, an array or an instance was written, with everything in it."""
        if isinstance(shape, Elements):
            if isinstance(shape.shape, int):
                for position in range(len(data)):
                    self.elements[id(data), position] = entry
            else:
                for element in data:
                    self.wrote_whole(element, shape.shape, entry)
        elif not isinstance(shape, int):
            for slot, inner in shape:
                if isinstance(inner, int):
                    self._note(data, slot, entry)
                else:
                    self.wrote_whole(getattr(data, slot), inner, entry)

    def _note(self, owner: Any, slot: str, entry: Entry) -> None:
        beside = self.beside(slot)
        if beside is None:
            self.table(slot)[id(owner)] = entry
        else:
            setattr(owner, beside, entry)

    def taken_from(self, owner: Any, slot: str) -> Entry | None:
        """The entry of an attribute, which then has none."""
        beside = self.beside(slot)
        if beside is None:
            return self.table(slot).pop(id(owner), None)
        found: Entry | None = getattr(owner, beside, None)
        setattr(owner, beside, None)
        return found

    def wrote_elements(
        self, data: list[Any], position: int, count: int, shape: Shape, entry: Entry
    ) -> None:
        """So many elements of an array were written, from a position on."""
        for number in range(position, min(position + count, len(data))):
            if isinstance(shape, int):
                self.elements[id(data), number] = entry
            else:
                self.wrote_whole(data[number], shape, entry)

    def wrote_cell(self, cell: Any, entry: Entry) -> None:
        """The `value` of an object was written: a field of that name, or what a cell refers to."""
        if isinstance(cell, AttributeCell):
            self._note(cell.owner, cell.name, entry)
        elif isinstance(cell, ElementCell):
            self.elements[id(cell.elements), cell.position] = entry
        else:
            self.table("value")[id(cell)] = entry

    def wrote_outputs(self, byte: int, count: int, entry: Entry) -> None:
        """Bytes of the outputs were written."""
        for number in range(byte, byte + count):
            self.outputs[number] = entry

    def wrote_record(self, laddr: int, data: Any, shape: Shape, entry: Entry) -> None:
        """An area was written to a module: its bytes have the writers of the area's variables."""
        self.records[laddr] = [found or entry for found in self._bytes(data, shape)]

    def _bytes(self, data: Any, shape: Shape) -> Iterator[Entry | None]:
        """The entries of the bytes of an area, which holds no BOOL and no text."""
        if isinstance(shape, Elements):
            for position, element in enumerate(data):
                if isinstance(shape.shape, int):
                    yield from [self.elements.get((id(data), position))] * shape.shape
                else:
                    yield from self._bytes(element, shape.shape)
        elif not isinstance(shape, int):
            for slot, inner in shape:
                if isinstance(inner, int):
                    yield from [self.of(data, slot)] * inner
                else:
                    yield from self._bytes(getattr(data, slot), inner)
