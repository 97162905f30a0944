"""Operators on comparisons, on AND, OR and NOT, and on calculations."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from fbgen.lang.checked import (
    Assignment,
    Binary,
    Expression,
    FieldRef,
    Statement,
    Unary,
    VariableRef,
)
from fbgen.lang.types import BOOL, BlockType, Elementary, Family
from fbgen.source import Span
from harness.verify.mutation.mutant import Change, Edit, Operator, exchanged
from harness.verify.mutation.places import (
    Seat,
    every_statement,
    in_parentheses,
    is_operation,
    stands_in_parentheses,
    wrapped,
    written,
)

_BESIDE = {
    "<": ("<=", "<>"),
    "<=": ("<", "="),
    ">": (">=", "<>"),
    ">=": (">", "="),
    "=": ("<=", ">="),
    "<>": ("<", ">"),
}
"""Each comparison with those that differ from it in one of the three cases less, equal, greater."""

_ORDERED = (Family.SIGNED, Family.UNSIGNED, Family.REAL, Family.DURATION)
_OTHER_CALCULATION = {"+": "-", "-": "+", "*": "/", "/": "*", "MOD": "/"}
_OTHER_LOGIC = {"AND": "OR", "OR": "AND", "XOR": "OR", "AND_THEN": "OR_ELSE", "OR_ELSE": "AND_THEN"}
_GAP = re.compile(r"\s+|//[^\n]*|\(\*.*?\*\)|/\*.*?\*/|[()]", re.DOTALL)
_TOKEN = re.compile(r"AND_THEN|OR_ELSE|AND|XOR|OR|MOD|DIV|\*\*|<>|<=|>=|[-+*/<>=&]", re.IGNORECASE)


def operator_span(node: Binary) -> Span | None:
    """Where the operator stands; None where the text is another one, such as the call of ADD."""
    source = node.span.source
    place, end = written(node.left).span.end, written(node.right).span.start
    while place < end and (gap := _GAP.match(source.text, place, end)):
        place = gap.end()
    token = _TOKEN.match(source.text, place, end)
    return None if token is None else Span(source, token.start(), token.end())


def with_operator(operator: Operator, seat: Seat, sign: str) -> Iterator[Change]:
    """The change of a Binary to another operator, with the parentheses that this needs."""
    node = seat.expression
    assert isinstance(node, Binary)
    place = operator_span(node)
    if place is None:
        return
    source = place.source
    edits = [Edit(place, sign)]
    left, right = Span(source, node.span.start, place.start), Span(source, place.end, node.span.end)
    for side, operand in ((left, node.left), (right, node.right)):
        text = side.text
        if isinstance(written(operand), Binary) and not wrapped(text):
            start = side.start + len(text) - len(text.lstrip())
            edits += in_parentheses(Span(source, start, side.start + len(text.rstrip())))
    if is_operation(seat.parent) and not stands_in_parentheses(node.span):
        edits += in_parentheses(node.span)
    new = replace(node, operator=sign)
    yield exchanged(operator, seat.statement, node, new, *_in_order(edits))


def _in_order(edits: Sequence[Edit]) -> tuple[Edit, ...]:
    """By place. Of two insertions at one place the outer parenthesis is the one made later."""
    opening = [one for one in edits if one.text == "(" and not one.span.text]
    others = [one for one in edits if one not in opening]
    return tuple(sorted((*reversed(opening), *others), key=lambda one: one.span.start))


def comparisons(seat: Seat) -> Iterator[Change]:
    """Another comparison. What has no order is only asked whether it is equal or not."""
    node = seat.expression
    if not isinstance(node, Binary) or node.operator not in _BESIDE:
        return
    kind = node.left.type
    ordered = isinstance(kind, Elementary) and kind.family in _ORDERED
    signs = _BESIDE[node.operator] if ordered else ()
    if node.operator in ("=", "<>"):
        signs = ({"=": "<>", "<>": "="}[node.operator], *signs)
    for sign in signs:
        yield from with_operator(Operator.RELATIONAL, seat, sign)


def logic(seat: Seat) -> Iterator[Change]:
    """AND for OR and the other way round; NOT left out."""
    node = seat.expression
    if isinstance(node, Binary) and node.operator in _OTHER_LOGIC:
        kind = Operator.LOGICAL if node.type == BOOL else Operator.MASK
        yield from with_operator(kind, seat, _OTHER_LOGIC[node.operator])
    elif isinstance(node, Unary) and node.operator == "NOT":
        start = node.span.start
        end = start + len("NOT")
        while node.span.source.text[end].isspace():
            end += 1
        edit = Edit(Span(node.span.source, start, end), "")
        yield exchanged(Operator.LOGICAL, seat.statement, node, node.operand, edit)


def calculations(seat: Seat) -> Iterator[Change]:
    """Another calculation, and a sign left out."""
    node = seat.expression
    if isinstance(node, Unary) and node.operator == "-":
        edit = Edit(Span(node.span.source, node.span.start, node.span.start + 1), "")
        yield exchanged(Operator.ARITHMETIC, seat.statement, node, node.operand, edit)
    if not isinstance(node, Binary) or node.operator not in _OTHER_CALCULATION:
        return
    if node.left.type != node.right.type or node.type != node.left.type:
        return
    # Times are only added and subtracted.
    is_number = isinstance(node.type, Elementary) and node.type.family in _ORDERED[:3]
    if is_number or node.operator in ("+", "-"):
        yield from with_operator(Operator.ARITHMETIC, seat, _OTHER_CALCULATION[node.operator])


# --- edges ----------------------------------------------------------------------------------------


def edge_memories(body: Sequence[Statement]) -> frozenset[tuple[object, object]]:
    """Pairs of a BOOL variable and the one that keeps its value of the last call."""
    return frozenset(
        (statement.value.variable, statement.target.variable)
        for statement in every_statement(body)
        if isinstance(statement, Assignment)
        and isinstance(statement.target, VariableRef)
        and isinstance(statement.value, VariableRef)
        and statement.target.type == BOOL
    )


def edges(seat: Seat, memories: frozenset[tuple[object, object]]) -> Iterator[Change]:
    """The level where `x AND NOT memory` or an instance of R_TRIG or F_TRIG asks for an edge."""
    node = seat.expression
    if isinstance(node, Binary) and node.operator in ("AND", "AND_THEN") and node.type == BOOL:
        for kept, other in ((node.left, node.right), (node.right, node.left)):
            if (_without_not(kept), _without_not(other)) in memories:
                edit = Edit(node.span, kept.span.text)
                yield exchanged(Operator.EDGE, seat.statement, node, kept, edit)
    elif isinstance(node, FieldRef) and node.name.upper() == "Q" and _is_edge_block(node.base.type):
        text = node.span.text
        edit = Edit(node.span, f"{text[: -len(node.name)]}CLK")
        yield exchanged(Operator.EDGE, seat.statement, node, replace(node, name="CLK"), edit)


def _without_not(expression: Expression) -> object:
    while isinstance(expression, Unary):
        expression = expression.operand
    return expression.variable if isinstance(expression, VariableRef) else None


def _is_edge_block(kind: object) -> bool:
    return isinstance(kind, BlockType) and kind.name.upper() in ("R_TRIG", "F_TRIG")


# --- whole conditions and statements --------------------------------------------------------------


def negations(statement: Statement, conditions: Sequence[Expression]) -> Iterator[Change]:
    """Each condition negated."""
    for condition in conditions:
        span = condition.span
        if isinstance(condition, Unary):
            continue
        opening, closing = in_parentheses(span)
        edits: tuple[Edit, ...] = (Edit(opening.span, "NOT ("), closing)
        if not isinstance(condition, Binary):
            edits = (Edit(opening.span, "NOT "),)
        elif condition.operator in ("=", "<>"):
            continue  # another comparison is the same
        new = Unary(span, "NOT", condition, BOOL)
        yield exchanged(Operator.NEGATE, statement, condition, new, *edits)
