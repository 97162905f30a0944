"""Which temporary variables get a value before anybody reads them, and so need none at the start.

A variable that stands anywhere but as the target of an assignment counts as read. What is nested
deeply, or in a loop that may not run at all, fills nothing.
"""

from collections.abc import Iterable, Sequence

from fbgen.lang.checked import (
    Assignment,
    Case,
    If,
    Repeat,
    Statement,
    Variable,
    VariableRef,
    While,
)
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.walk import Node, nodes_of

_DEEPEST = 20
_VARIABLES = frozenset((VariableRef,))


def read_unfilled(body: Sequence[Statement]) -> set[Variable]:
    """The variables that `body`, which has no jumps, may read before it gives them a value."""
    found: set[Variable] = set()
    _look(body, set(), found, 0)
    return found


def _look(
    body: Iterable[Statement], filled: set[Variable], found: set[Variable], depth: int
) -> None:
    """Add to `found` what is read too early and to `filled` what is filled behind `body`."""
    for statement in body:
        match statement:
            case Assignment(target=VariableRef(variable=variable)) if is_scalar(variable.type):
                _read((statement.value,), filled, found)
                filled.add(variable)
            case If() if depth < _DEEPEST:
                ways = []
                for branch in statement.branches:
                    _read((branch.condition,), filled, found)
                    ways.append(branch.body)
                _choose((*ways, statement.otherwise), filled, found, depth)
            case Case() if depth < _DEEPEST:
                _read((statement.selector,), filled, found)
                ways = [arm.body for arm in statement.arms]
                _choose((*ways, statement.otherwise), filled, found, depth)
            case While() | Repeat() if depth < _DEEPEST:
                _read((statement.condition,), filled, found)
                _look(statement.body, set(filled), found, depth + 1)
            case _:
                _read((statement,), filled, found)


def _choose(
    ways: Iterable[Sequence[Statement]],
    filled: set[Variable],
    found: set[Variable],
    depth: int,
) -> None:
    """One of several ways is taken: what all of them fill is filled behind them."""
    ends = []
    for way in ways:
        end = set(filled)
        _look(way, end, found, depth + 1)
        ends.append(end)
    filled |= set.intersection(*ends)


def _read(nodes: Iterable[Node], filled: set[Variable], found: set[Variable]) -> None:
    found.update(
        node.variable for node in nodes_of(_VARIABLES, nodes) if node.variable not in filled
    )
