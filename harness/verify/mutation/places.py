"""Where the operators look: every expression of a block, with the statement that it stands in."""

from collections.abc import Iterator, Sequence
from typing import TypeVar

from fbgen.dataclass import dataclass
from fbgen.lang.checked import (
    Assignment,
    Binary,
    Case,
    Convert,
    Evaluate,
    Expression,
    For,
    Guarded,
    If,
    InstanceCall,
    Repeat,
    Statement,
    Try,
    Unary,
    While,
)
from fbgen.source import Span
from harness.verify.mutation.mutant import Edit
from harness.verify.mutation.rebuilding import Node, is_node, parts_of

Found = TypeVar("Found")


@dataclass(frozen=True, slots=True)
class Seat:
    """An expression that is read, and what is around it: `parent` None right in the statement."""

    statement: Statement
    expression: Expression
    parent: Expression | None


def every_statement(body: Sequence[Statement]) -> Iterator[Statement]:
    """All statements, those inside of others too, in the order of the text."""
    for statement in body:
        yield statement
        for inner in inner_lists(statement):
            yield from every_statement(inner)


def inner_lists(statement: Statement) -> tuple[tuple[Statement, ...], ...]:
    """The lists of statements inside of a statement."""
    match statement:
        case If():
            return (*(branch.body for branch in statement.branches), statement.otherwise)
        case Case():
            return (*(arm.body for arm in statement.arms), statement.otherwise)
        case For() | While() | Repeat():
            return (statement.body,)
        case Try():
            return (statement.body, statement.catch, statement.final)
        case Guarded():
            return ((statement.statement,),)
        case _:
            return ()


def read_by(statement: Statement) -> tuple[Expression, ...]:
    """The expressions that a statement itself reads, not those of the statements inside of it."""
    match statement:
        case Assignment():
            return (statement.target, statement.value)
        case If():
            return tuple(branch.condition for branch in statement.branches)
        case Case():
            return (statement.selector,)
        case For():
            return (statement.first, statement.last, statement.step)
        case While() | Repeat():
            return (statement.condition,)
        case InstanceCall():
            return tuple(value for _, value in statement.inputs)
        case Evaluate():
            return (statement.call,)
        case _:
            return ()


def every_seat(body: Sequence[Statement]) -> Iterator[Seat]:
    """All expressions that are read, outer ones before what is in them."""
    for statement in every_statement(body):
        for expression in read_by(statement):
            yield from _seats(statement, expression, None)


def _seats(
    statement: Statement, expression: Expression, parent: Expression | None
) -> Iterator[Seat]:
    yield Seat(statement, expression, parent)
    for inner in expressions_in(expression):
        yield from _seats(statement, inner, expression)


def expressions_in(node: Node) -> Iterator[Expression]:
    """What stands directly inside of an expression."""
    for name in parts_of(node):
        yield from _nodes(getattr(node, name))


def _nodes(item: object) -> Iterator[Expression]:
    if isinstance(item, tuple):
        for part in item:
            yield from _nodes(part)
    elif is_node(item):
        yield item  # type: ignore[misc]


def written(expression: Expression) -> Expression:
    """An expression without the conversions that nobody wrote."""
    while isinstance(expression, Convert) and expression.implicit:
        expression = expression.operand
    return expression


# --- parentheses ----------------------------------------------------------------------------------


def wrapped(text: str) -> bool:
    """True for a text that one pair of parentheses encloses."""
    text = text.strip()
    if not (text.startswith("(") and text.endswith(")")):
        return False
    depth = 0
    for place, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if depth == 0 and place < len(text) - 1:
            return False
    return True


def stands_in_parentheses(span: Span) -> bool:
    """True if parentheses, or those of a call, enclose just this piece of text."""
    text = span.source.text
    return text[: span.start].rstrip().endswith("(") and text[span.end :].lstrip()[:1] == ")"


def in_parentheses(span: Span) -> tuple[Edit, Edit]:
    """Parentheses around a piece of text."""
    start = Span(span.source, span.start, span.start)
    end = Span(span.source, span.end, span.end)
    return Edit(start, "("), Edit(end, ")")


def is_operation(expression: Expression | None) -> bool:
    """True for what binds its operands, so that they may need parentheses."""
    return isinstance(expression, Binary | Unary)
