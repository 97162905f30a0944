"""LIMIT whose lower limit lies above the upper one.

TIA Portal help, "LIMIT: Set limit value": IN comes out and ENO is FALSE. IEC 61131-3, table 33:
LIMIT is MIN(MAX(IN, MN), MX), so MX comes out.
"""

from itertools import pairwise

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.conversion import convert
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_generated
from fbgen.source import Source
from harness import load_program

DIALECTS = ("tia", "step7", "iec", "twincat")
TEXT = """
FUNCTION_BLOCK B
VAR_INPUT
  low, x, high : INT;
END_VAR
VAR_OUTPUT
  y, half, fixed : INT;
  letter : REAL;
END_VAR
{begin}
  {m}y := LIMIT(MN := {m}low, IN := {m}x, MX := {m}high);
  {m}half := LIMIT(MN := 5, IN := ABS({m}x) / 2, MX := {m}high - 1);
  {m}fixed := LIMIT(MN := -3, IN := {m}x, MX := 3);
  {m}letter := LIMIT(MN := 9.0, IN := INT_TO_REAL({m}x), MX := 1.0);
END_FUNCTION_BLOCK
"""
VALUES = [(0, 5, 10), (10, 5, 0), (10, -5, 0), (10, 15, 0), (3, 3, 3), (4, 3, 3), (-2, 7, -1)]


def text_in(dialect: str) -> str:
    s7 = dialect in ("tia", "step7")
    return TEXT.format(begin="BEGIN" if s7 else "", m="#" if dialect == "tia" else "")


def results(text: str, dialect: str, engine: str) -> list[tuple[object, ...]]:
    block = load_program([Source("b.scl", text)], dialect, engine=engine).instance("B")
    seen = []
    for low, x, high in VALUES:
        block(low=low, x=x, high=high)
        seen.append((block.y, block.half, block.fixed, block.letter))
    return seen


@pytest.mark.parametrize("dialect", DIALECTS)
def test_limits_that_cross_limit_nothing_on_tia_and_give_mx_elsewhere(
    dialect: str, engine_name: str
) -> None:
    passes = dialect == "tia"
    crossed = [5, -5, 15] if passes else [0, 0, 0]
    expected = [5, *crossed, 3, 3, -1]
    seen = results(text_in(dialect), dialect, engine_name)
    assert [row[0] for row in seen] == expected
    assert [row[2] for row in seen] == [max(-3, min(x, 3)) for _, x, _ in VALUES]
    assert [row[3] for row in seen] == [float(x) if passes else 1.0 for _, x, _ in VALUES]


@pytest.mark.parametrize("source", DIALECTS)
@pytest.mark.parametrize("target", DIALECTS)
def test_a_conversion_keeps_what_comes_out(source: str, target: str, engine_name: str) -> None:
    converted = convert([parse(Source("b.scl", text_in(source)), source)], target)
    printed = "".join(print_generated(one).text for one in converted)
    wanted = results(text_in(source), source, engine_name)
    assert results(printed, target, engine_name) == wanted


def test_constant_limits_in_order_stay_as_they_were() -> None:
    (converted,) = convert([parse(Source("b.scl", text_in("tia")), "tia")], "iec")
    assert "fixed := LIMIT(-3, x, 3);" in print_generated(converted).text


def test_a_call_that_would_happen_twice_is_refused() -> None:
    text = (
        'FUNCTION "Next" : INT\nBEGIN\n"Next" := 1;\nEND_FUNCTION\n'
        'FUNCTION_BLOCK "B"\nVAR a, y : INT; END_VAR\nBEGIN\n'
        '#y := LIMIT(MN := #a, IN := "Next"(), MX := 3);\nEND_FUNCTION_BLOCK\n'
    )
    with pytest.raises(DiagnosticError) as refused:
        convert([parse(Source("b.scl", text), "tia")], "iec")
    (found,) = refused.value.diagnostics
    assert (found.code, found.span and found.span.line) == ("FB3051", 8)


def test_eno_tells_that_the_limits_cross(engine_name: str) -> None:
    text = (
        'FUNCTION_BLOCK "B"\nVAR_INPUT low, x, high : REAL; END_VAR\n'
        "VAR_OUTPUT y : REAL; ok : BOOL; END_VAR\nBEGIN\n"
        "#y := LIMIT(MN := #low, IN := #x, MX := #high, ENO => #ok);\nEND_FUNCTION_BLOCK\n"
    )
    block = load_program([Source("b.scl", text)], "tia", engine=engine_name).instance("B")
    seen = []
    for low, high in pairwise((1.0, 2.0, 2.0, 1.5)):
        block(low=low, x=9.0, high=high)
        seen.append((block.y, block.ok))
    assert seen == [(2.0, True), (2.0, True), (9.0, False)]
