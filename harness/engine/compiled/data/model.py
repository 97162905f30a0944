"""How the parts of a checked program are called in Python, and which classes hold its data.

Structures and blocks with a memory become slotted classes, arrays flat lists with the last index
fastest, everything else a plain Python object. Composite global variables have a module-level name
of their own, which is never bound anew; the others are attributes of one object.
"""

from collections.abc import Mapping
from dataclasses import replace

from fbgen.dataclass import dataclass
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import AnyBlock, Block, Program, StandardBlock, Variable, VariableKind
from fbgen.lang.types import (
    ArrayType,
    BlockType,
    Elementary,
    Initial,
    ReferenceType,
    StringType,
    StructType,
    Type,
)
from harness.engine.block_memory import BlockLayout
from harness.engine.compiled.data.names import Names
from harness.engine.compiled.library.timers import FOLLOWING, METHODS
from harness.engine.layout import layout_of

GLOBALS = "_globals"
"""The object with the global variables that are single values."""

BESIDE = "_by_"
"""In front of the name of an attribute: the one in which stands who wrote it."""
STUB_SLOT = "_stub"
"""The slot with the Python object of a stubbed block, which is no part of the program's state."""

MEMORY_KINDS = (BlockKind.FUNCTION_BLOCK, BlockKind.PROGRAM)
"""The kinds of block that keep their variables."""


def is_scalar(kind: Type) -> bool:
    """True for values that are one Python object, which nothing can change in place.

    A reference is one, too: None, the object that it refers to, or a cell for a single value.
    """
    return isinstance(kind, Elementary | StringType | ReferenceType)


def has_memory(block: Block) -> bool:
    """True for function blocks and programs."""
    return block.kind in MEMORY_KINDS


def bytes_name(part: "Part") -> str:
    """The name that the bytes of a data block have until they are bound to the block's own."""
    return f"_bytes_of_{part.slot}"


def may_be_unconnected(variable: Variable, block: Block) -> bool:
    """True for an in-out that the block may find unconnected: nobody calls a PROGRAM with one."""
    return variable.kind is VariableKind.IN_OUT and block.kind is BlockKind.PROGRAM


@dataclass(frozen=True, slots=True)
class Part:
    """One attribute of a record: a field of a structure or a variable of a block.

    `bit` is where it lies in the bytes of its instance, or of its own if it is global.
    """

    name: str
    slot: str
    type: Type
    initial: Initial | None
    remanent: bool = False
    variable: Variable | None = None
    bit: int | None = None

    @property
    def kind(self) -> VariableKind | None:
        """The kind of variable; None for a field of a structure."""
        return self.variable.kind if self.variable is not None else None


@dataclass(frozen=True, slots=True, eq=False)
class Record:
    """A class with slots. `hidden` are slots of the library that have no PLC name, `following` the
    keys of parts that `_now` brings up to date before they are read.

    `size` is how many bytes its objects have besides, in the memory `_memory` from bit `_at` on.
    """

    class_name: str
    parts: tuple[Part, ...]
    by_key: Mapping[str, Part]
    block: AnyBlock | None = None
    hidden: tuple[str, ...] = ()
    size: int = 0
    following: frozenset[str] = frozenset()

    def part(self, name: str) -> Part | None:
        """The part with a PLC name, whatever its case."""
        return self.by_key.get(name.casefold())


def _record(
    class_name: str,
    parts: list[Part],
    block: AnyBlock | None = None,
    hidden: tuple[str, ...] = (),
    size: int = 0,
) -> Record:
    by_key = {part.name.casefold(): part for part in parts}
    return Record(class_name, tuple(parts), by_key, block, hidden, size)


