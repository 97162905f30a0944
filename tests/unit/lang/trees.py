"""Reading, comparing and searching syntax trees for the tests of this folder."""

from dataclasses import fields, is_dataclass

from fbgen.diagnostics import Diagnostic
from fbgen.lang import ast
from fbgen.lang.parser import parse, parse_recovering
from fbgen.source import Source, Span

_TRIVIA_SLOTS = {
    "leading",
    "trailing",
    "closing",
    "opening",
    "header_comments",
    "body_comments",
}


def read(text: str, dialect: str = "tia") -> ast.File:
    """The tree of a text without errors."""
    return parse(Source("test", text), dialect)


def found_in(text: str, dialect: str = "tia") -> list[Diagnostic]:
    """What is wrong with a text."""
    return parse_recovering(Source("test", text), dialect)[1]


def body(
    statements: str, dialect: str = "tia", declarations: str = ""
) -> tuple[ast.Statement, ...]:
    """The statements of a block."""
    name, begin = ('"B"', "BEGIN") if dialect == "tia" else ("B", "")
    text = f"FUNCTION_BLOCK {name}\n{begin}\n{statements}\nEND_FUNCTION_BLOCK\n"
    unit = read(text, dialect).units[0]
    assert isinstance(unit, ast.Block)
    return unit.body


def value(expression: str, dialect: str = "tia") -> ast.Expression:
    """The tree of an expression."""
    (statement,) = body(f"x := {expression};", dialect)
    assert isinstance(statement, ast.Assignment)
    return statement.value


def shape(node: object) -> object:
    """A tree as nested tuples, without places and comments, to compare two of them.

    Header lines are sorted, as printing brings them into the order of TIA Portal.
    """
    if isinstance(node, (Span, Source)):
        return None
    if isinstance(node, tuple):
        return tuple(shape(item) for item in node)
    if is_dataclass(node) and not isinstance(node, type):
        parts = tuple(
            (field.name, shape(_in_order(getattr(node, field.name))))
            for field in fields(node)
            if field.name not in _TRIVIA_SLOTS and field.name != "source"
        )
        return (type(node).__name__, *parts)
    return node


def _in_order(value: object) -> object:
    if isinstance(value, tuple) and value and isinstance(value[0], ast.HeaderItem):
        return tuple(sorted(value, key=lambda item: (item.keyword, item.text)))
    return value


def comments(node: object) -> list[str]:
    """The text of all comments of a tree, sorted."""
    found: list[str] = []
    waiting: list[object] = [node]
    while waiting:
        item = waiting.pop()
        if isinstance(item, ast.Trivia):
            if item.text:
                found.append(item.text)
        elif isinstance(item, (Span, Source)):
            continue
        elif isinstance(item, tuple):
            waiting.extend(item)
        elif is_dataclass(item) and not isinstance(item, type):
            waiting.extend(getattr(item, field.name) for field in fields(item))
    return sorted(found)
