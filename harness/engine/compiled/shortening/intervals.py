"""What a condition says about the values of variables, for the branch that it guards.

`IF n < 1000 THEN n := n + 1` cannot wrap around. What is known holds until the variable is written.
"""

from collections.abc import Iterable, Mapping
from typing import TypeAlias

from fbgen.lang.checked import (
    Assignment,
    Binary,
    Constant,
    Expression,
    FunctionCall,
    RoutineCall,
    Statement,
    SystemCall,
    Unary,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.types import BOOL
from harness.engine.compiled.shortening.ranges import is_counted, limits
from harness.engine.compiled.walk import WRITING, every_node, nodes_of, root_of, written_places

Intervals: TypeAlias = Mapping[Variable, tuple[int, int]]

_MIRRORED = {"<": ">", ">": "<", "<=": ">=", ">=": "<=", "=": "=", "<>": "<>"}
_OPPOSITE = {"<": ">=", ">": "<=", "<=": ">", ">=": "<", "=": "<>", "<>": "="}
_MOST_TERMS = 20
"""Terms of a condition that are looked at."""


def learned(condition: Expression, holds: bool, known: Intervals) -> Intervals:
    """`known`, and what follows from the condition being true, or false."""
    result = dict(known)
    terms = [(condition, holds)]
    for _ in range(_MOST_TERMS):
        if not terms:
            break
        term, is_true = terms.pop()
        if isinstance(term, Unary) and term.operator == "NOT" and term.type == BOOL:
            terms.append((term.operand, not is_true))
        elif isinstance(term, Binary) and term.type == BOOL:
            if term.operator in (("AND", "AND_THEN") if is_true else ("OR", "OR_ELSE")):
                terms += [(term.left, is_true), (term.right, is_true)]
            elif term.operator in _MIRRORED:
                _compare(term, is_true, result)
    return result


def _compare(term: Binary, is_true: bool, result: dict[Variable, tuple[int, int]]) -> None:
    left, operator, right = term.left, term.operator, term.right
    if isinstance(left, Constant):
        left, operator, right = right, _MIRRORED[operator], left
    if not (isinstance(left, VariableRef) and isinstance(right, Constant)):
        return
    variable = left.variable
    if not is_counted(left.type) or variable.kind is VariableKind.GLOBAL:
        return
    operator = operator if is_true else _OPPOSITE[operator]
    bound = int(right.value)
    low, high = result.get(variable, limits(left.type))
    if operator in ("<", "<=", "="):
        high = min(high, bound - (operator == "<"))
    if operator in (">", ">=", "="):
        low = max(low, bound + (operator == ">"))
    if low <= high:
        result[variable] = (low, high)


def calls_anything(condition: Expression) -> bool:
    """True if evaluating the condition may itself change what it speaks of."""
    return any(
        isinstance(node, FunctionCall | SystemCall | RoutineCall)
        for node in every_node((condition,))
    )


def written_inside(statement: Statement) -> set[Variable | None]:
    """The variables that a statement writes, but for the target of an assignment."""
    roots: Iterable[Statement | Expression] = (
        (statement.value,) if isinstance(statement, Assignment) else (statement,)
    )
    return {root_of(place) for node in nodes_of(WRITING, roots) for place in written_places(node)}
