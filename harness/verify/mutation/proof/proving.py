"""Is a mutant the same as the block? Yes with a proof, no with a start that tells them apart."""

from collections.abc import Sequence
from enum import Enum

import z3

from fbgen.dataclass import dataclass
from fbgen.lang.checked import (
    AnyBlock,
    Block,
    FieldRef,
    FunctionCall,
    IndexRef,
    InstanceCall,
    Place,
    Program,
    ReferenceTo,
    Statement,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checked import Constant as ConstantIndex
from harness.engine.compiled.walk import every_node
from harness.verify.mutation.proof.invariants import (
    Invariant,
    candidates,
    conditions,
    kept,
    own_variables,
)
from harness.verify.mutation.proof.memory import Memory, any_values
from harness.verify.mutation.proof.statements import Execution
from harness.verify.mutation.proof.terms import Term, UnknownError

EFFORT = 20_000_000
"""How much the solver may do for one proof: a count of its own, the same on every machine."""
EXACT_EFFORT = 1_000_000
"""The same for calculations with REAL, where each count takes far longer."""


class Answer(Enum):
    """What the solver says."""

    EQUIVALENT = "equivalent"
    DIFFERENT = "different"
    UNKNOWN = "unknown"


@dataclass(frozen=True, slots=True)
class Proof:
    """The answer, and why there is none."""

    answer: Answer
    why: str = ""


def transition(
    program: Program, block: Block, body: Sequence[Statement], *, exact: bool = True
) -> Memory:
    """What one call makes of any start. Raises UnknownError. `exact` as for `Reader`."""
    memory = _start(program, block, body)
    execution = Execution(program, memory, exact=exact)
    execution.run(body)
    return execution.memory


def _start(program: Program, block: Block, body: Sequence[Statement]) -> Memory:
    variables = set(block.variables)
    for node in every_node(body):
        if isinstance(node, VariableRef) and node.variable.kind is VariableKind.GLOBAL:
            variables.add(node.variable)
    return Memory.begin(any_values(program, variables))


def invariants_of(programs: Sequence[Program], block: Block) -> tuple[Invariant, ...]:
    """What the variables of a block of the first program hold between its calls.

    All programs have the very same block.
    """
    body = programs[0].bodies[block]
    guessed = candidates(block, body, own_variables(programs, block))
    if not guessed:
        return ()
    try:
        check_places(programs[0], block)
        end = transition(programs[0], block, body, exact=False)
    except UnknownError:
        return ()
    return tuple(kept(_start(programs[0], block, body), end, guessed))


def compare(
    program: Program,
    block: Block,
    body: Sequence[Statement],
    other: Sequence[Statement],
    invariants: Sequence[Invariant] = (),
) -> Proof:
    """Whether one call of a block with other statements can be told from one with its own.

    `invariants` say what is true before each call.
    """
    try:
        check_places(program, block)
        known = conditions(_start(program, block, body), invariants)
        for exact in (False, True):
            first = transition(program, block, body, exact=exact)
            second = transition(program, block, other, exact=exact)
            proof = _compared(first, second, known, EXACT_EFFORT if exact else EFFORT)
            if proof.answer is Answer.EQUIVALENT or exact:
                return proof
    except UnknownError as unknown:
        return Proof(Answer.UNKNOWN, str(unknown))
    raise AssertionError("the exact one has an answer")


def _compared(first: Memory, second: Memory, known: Sequence[Term], effort: int) -> Proof:
    differ = [first.world != second.world, first.stopped != second.stopped]
    for key in {*first.values, *second.values}:
        if key[0].kind is VariableKind.TEMP:
            continue
        one, two = first.values.get(key), second.values.get(key)
        if one is None or two is None:
            return Proof(Answer.UNKNOWN, f"{key[0].name} is in one of them only")
        if not one.eq(two):
            differ.append(one != two)
    solver = z3.Solver()
    solver.set("rlimit", effort)
    solver.add(*known, z3.Or(*differ))
    found = solver.check()
    if found == z3.unsat:
        return Proof(Answer.EQUIVALENT)
    if found == z3.sat:
        return Proof(Answer.DIFFERENT)
    return Proof(Answer.UNKNOWN, "the solver gave up")


# --- places that could be one ---------------------------------------------------------------------


def check_places(program: Program, block: Block) -> None:
    """Raises UnknownError if two names of the block may mean one place.

    In-outs are different places if each call hands different ones over, and no global variable that
    the block could reach besides.
    """
    in_outs = {one for one in block.variables if one.kind is VariableKind.IN_OUT}
    for body in program.bodies.values():
        for node in every_node(body):
            if isinstance(node, ReferenceTo):
                raise UnknownError("references")
            if not in_outs:
                continue
            if isinstance(node, FunctionCall | InstanceCall) and _called(node) is block:
                _check_call(program, block, node.in_outs)


def _called(node: FunctionCall | InstanceCall) -> AnyBlock:
    return node.function if isinstance(node, FunctionCall) else node.block


def _check_call(program: Program, block: Block, in_outs: Sequence[tuple[Variable, Place]]) -> None:
    ways = [_way(place) for _, place in in_outs]
    for number, one in enumerate(ways):
        if any(not _apart(one, other) for other in ways[number + 1 :]):
            raise UnknownError("two in-outs may be the same variable")
    used = {
        node.variable for node in every_node(program.bodies[block]) if isinstance(node, VariableRef)
    }
    if any(way[0] in used for way in ways if way):
        raise UnknownError("an in-out may be a global variable that the block uses")


def _way(place: Place) -> list[object]:
    """The variable, then names and fixed indices; None stands for an index that is worked out."""
    way: list[object] = []
    while not isinstance(place, VariableRef):
        if isinstance(place, FieldRef):
            way.insert(0, place.name.casefold())
        elif isinstance(place, IndexRef):
            fixed = all(isinstance(one, ConstantIndex) for one in place.indices)
            index = tuple(getattr(one, "value", None) for one in place.indices)
            way.insert(0, index if fixed else None)
        else:
            raise UnknownError("an in-out with an address")
        place = place.base
    way.insert(0, place.variable)
    return way


def _apart(one: list[object], other: list[object]) -> bool:
    for first, second in zip(one, other, strict=False):
        if first != second and first is not None and second is not None:
            return True
    return False