class Model:
    """Names and records of one program."""

    __slots__ = (
        *("_records", "_structures", "global_record", "layout", "names", "program", "structures"),
        "unions",
    )

    def __init__(self, program: Program, library: Mapping[str, type]) -> None:
        self.program = program
        self.layout = BlockLayout(layout_of(program.dialect).is_s7, program)
        self.unions: dict[Record, StructType] = {}
        self.names = Names.of_a_module()
        self.structures: list[Record] = []
        self._structures: dict[StructType, Record] = {}
        self._records: dict[str, Record] = {}
        for key, block in program.blocks.items():
            self.names.of(block.name)
            if has_memory(block):
                self._records[key] = self._block_record(block)
        for standard in program.standard_blocks.values():
            self._records.setdefault(
                standard.name.casefold(), _standard_record(standard, library[standard.name])
            )
        self.global_record = self._global_record()

    def record_of(self, kind: StructType | BlockType) -> Record:
        """The record of a structure or a function block."""
        if isinstance(kind, BlockType):
            return self._records[self.program.block_of(kind.name).name.casefold()]
        record = self._structures.get(kind)
        if record is None:
            names = Names()
            parts = [
                Part(field.name, names.of(field.name), field.type, field.initial)
                for field in kind.fields
            ]
            record = _record(self.names.give(kind.name or "Structure"), parts)
            self._structures[kind] = record
            if kind.is_union:
                self.unions[record] = kind
            else:
                self.structures.append(record)
            for field in kind.fields:
                self.discover(field.type)
        return record

    def discover(self, kind: Type) -> None:
        """Make the records of the structures that data of a type is made of."""
        while isinstance(kind, ArrayType):
            kind = kind.element
        if isinstance(kind, StructType):
            self.record_of(kind)

    def record_named(self, name: str) -> Record:
        """The record of a block that keeps its variables, by name."""
        return self._records[name.casefold()]

    def block_record(self, block: AnyBlock) -> Record:
        """The record of a block that keeps its variables."""
        return self._records[block.name.casefold()]

    @property
    def block_records(self) -> list[Record]:
        """The records of all blocks that keep their variables, the library's too."""
        return list(self._records.values())

    def name_of(self, block: Block) -> str:
        """The Python name of a block: its class or its function."""
        return self.names.of(block.name)

    def global_name(self, variable: Variable) -> str:
        """The Python text for a global variable without an address."""
        part = self.global_record.by_key[variable.name.casefold()]
        return f"{GLOBALS}.{part.slot}" if is_scalar(variable.type) else part.slot

    def _block_record(self, block: Block) -> Record:
        names = Names()
        placement = self.layout.instance(block)
        parts = [
            Part(
                variable.name,
                names.of(variable.name),
                variable.type,
                variable.initial,
                variable.remanent,
                variable,
                None if variable.kind is VariableKind.IN_OUT else placement.bits.get(variable),
            )
            for variable in block.variables
            if variable.kind not in (VariableKind.TEMP, VariableKind.RESULT)
            and variable.address is None
        ]
        return _record(self.names.of(block.name), parts, block, (), placement.size)

    def _global_record(self) -> Record:
        slots = Names(self.names)
        parts = []
        for variable in self.program.globals.values():
            if variable.address is not None:
                continue
            if is_scalar(variable.type):
                slot = slots.give(variable.name)
            else:
                slot = self.names.give(variable.name)
            parts.append(
                Part(
                    variable.name,
                    slot,
                    variable.type,
                    variable.initial,
                    variable.remanent,
                    variable,
                    0 if variable in self.program.byte_memory else None,
                )
            )
        return _record(GLOBALS, parts)


def _standard_record(block: StandardBlock, python_class: type) -> Record:
    parts = [
        Part(variable.name, variable.name, variable.type, None, False, variable)
        for variable in block.variables
    ]
    known = {part.slot for part in parts}
    slots = [slot for base in python_class.__mro__ for slot in getattr(base, "__slots__", ())]
    known.add(STUB_SLOT)
    hidden = tuple(slot for slot in slots if slot not in known and not slot.startswith(BESIDE))
    following = FOLLOWING if hasattr(python_class, "_now") else frozenset()
    return replace(_record(block.name, parts, block, hidden), following=following)


def run_method(block: AnyBlock) -> str:
    """The method that is one call of a block."""
    if isinstance(block, StandardBlock):
        return METHODS.get(block.name.removesuffix("_LTIME"), "_run")
    return "_run"
