"""Makes storages for variables and gives them their initial values.

Defaults: zero, FALSE, the empty text. On S7 a CHAR starts as a blank and dates start at 1990-01-01
(TIA Portal help, default values of the data types); elsewhere a CHAR starts as character 0
(IEC 61131-3 table 10) and dates at the beginning of their count.
"""

from fbgen.dataclass import dataclass
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    LIVING,
    Address,
    AnyBlock,
    Block,
    Program,
    StandardBlock,
    Variable,
    VariableKind,
)
from fbgen.lang.checker.supplied.standard_blocks import ANY_TIMERS, STANDARD_BLOCKS
from fbgen.lang.layout import holds_blocks, holds_values, no_layout
from fbgen.lang.types import (
    DATE_AND_TIME,
    ArrayInitial,
    ArrayType,
    BlockType,
    Elementary,
    Family,
    Initial,
    OpenArrayType,
    ReferenceType,
    Scalar,
    StringType,
    StructInitial,
    StructType,
    Type,
)
from harness.engine.area_memories import AreaMemories
from harness.engine.block_memory import BlockLayout
from harness.engine.layout import layout_of
from harness.engine.reference.behaviour import Behaviour
from harness.engine.reference.calendar import first_on_s7
from harness.engine.reference.memory import Memory, MemoryCell
from harness.engine.reference.placed import ByteCell
from harness.engine.reference.placed_pointers import PointerCell, Pointers
from harness.engine.reference.pointers import ReferenceCell
from harness.engine.reference.standard_blocks import new_behaviour
from harness.engine.reference.storage import (
    Array,
    Cell,
    InstanceStorage,
    Storage,
    Stretch,
    Structure,
    Union,
)
from harness.engine.reference.unmodelled import Unmodelled

_WITH_MEMORY = (BlockKind.FUNCTION_BLOCK, BlockKind.PROGRAM, BlockKind.ORGANIZATION_BLOCK)
_FRAME_KINDS = (VariableKind.TEMP, VariableKind.RESULT)
_PARAMETERS = (VariableKind.INPUT, VariableKind.OUTPUT)
_S7_DIALECTS = ("tia", "step7")


@dataclass(frozen=True, slots=True)
class _Spot:
    """Where in a memory something is to lie; `is_view`: it is there already, under another name."""

    memory: bytearray
    bit: int
    is_view: bool = False

    def behind(self, bits: int) -> "_Spot":
        """So many bits further on."""
        return _Spot(self.memory, self.bit + bits, self.is_view)


