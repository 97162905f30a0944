"""What the variables of a block hold between its calls, as far as a solver can prove it.

Candidates are guessed from the text: a number that belongs to a variable in some statement may be
its lower or its upper limit, and one that is only ever given constants may have no other values.
They hold in the beginning. Those that one call can break are left out, until the rest holds behind
a call whenever it holds before it: then it always does (the largest part of the candidates that is
inductive; Flanagan and Leino called the way Houdini).

That is only true of variables that nobody else writes, so no others are looked at: statics and
outputs that no other block names, in no program, without initial values of single instances. It is
taken for granted that no person writes them from outside.
"""

from collections.abc import Iterator, Sequence

import z3

from fbgen.dataclass import dataclass
from fbgen.lang.checked import (
    Assignment,
    Binary,
    Block,
    Constant,
    FieldRef,
    Program,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.layout import holds_blocks
from fbgen.lang.types import BOOL, BlockType, Elementary, Family
from harness.engine.compiled.walk import every_node, written_places
from harness.verify.mutation.proof import terms
from harness.verify.mutation.proof.memory import Memory
from harness.verify.mutation.proof.terms import Term

EFFORT = 50_000_000
"""How much the solver may do for each step; what it cannot decide then is left out."""

_COUNTED = (Family.BOOL, Family.BITS, Family.SIGNED, Family.UNSIGNED, Family.DURATION)


@dataclass(frozen=True, slots=True)
class Invariant:
    """A variable holds one of some values, or lies on one side of a value, between all calls."""

    variable: Variable
    relation: str
    values: tuple[int, ...]

    def of(self, value: Term) -> Term:
        """The same as a condition."""
        kind = self.variable.type
        each = [
            terms.compare(self.relation, value, terms.constant(one, kind), kind)
            for one in self.values
        ]
        return z3.Or(*each)

    @property
    def says_something(self) -> bool:
        """False for what the type says already."""
        kind = self.variable.type
        assert isinstance(kind, Elementary)
        return not (self.holds(kind.minimum) and self.holds(kind.maximum))

    def holds(self, value: int) -> bool:
        """Whether it is true of a value."""
        if self.relation == "=":
            return value in self.values
        return value <= self.values[0] if self.relation == "<=" else value >= self.values[0]


def candidates(block: Block, body: Sequence[object], own: Sequence[Variable]) -> list[Invariant]:
    """What may always be true of some variables of a block, and is in the beginning."""
    found: list[Invariant] = []
    for variable in own:
        first = _first(variable)
        numbers, only = _numbers(body, variable)
        if variable.type == BOOL:
            if only is not None and {*only, first} != {0, 1}:
                found.append(Invariant(variable, "=", (first,)))
            continue
        numbers.add(first)
        for one in sorted(numbers):
            limits = (Invariant(variable, way, (one,)) for way in ("<=", ">="))
            found += [limit for limit in limits if limit.holds(first) and limit.says_something]
        if only is not None:
            found.append(Invariant(variable, "=", tuple(sorted({*only, first}))))
    return found


def _first(variable: Variable) -> int:
    return int(variable.initial) if isinstance(variable.initial, int) else 0


def _numbers(body: Sequence[object], variable: Variable) -> tuple[set[int], set[int] | None]:
    """The numbers in statements and comparisons with a variable, and all that it is given.

    The latter is None if it is given anything but constants.
    """
    numbers: set[int] = set()
    given: set[int] | None = set()
    for node in every_node(body):  # type: ignore[arg-type]
        if isinstance(node, Assignment) and _is(node.target, variable):
            if isinstance(node.value, Constant) and given is not None:
                given.add(int(node.value.value))
            else:
                given = None
            numbers |= _constants(node.value)
        elif isinstance(node, Binary) and (_is(node.left, variable) or _is(node.right, variable)):
            numbers |= _constants(node)
        elif any(_is(place, variable) for place in written_places(node)):
            given = None
    kind = variable.type
    assert isinstance(kind, Elementary)
    return {one for one in numbers if kind.minimum <= one <= kind.maximum}, given


def _is(node: object, variable: Variable) -> bool:
    return isinstance(node, VariableRef) and node.variable is variable


def _constants(node: object) -> set[int]:
    return {
        one.value
        for one in every_node((node,))  # type: ignore[arg-type]
        if isinstance(one, Constant) and type(one.value) is int
    }


# --- whom nobody else writes ----------------------------------------------------------------------


def own_variables(programs: Sequence[Program], block: Block) -> list[Variable]:
    """The numbers and flags of a block that only it writes, in all programs that have it."""
    found = [
        variable
        for variable in block.variables
        if variable.kind in (VariableKind.STATIC, VariableKind.OUTPUT)
        and type(variable.type) is Elementary
        and variable.type.family in _COUNTED
        and variable.address is None
        and variable.overlay is None
    ]
    taken: set[str] = set()
    for program in programs:
        same = program.blocks[block.name.casefold()]
        if same.name.casefold() in program.members or _begins_differently(program, same):
            return []
        taken.update(_taken(program, same))
    return [variable for variable in found if variable.name.casefold() not in taken]


def _begins_differently(program: Program, block: Block) -> bool:
    """True if some variable with instances inside has initial values of its own."""
    variables = [*program.globals.values()]
    for one in program.blocks.values():
        variables += one.variables
    return any(one.initial is not None and holds_blocks(one.type) for one in variables)


def _taken(program: Program, block: Block) -> Iterator[str]:
    """The names of variables of a block that something else may write."""
    mine = set(map(id, block.variables))
    for variable in block.variables:
        if variable in program.byte_memory:
            yield variable.name.casefold()
        if variable.overlay is not None:
            yield variable.overlay.name.casefold()
    for other, body in program.bodies.items():
        for node in every_node(body):
            if isinstance(node, VariableRef):
                if other is not block and id(node.variable) in mine:
                    yield node.variable.name.casefold()
                continue
            for place in written_places(node):
                while not isinstance(place, VariableRef):
                    if isinstance(place, FieldRef) and isinstance(place.base.type, BlockType):
                        yield place.name.casefold()
                    base = getattr(place, "base", None)
                    if base is None:
                        break
                    place = base


# --- what one call keeps --------------------------------------------------------------------------


def kept(start: Memory, end: Memory, guessed: Sequence[Invariant]) -> list[Invariant]:
    """Those of the guessed ones that hold behind each call if all of them hold before it."""
    left = list(guessed)
    while left:
        solver = z3.Solver()
        solver.set("rlimit", EFFORT)
        solver.add(*conditions(start, left))
        behind = [one.of(end.values[one.variable, ()]) for one in left]
        solver.add(z3.Not(z3.And(*behind)))
        answer = solver.check()
        if answer == z3.unsat:
            return left
        if answer != z3.sat:
            return []
        model = solver.model()
        broken = [z3.is_false(model.eval(one, model_completion=True)) for one in behind]
        left = [one for one, breaks in zip(left, broken, strict=True) if not breaks]
        if not any(broken):
            return []
    return left


def conditions(start: Memory, invariants: Sequence[Invariant]) -> list[Term]:
    """Invariants of what the variables hold before a call."""
    return [one.of(start.values[one.variable, ()]) for one in invariants]
