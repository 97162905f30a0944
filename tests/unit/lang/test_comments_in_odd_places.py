"""Comments in the middle of things stay, in front of what they stood in, and fmt is stable."""

import pytest
from trees import comments

from fbgen.lang.parser import parse
from fbgen.lang.printer import print_generated
from fbgen.source import Source

_DECLARED = (
    "   list (* c *): ARRAY[0..1] OF INT := [2(0)];",
    "   list : ARRAY (* c *)[0..1] OF INT := [2(0)];",
    "   list : ARRAY[0..1] OF INT := [#LAST(0 (* c *))];",
    "   list : ARRAY[0..1] OF INT := ['MAX' (* c *), 2(0)];",
    "   point : typePoint := (1 (* c *), , (2, 3));",
    "   point : typePoint := (1, // c\n , (2, 3));",
)
_STATED = (
    "#x (* c *):= EB(1):P;",
    "#x := EB(1 (* c *)):P;",
    '"values".DW (* c *)(#i) := 3;',
    "#x := #y // c\n + 1;",
)


def _stable(text: str, dialect: str = "tia") -> str:
    """The text in its layout, which keeps the comments and does not change any more."""
    tree = parse(Source("odd", text), dialect)
    once = print_generated(tree).text
    again = parse(Source("again", once), dialect)
    assert len(comments(again)) == len(comments(tree)) == 1
    assert print_generated(again).text == once
    return once


@pytest.mark.parametrize("declaration", _DECLARED)
def test_comments_in_declarations_stay(declaration: str) -> None:
    _stable(f'FUNCTION_BLOCK "U"\nVAR\n{declaration}\nEND_VAR\nBEGIN\n;\nEND_FUNCTION_BLOCK\n')


@pytest.mark.parametrize("statement", _STATED)
def test_comments_in_statements_stay(statement: str) -> None:
    _stable(f'FUNCTION_BLOCK "U"\nBEGIN\n{statement}\nEND_FUNCTION_BLOCK\n')


def test_a_comment_in_a_header_line_stays_in_it() -> None:
    text = 'FUNCTION "U" : Void\nVERSION : (* c *) 0.1\nBEGIN\n;\nEND_FUNCTION\n'
    once = print_generated(parse(Source("odd", text), "tia")).text
    assert once.splitlines()[1] == "VERSION : (* c *) 0.1"
    assert print_generated(parse(Source("again", once), "tia")).text == once


def test_a_comment_in_front_of_the_first_statement_of_a_method_belongs_to_it() -> None:
    text = _stable(
        "FUNCTION_BLOCK U\nMETHOD Work : BOOL\n(* c *)\nWork := TRUE;\nEND_METHOD\n"
        "END_FUNCTION_BLOCK\n",
        "iec",
    )
    assert "        (* c *)\n        Work := TRUE;\n" in text
