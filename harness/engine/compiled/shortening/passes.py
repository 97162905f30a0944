"""How many loop passes a call can begin at most, where that is known before it runs.

If no call of any block can reach the limit of the watchdog, no loop has to be counted.
"""

from collections.abc import Iterable
from math import inf

from fbgen.lang.checked import (
    Block,
    Constant,
    For,
    FunctionCall,
    Goto,
    InstanceCall,
    Program,
    Repeat,
    Statement,
    VariableRef,
    While,
)
from harness.engine.compiled.shortening.facts import Facts
from harness.engine.compiled.walk import Node, children


def may_exceed(program: Program, facts: Facts, limit: int) -> bool:
    """True if a call of some block could begin more than `limit` passes."""
    known: dict[Block, float] = {}
    return any(_of_block(block, program, facts, known) > limit for block in program.bodies)


def _of_block(block: Block, program: Program, facts: Facts, known: dict[Block, float]) -> float:
    if block not in known:
        # A block that calls itself comes back here and finds that there is no bound.
        known[block] = inf
        known[block] = _of_nodes(program.bodies[block], program, facts, known)
    return known[block]


def _of_nodes(
    body: Iterable[Statement], program: Program, facts: Facts, known: dict[Block, float]
) -> float:
    total = 0.0
    stack: list[tuple[Node, float]] = [(statement, 1.0) for statement in body]
    while stack:
        node, times = stack.pop()
        inside = times
        match node:
            case While() | Repeat():
                return inf
            case Goto() if node.backward:
                return inf
            case For():
                passes = _passes(node, facts)
                if passes == inf:
                    return inf
                inside = times * passes
                total += inside
            case FunctionCall() if times:
                meant = [node.function, *(override for _, override in node.overrides)]
                total += times * max(_of_block(one, program, facts, known) for one in meant)
            case InstanceCall() if times and isinstance(node.block, Block):
                total += times * _of_block(node.block, program, facts, known)
            case _:
                pass
        if total == inf:
            return inf
        stack.extend((child, inside) for child in children(node))
    return total


def _passes(node: For, facts: Facts) -> float:
    variable = node.variable
    ends = (node.first, node.last, node.step)
    if not isinstance(variable, VariableRef) or not facts.keeps(variable.variable, node.body):
        return inf
    values = [int(end.value) for end in ends if isinstance(end, Constant)]
    if len(values) < len(ends) or values[2] == 0:
        return inf
    first, last, step = values
    return len(range(first, last + (1 if step > 0 else -1), step))
