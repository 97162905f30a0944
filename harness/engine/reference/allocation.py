"""Makes storages for variables and gives them their initial values.

Defaults: zero, FALSE, the empty text. On S7 a CHAR starts as a blank and dates start at 1990-01-01
(TIA Portal help, default values of the data types); elsewhere a CHAR starts as character 0
(IEC 61131-3 table 10) and dates at the beginning of their count.
"""

from fbgen.lang.checked import Address, AnyBlock, Block, Program, StandardBlock, Variable
from fbgen.lang.types import (
    DATE_AND_TIME,
    ArrayInitial,
    ArrayType,
    BlockType,
    Elementary,
    Family,
    Initial,
    Scalar,
    StringType,
    StructInitial,
    StructType,
    Type,
)
from harness.engine.faults import no_layout
from harness.engine.reference.memory import Memory, MemoryCell
from harness.engine.reference.standard_blocks import new_behaviour
from harness.engine.reference.storage import (
    LIVING_KINDS,
    Array,
    Cell,
    InstanceStorage,
    Storage,
    Structure,
)

_S7_DIALECTS = ("tia", "step7")
_S7_FIRST_DATE_AND_TIME = 631_152_000_000_000_000


class Allocator:
    """Storages for the variables of one program on one controller."""

    __slots__ = ("_memory", "_program")

    def __init__(self, program: Program, memory: Memory) -> None:
        self._program = program
        self._memory = memory

    def variable(self, variable: Variable) -> Storage:
        """The storage of a variable with its initial value; a located one gets it by `reset`."""
        if variable.address is not None:
            return self._located(variable, variable.address)
        storage = self.of_type(variable.type)
        if variable.initial is not None:
            apply_initial(storage, variable.initial)
        return storage

    def of_type(self, kind: Type) -> Storage:
        """The storage of a type with the defaults of its parts."""
        if isinstance(kind, Elementary | StringType):
            return Cell(kind, self._default(kind))
        if isinstance(kind, ArrayType):
            return Array(kind, [self.of_type(kind.element) for _ in range(kind.count)])
        if isinstance(kind, StructType):
            parts: dict[str, Storage] = {}
            for field in kind.fields:
                part = self.of_type(field.type)
                if field.initial is not None:
                    apply_initial(part, field.initial)
                parts[field.name.casefold()] = part
            return Structure(kind, parts)
        if isinstance(kind, BlockType):
            return self.instance(self._block(kind.name), kind)
        raise no_layout(None, kind)

    def instance(self, block: AnyBlock, kind: Type) -> InstanceStorage:
        """A fresh instance; the in-outs are not connected."""
        parts = {
            variable.name.casefold(): self.variable(variable)
            for variable in block.variables
            if variable.kind in LIVING_KINDS
        }
        if isinstance(block, StandardBlock):
            state = new_behaviour(block.name, self._program.dialect)
            return InstanceStorage(kind, block, parts, state)
        return InstanceStorage(kind, block, parts, None)

    def _block(self, name: str) -> AnyBlock:
        """An IEC_TIMER is called as any of the timers, so it has the variables of the largest."""
        block = self._program.block_of(name)
        if isinstance(block, StandardBlock) and block.name == "IEC_TIMER":
            return self._program.standard_blocks["tonr"]
        return block

    def of_block(self, block: Block) -> InstanceStorage:
        """The variables of a block that is its own instance, such as a PROGRAM."""
        return self.instance(block, BlockType(block.name))

    def _located(self, variable: Variable, address: Address) -> MemoryCell:
        initial = variable.initial
        if not isinstance(variable.type, Elementary):
            raise no_layout(variable.span, variable.type)
        assert not isinstance(initial, ArrayInitial | StructInitial)
        return MemoryCell(variable.type, address, self._memory, variable.span, initial)

    def _default(self, kind: Elementary | StringType) -> Scalar:
        if isinstance(kind, StringType):
            return ""
        on_s7 = self._program.dialect in _S7_DIALECTS
        if kind.family is Family.BOOL:
            return False
        if kind.family is Family.REAL:
            return 0.0
        if kind.family is Family.CHAR:
            return " " if on_s7 else "\0"
        if kind == DATE_AND_TIME and on_s7:
            return _S7_FIRST_DATE_AND_TIME
        return 0


def apply_initial(storage: Storage, initial: Initial) -> None:
    """Set the initial values that are given; the others keep the defaults they have."""
    if isinstance(initial, StructInitial):
        assert isinstance(storage, Structure | InstanceStorage)
        for name, value in initial.fields:
            apply_initial(storage.parts[name.casefold()], value)
    elif isinstance(initial, ArrayInitial):
        assert isinstance(storage, Array)
        for element, item in zip(storage.elements, initial.items, strict=False):
            if item is not None:
                apply_initial(element, item)
    else:
        storage.write(initial)
