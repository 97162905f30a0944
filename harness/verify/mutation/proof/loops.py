"""Loops of which nobody knows how often they run: the same loop makes the same of the same values.

Nothing else is known of them. That is enough for mutants outside of the loop; one inside of it is
another loop, which is as good as any.
"""

from hashlib import sha256

import z3

from fbgen.lang.checked import (
    FieldRef,
    For,
    FunctionCall,
    Repeat,
    StandardBlock,
    Variable,
    VariableRef,
    While,
)
from fbgen.lang.types import BlockType
from harness.engine.compiled.walk import Node, every_node, root_of, written_places
from harness.verify.mutation.fingerprint import text_of
from harness.verify.mutation.proof.expressions import CALCULATING, Reader, apply, event, is_pure
from harness.verify.mutation.proof.terms import UnknownError

_IN_LOOPS = ({*CALCULATING} - {"Return"}) | {"While", "Repeat"}


def run_loop(reader: Reader, loop: For | While | Repeat) -> None:
    """Give the variables that a loop writes what it makes of those that it reads.

    Raises UnknownError for a loop that does more than calculate.
    """
    nodes = tuple(every_node((loop,)))
    for node in nodes:
        _check(reader, node)
    used = {node.variable for node in nodes if isinstance(node, VariableRef)}
    for variable in used:
        reader.check(variable)
    written = {_written(place) for node in nodes for place in written_places(node)}
    memory = reader.memory
    keys = sorted(
        (key for key in memory.values if key[0] in used), key=lambda key: (key[0].name, key[1])
    )
    if {variable for variable, _ in keys} != used:
        raise UnknownError("a loop with variables of others")
    name = f"loop {sha256(text_of(loop).encode()).hexdigest()}"
    done = event(name, *(memory.values[key] for key in keys))
    reader.stop(apply(f"{name}: stops", z3.BoolSort(), done))
    for key in keys:
        if key[0] in written:
            label = f"{name}: {'.'.join((key[0].name, *key[1]))}"
            reader.put(key, apply(label, memory.values[key].sort(), done))


def _check(reader: Reader, node: Node) -> None:
    if isinstance(node, FieldRef) and isinstance(node.base.type, BlockType):
        if isinstance(reader.program.block_of(node.base.type.name), StandardBlock):
            raise UnknownError("a timer in a loop")
    elif isinstance(node, FunctionCall):
        if node.overrides or not is_pure(reader.program, node.function):
            raise UnknownError("a call in a loop")
    elif type(node).__name__ not in _IN_LOOPS:
        raise UnknownError(f"a loop with {type(node).__name__}")


def _written(place: object) -> Variable:
    variable = root_of(place)  # type: ignore[arg-type]
    if variable is None:
        raise UnknownError("a loop that writes an address")
    return variable
