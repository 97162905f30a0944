"""How much work memory a plant takes in its CPU.

Data blocks: the bytes that they have with the classic layout, exactly; a block with optimized
access takes about the same. Code: an estimate, marked as one. What a compiler makes of a block
depends on its version, so it is counted by a rule of thumb: bytes for the block itself, for every
operand (a variable, a constant) and for every call.
"""

from collections.abc import Iterator, Mapping, Sequence

from fbgen.artefacts.view import PlantLists
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.emit.rendering import CANONICAL_DIALECT
from fbgen.lang import ast
from fbgen.lang.checked import Block, Program, VariableKind
from fbgen.lang.checker import check
from fbgen.lang.conversion import with_copies
from fbgen.lang.layout import S7_SIZES
from fbgen.lang.types import ArrayType, BlockType, Elementary, Type
from fbgen.lang.walk import by_kind
from fbgen.plant import CPUS, cpus_of

BYTES_A_BLOCK = 100
BYTES_AN_OPERAND = 6
BYTES_A_CALL = 40
BYTES_A_DATA_BLOCK = 36
"""What a block costs beside its content. The first three are the rule of thumb for code."""

_TIMER_BITS = {True: 22 * 8, False: 16 * 8}
"""An instance of the on-delay timer: SFB4 of S7-300/400 has 22 bytes, IEC_TIMER has 16."""
_POINTER_BITS = 48
"""A structured in-out parameter in an instance of S7-300/400."""
_IN_INSTANCE = (
    (VariableKind.INPUT,),
    (VariableKind.OUTPUT,),
    (VariableKind.IN_OUT, VariableKind.KEPT),
    (VariableKind.STATIC,),
)


@dataclass(frozen=True, slots=True)
class BlockMemory:
    """A block in the work memory; `exact` is True for the bytes of data blocks."""

    name: str
    size: int
    exact: bool


@dataclass(frozen=True, slots=True)
class WorkMemory:
    """All blocks of a plant."""

    blocks: tuple[BlockMemory, ...]

    @property
    def code(self) -> int:
        """Bytes of code, estimated."""
        return sum(block.size for block in self.blocks if not block.exact)

    @property
    def data(self) -> int:
        """Bytes of data."""
        return sum(block.size for block in self.blocks if block.exact)


def work_memory(lists: PlantLists) -> WorkMemory:
    """What the plant takes. On S7-300/400 with the copies that their compilers need."""
    units: Sequence[ast.File] = lists.canonical.units
    program = lists.canonical.program
    if lists.plant.family.classic:
        units = with_copies(units)
        program = check(units, CANONICAL_DIALECT)
    sizes = _Sizes(program, classic=lists.plant.family.classic)
    return WorkMemory(tuple(_blocks(units, sizes, lists.canonical.bodies)))


def memory_of(units: Sequence[ast.File], program: Program, *, classic: bool) -> WorkMemory:
    """What these units take; `classic` for S7-300/400, where a timer is a system function block."""
    return WorkMemory(tuple(_blocks(units, _Sizes(program, classic=classic), {})))


def too_large(lists: PlantLists, found: WorkMemory) -> Iterator[Diagnostic]:
    """FB5015: more than the CPU of the plant file has."""
    cpu = CPUS.get(lists.plant.cpu or "")
    if cpu is None:
        return
    parts = [("code and data", found.code + found.data, cpu.code_kib)]
    if cpu.data_kib is not None:
        parts = [("code", found.code, cpu.code_kib), ("data", found.data, cpu.data_kib)]
    family = cpus_of(cpu.family)
    larger = [other.name for other in family[family.index(cpu) + 1 :]]
    other_cpu = f", or a larger one of {', '.join(larger)}" if larger else ""
    for what, size, room in parts:
        if size > room * 1024:
            yield Diagnostic(
                "FB5015",
                f"{what} of the generated blocks take about {size / 1024:.0f} KiB, and the work "
                f"memory of CPU {cpu.name} has {room} KiB",
                lists.plant.span_of("cpu"),
                f"generate fewer sequences, use fewer gateways for one CPU{other_cpu}",
                severity=Severity.WARNING,
            )


def _blocks(
    units: Sequence[ast.File],
    sizes: "_Sizes",
    bodies: Mapping[str, tuple[ast.Statement, ...]],
) -> Iterator[BlockMemory]:
    known: dict[int, int] = {}
    for file in units:
        for unit in file.units:
            if isinstance(unit, ast.DataBlock):
                kind = sizes.program.globals[unit.name.name.casefold()].type
                size = BYTES_A_DATA_BLOCK + _bytes(sizes.bits(kind))
                yield BlockMemory(unit.name.name, size, exact=True)
            elif isinstance(unit, ast.Block):
                body = bodies.get(unit.name.name, unit.body)
                if id(body) not in known:
                    known[id(body)] = _code(body)
                yield BlockMemory(unit.name.name, known[id(body)], exact=False)


def _code(body: tuple[ast.Statement, ...]) -> int:
    found = by_kind(body)
    operands = sum(len(found.get(kind, ())) for kind in (ast.Name, ast.Literal, ast.DirectAddress))
    calls = len(found.get(ast.Call, ()))
    return BYTES_A_BLOCK + BYTES_AN_OPERAND * operands + BYTES_A_CALL * calls


def _bytes(bits: int) -> int:
    return -(-bits // 16) * 2


class _Sizes:
    """Sizes with instances of function blocks, which `fbgen.lang.layout` leaves out."""

    def __init__(self, program: Program, *, classic: bool) -> None:
        self.program = program
        self._classic = classic
        self._known: dict[str, int] = {}

    def bits(self, kind: Type) -> int:
        """The size of a variable of the type, or of the instance of a block."""
        if isinstance(kind, BlockType):
            return self._instance(kind.name.casefold())
        if isinstance(kind, ArrayType) and isinstance(kind.element, BlockType):
            return kind.count * _bytes(self.bits(kind.element)) * 8
        return S7_SIZES.size_bits(kind)

    def _instance(self, name: str) -> int:
        if name not in self._known:
            block = self.program.blocks.get(name)
            own = _TIMER_BITS[self._classic] if block is None else self._placed(block)
            self._known[name] = own
        return self._known[name]

    def _placed(self, block: Block) -> int:
        """The variables one behind the other, each where its type may start."""
        end = 0
        for kinds in _IN_INSTANCE:
            for variable in block.variables:
                if variable.kind not in kinds or variable.overlay is not None:
                    continue
                of_type = variable.type
                is_in_out = VariableKind.IN_OUT in kinds
                pointed = is_in_out and not isinstance(of_type, Elementary)
                bits = _POINTER_BITS if pointed else self.bits(of_type)
                small = isinstance(of_type, Elementary) and of_type.bits <= 8
                step = bits if small else 16
                end = -(-end // step) * step + bits
        return -(-end // 16) * 16
