"""Small pieces of tree that lowering builds; each takes the span of what it stands for."""

from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    Binary,
    Call,
    Expression,
    Literal,
    LiteralKind,
    Name,
    Parenthesized,
    Trivia,
    TriviaKind,
)
from fbgen.lang.printer.lines import block_comment
from fbgen.source import Span


def integer(place: Span, value: int, text: str = "") -> Literal:
    """An untyped whole number."""
    return Literal(place, LiteralKind.INTEGER, value, text or str(value))


def bits(place: Span, type_name: str, value: int, width: int) -> Literal:
    """A bit string such as WORD#16#00FF."""
    text = f"{type_name}#16#{value:0{width // 4}X}"
    return Literal(place, LiteralKind.INTEGER, value, text, type_name, 16)


def call(place: Span, function: str, *arguments: Expression) -> Call:
    """A function with positional arguments."""
    return Call(
        place,
        Name(place, function),
        tuple(Argument(place, ArgumentKind.POSITIONAL, "", one) for one in arguments),
    )


def binary(place: Span, operator: str, left: Expression, right: Expression) -> Parenthesized:
    """Two operands in parentheses."""
    return Parenthesized(place, Binary(place, operator, left, right))


def comment(place: Span, text: str) -> Trivia:
    """A comment of its own."""
    return Trivia(place, TriviaKind.BLOCK_COMMENT, block_comment(text))
