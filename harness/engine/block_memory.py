"""Where the variables of blocks lie that live in bytes (`checked.Program.byte_memory`).

An instance has its inputs, outputs, in-outs and statics in this order, each section from an even
byte on, as an instance data block has them on S7; an in-out that is a reference (a structure, an
array, a text) takes the six bytes of a pointer. A call has its temporaries, and in a FUNCTION its
parameters, one behind the other. The bytes of timers, counters and edges inside of an instance are
reserved and stay zero: what these remember is kept elsewhere.
Sources: STEP 7 help, "Instance data block"; S7-1500 help, "IEC_TIMER" and "IEC_COUNTER" (lengths);
STEP 7 System and Standard Functions, SFB 0 to 5 (lengths on S7-300/400).
"""

from collections.abc import Iterable, Mapping
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.lang.checked import (
    IN_OUTS,
    Block,
    Program,
    StandardBlock,
    Variable,
    VariableKind,
)
from fbgen.lang.types import BlockType, Type
from harness.engine.layout import Layout

_SECTIONS = (
    (VariableKind.INPUT,),
    (VariableKind.OUTPUT,),
    IN_OUTS,
    (VariableKind.STATIC,),
)
_POINTER_BITS = 48
_TIMER_BITS = {"tia": 128, "step7": 176}
_OTHER_BITS = {"R_TRIG": 16, "F_TRIG": 16, "SR": 16, "RS": 16}
_COUNTER_BITS = 96


@dataclass(frozen=True, slots=True)
class Placement:
    """The first bit of each variable, and how many bytes they take together."""

    bits: Mapping[Variable, int]
    size: int


@dataclass(frozen=True, slots=True)
class BlockLayout(Layout):
    """How the variables of one program lie in memory, instances of its blocks included."""

    program: Program
    _instances: dict[str, Placement] = field(default_factory=dict)
    _frames: dict[Block, Placement] = field(default_factory=dict)

    def size_bits(self, kind: Type) -> int:
        """As `Layout.size_bits`, and for instances."""
        if not isinstance(kind, BlockType):
            return Layout.size_bits(self, kind)
        block = self.program.block_of(kind.name)
        if isinstance(block, StandardBlock):
            return self._standard_bits(block)
        return 8 * self.instance(block).size

    def _standard_bits(self, block: StandardBlock) -> int:
        if block.name in _OTHER_BITS:
            return _OTHER_BITS[block.name]
        if any(variable.name == "ET" for variable in block.variables):
            return _TIMER_BITS.get(self.program.dialect, 128)
        return _COUNTER_BITS

    def instance(self, block: Block) -> Placement:
        """The variables of an instance that live in bytes."""
        key = block.name.casefold()
        if key not in self._instances:
            self._instances[key] = self._placed(
                variable
                for section in _SECTIONS
                for variable in block.variables
                if variable.kind in section
            )
        return self._instances[key]

    def frame(self, block: Block, kinds: tuple[VariableKind, ...]) -> Placement:
        """The variables of a call that live in bytes: those of the given kinds."""
        if block not in self._frames:
            self._frames[block] = self._placed(v for v in block.variables if v.kind in kinds)
        return self._frames[block]

    def _placed(self, variables: Iterable[Variable]) -> Placement:
        bits: dict[Variable, int] = {}
        overlays: list[Variable] = []
        end = 0
        before: tuple[VariableKind, ...] = ()
        for variable in variables:
            if variable not in self.program.byte_memory:
                continue
            if variable.overlay is not None:
                overlays.append(variable)
                continue
            section = _section(variable.kind)
            start = self._even(end) if section != before else end
            before = section
            if variable.kind is VariableKind.IN_OUT:
                start, size = self._even(start), _POINTER_BITS
            else:
                start = self.aligned(start, variable.type)
                size = self.size_bits(variable.type)
            bits[variable] = start
            end = start + size
        for variable in overlays:
            assert variable.overlay is not None
            bits[variable] = bits[variable.overlay]
        return Placement(bits, self._even(end) // 8)

    def _even(self, bit: int) -> int:
        return -(-bit // 16) * 16


def _section(kind: VariableKind) -> tuple[VariableKind, ...]:
    """The kinds of variables that lie one behind the other with this one."""
    return next((section for section in _SECTIONS if kind in section), (kind,))
