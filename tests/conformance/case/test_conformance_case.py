"""CASE takes the first arm that has the value, else ELSE, and goes on behind END_CASE."""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program

Load = Callable[[str], LoadedProgram]


@pytest.mark.parametrize(
    ("selector", "chosen"),
    [(-6, 5), (-5, 1), (-1, 1), (0, 2), (1, 3), (2, 5), (3, 3), (9, 5), (10, 3), (12, 3), (13, 5)],
)
def test_the_arm_with_the_value_is_taken(load: Load, selector: int, chosen: int) -> None:
    block = load("case.scl").instance("Choose")
    block(selector=selector)
    assert block.chosen == chosen


@pytest.mark.parametrize(("pattern", "expected"), [(0, 1), (1, 0), (0xEF, 0), (0xF0, 2), (0xFF, 2)])
def test_a_bit_string_selects_too_and_without_else_nothing_happens(
    load: Load, pattern: int, expected: int
) -> None:
    block = load("case.scl").instance("Choose")
    block(selector=32767, pattern=pattern)
    assert (block.chosen, block.byPattern) == (4, expected)


def test_return_inside_an_arm_leaves_the_block(load: Load) -> None:
    block = load("case.scl").instance("Choose")
    block(selector=11, pattern=0xFF)
    assert (block.chosen, block.byPattern) == (3, 0)


BY_CHARACTER = """
FUNCTION_BLOCK F
VAR_INPUT c : {kind}; END_VAR
VAR_OUTPUT y : INT; END_VAR
CASE c OF
  {quote}a{quote}, {quote}c{quote}..{quote}f{quote}: y := 1;
  {quote}b{quote}: y := 2;
ELSE
  y := 3;
END_CASE;
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(("kind", "quote"), [("CHAR", "'"), ("WCHAR", '"')])
def test_a_character_selects_in_iec(engine_name: str, kind: str, quote: str) -> None:
    """IEC 61131-3, table 72: the selector is of an elementary type."""
    text = BY_CHARACTER.format(kind=kind, quote=quote)
    block = load_program([Source("f.st", text)], "iec", engine_name).instance("F")
    seen = []
    for character in "abcfgA":
        block(c=character)
        seen.append(block.y)
    assert seen == [1, 2, 1, 1, 3, 3]


def test_a_character_selects_nothing_on_s7() -> None:
    """TIA Portal help, "CASE": an integer or a bit string."""
    text = (
        "FUNCTION_BLOCK F\nVAR_INPUT c : CHAR; y : INT; END_VAR\nBEGIN\n"
        "CASE #c OF\n'a': #y := 1;\nEND_CASE;\nEND_FUNCTION_BLOCK\n"
    )
    with pytest.raises(DiagnosticError) as refused:
        load_program([Source("f.scl", text)])
    assert refused.value.diagnostics[0].code == "FB4031"