class Allocator:
    """Storages for the variables of one program on one controller."""

    __slots__ = ("_layout", "_memory", "_pointers", "_program")

    def __init__(self, program: Program, memory: Memory) -> None:
        self._program = program
        self._memory = memory
        numbers = program.data_blocks
        memories = AreaMemories(memory.environment, numbers, memory.data_block)
        self._pointers = Pointers(memories, self.view)
        self._layout = BlockLayout(layout_of(program.dialect).is_s7, program)

    def variable(self, variable: Variable) -> Storage:
        """The storage of a variable with its initial value; a located one gets it by `reset`."""
        if variable.address is not None:
            return self._located(variable, variable.address)
        return self._variable(variable, None)

    def memory_of(self, block: Variable) -> bytearray:
        """New memory for a data block that lies in bytes."""
        return bytearray(self._layout.size_bytes(block.type))

    def data_block(self, block: Variable, memory: bytearray) -> Storage:
        """A data block in its memory, with its initial values."""
        return self._variable(block, _Spot(memory, 0))

    def alone(self, kind: Type) -> Storage:
        """A variable that belongs to nobody, in bytes if its type has any."""
        if not holds_values(kind) or holds_blocks(kind):
            return self.of_type(kind)
        return self.of_type(kind, _Spot(bytearray(self._layout.size_bytes(kind)), 0))

    def view(self, kind: Type, memory: bytearray, bit: int) -> Storage:
        """What lies at a place of a memory already, as a variable of a type."""
        return self.of_type(kind, _Spot(memory, bit, is_view=True))

    def frame(self, block: Block) -> dict[Variable, Storage]:
        """The variables of one call that lie in bytes."""
        kinds = _FRAME_KINDS if block.kind in _WITH_MEMORY else (*_FRAME_KINDS, *_PARAMETERS)
        placement = self._layout.frame(block, kinds)
        memory = bytearray(placement.size)
        return {
            variable: self._variable(variable, _Spot(memory, bit))
            for variable, bit in placement.bits.items()
        }

    def _variable(self, variable: Variable, spot: _Spot | None) -> Storage:
        if spot is not None and variable.overlay is not None:
            spot = _Spot(spot.memory, spot.bit, is_view=True)
        storage = self.of_type(variable.type, spot)
        if variable.initial is not None:
            apply_initial(storage, variable.initial)
        return storage

    def of_type(self, kind: Type, spot: _Spot | None = None) -> Storage:
        """The storage of a type with the defaults of its parts."""
        if isinstance(kind, Elementary | StringType):
            return self._scalar(kind, spot)
        if isinstance(kind, ArrayType):
            return Array(kind, self._elements(kind, spot), self._stretch(kind, spot))
        if isinstance(kind, ReferenceType):
            if spot is None:
                return ReferenceCell(kind)
            return PointerCell(kind, self._pointers, spot.memory, spot.bit >> 3)
        if isinstance(kind, OpenArrayType):
            return Array(ArrayType(((0, -1),) * kind.dimensions, kind.element), [])
        if isinstance(kind, StructType):
            if kind.is_union:
                return self._union(kind, spot)
            return Structure(kind, self._parts(kind, spot), self._stretch(kind, spot))
        if isinstance(kind, BlockType):
            return self.instance(self._block(kind.name), kind, spot)
        raise no_layout(None, kind)

    def _stretch(self, kind: Type, spot: _Spot | None) -> Stretch | None:
        if spot is None:
            return None
        # What only rounds its length up may belong to somebody else.
        return Stretch(spot.memory, spot.bit >> 3, (self._layout.used_bits(kind) + 7) // 8)

    def _scalar(self, kind: Elementary | StringType, spot: _Spot | None) -> Storage:
        if spot is None:
            return Cell(kind, self._default(kind))
        cell = ByteCell(kind, self._layout, spot.memory, spot.bit)
        if not spot.is_view:
            cell.write(self._default(kind))
        return cell

    def _elements(self, kind: ArrayType, spot: _Spot | None) -> list[Storage]:
        if spot is None:
            return [self.of_type(kind.element) for _ in range(kind.count)]
        bits = self._layout.element_bits(kind)
        return [self.of_type(kind.element, spot.behind(bit)) for bit in bits]

    def _parts(self, kind: StructType, spot: _Spot | None) -> dict[str, Storage]:
        bits = {} if spot is None else self._layout.field_bits(kind)
        parts: dict[str, Storage] = {}
        for field in kind.fields:
            key = field.name.casefold()
            part = self.of_type(field.type, None if spot is None else spot.behind(bits[key]))
            if field.initial is not None and not (spot is not None and spot.is_view):
                apply_initial(part, field.initial)
            parts[key] = part
        return parts

    def _union(self, kind: StructType, spot: _Spot | None) -> Union:
        """All its parts in the same bytes, with the value of the last one that has one."""
        size = self._layout.size_bytes(kind)
        if spot is None:
            spot = _Spot(bytearray(size), 0)
        views = self._parts(kind, _Spot(spot.memory, spot.bit, is_view=True))
        if not spot.is_view:
            for field in kind.fields:
                if field.initial is not None:
                    apply_initial(views[field.name.casefold()], field.initial)
        return Union(kind, views, Stretch(spot.memory, spot.bit >> 3, size))

    def instance(self, block: AnyBlock, kind: Type, spot: _Spot | None = None) -> InstanceStorage:
        """A fresh instance; the in-outs are not connected."""
        if isinstance(block, StandardBlock):
            parts = self._own_parts(block)
            state: Behaviour = Unmodelled()
            if block.name.casefold() in STANDARD_BLOCKS:
                classic = self._memory.environment.classic
                state = new_behaviour(block.name, self._program.dialect, classic=classic)
            return InstanceStorage(kind, block, parts, state)
        placement = self._layout.instance(block)
        memory = None
        if spot is None and placement.size:
            memory = bytearray(placement.size)
            spot = _Spot(memory, 0)
        parts = self._own_parts(block)
        for variable, bit in placement.bits.items():
            if variable.kind in LIVING and spot is not None:
                parts[variable.name.casefold()] = self._variable(variable, spot.behind(bit))
        return InstanceStorage(kind, block, parts, None, memory)

    def _own_parts(self, block: AnyBlock) -> dict[str, Storage]:
        """The living variables of a block, those that lie in bytes still to be replaced."""
        return {
            variable.name.casefold(): self.variable(variable)
            for variable in block.variables
            if variable.kind in LIVING
        }

    def _block(self, name: str) -> AnyBlock:
        """An IEC_TIMER is called as any of the timers, so it has the variables of the largest."""
        block = self._program.block_of(name)
        if isinstance(block, StandardBlock) and block.name in ANY_TIMERS:
            is_long = block.name == "IEC_LTIMER"
            return self._program.standard_blocks["tonr_ltime" if is_long else "tonr"]
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
        if kind == DATE_AND_TIME:
            return first_on_s7()
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
