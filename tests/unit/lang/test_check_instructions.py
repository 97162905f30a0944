"""Calls of instructions that cannot be: which error, and where."""

import pytest

from fbgen.diagnostics import Severity
from fbgen.lang.checker import check_reporting
from fbgen.lang.parser import parse
from fbgen.source import Source

VARIABLES = """VAR
  timer : TON; on : Bool; bits : Array[0..7] of Bool; more : Array[0..1, 0..7] of Bool;
  word : Word; words : Array[0..3] of Word; number : Int; place : Time;
END_VAR"""


@pytest.mark.parametrize(
    ("call", "code", "where"),
    [
        ("RESET_TIMER(#on);", "FB4010", "#on"),
        ("RESET_TIMER(TIMER => #timer);", "FB4041", "TIMER => #timer"),
        ("PRESET_TIMER(TIMER := #timer);", "FB4040", "PRESET_TIMER(TIMER := #timer)"),
        ("PRESET_TIMER(PT := #on, TIMER := #timer);", "FB4010", "#on"),
        ("SCATTER(IN := #word, OUT => #bits);", "FB4075", "#bits"),
        ("SCATTER(IN := #word.%B0, OUT => #more);", "FB4075", "#more"),
        ("SCATTER(IN := #number, OUT => #bits);", "FB4075", "#number"),
        ("SCATTER(IN := #word, OUT := #bits);", "FB4041", "OUT := #bits"),
        ("GATHER(IN := #bits, OUT => #word);", "FB4075", "#bits"),
        ("GATHER(IN := #bits);", "FB4040", "GATHER(IN := #bits)"),
        ("SCATTER_BLK(IN := #word, COUNT_IN := 1, OUT => #bits[0]);", "FB4075", "#word"),
        ("GATHER_BLK(IN := #bits[0], COUNT_OUT := 1, OUT => #number);", "FB4075", "#number"),
        ("GATHER_BLK(IN := #words[0], COUNT_OUT := 1, OUT => #words[0]);", "FB4075", "#words[0]"),
        ("T_ADD(IN1 := T#1s, IN2 := T#2s, OUT => #word);", "FB4011", "T_ADD(IN1"),
        ("T_ADD(IN1 := T#1s, IN2 := T#2s);", "FB4049", "T_ADD(IN1"),
        ("READ_BIG(SRC_ARRAY := #words, DEST_VARIABLE => #number, POS := #word);", "FB4075", "#wo"),
    ],
)
def test_calls_that_cannot_be(call: str, code: str, where: str) -> None:
    text = f'FUNCTION_BLOCK "F"\n{VARIABLES}\nBEGIN\n{call}\nEND_FUNCTION_BLOCK\n'
    _, findings = check_reporting([parse(Source("f.scl", text), "tia")], "tia")
    (found,) = [one for one in findings if one.severity is Severity.ERROR]
    assert found.code == code
    assert found.span is not None
    assert found.span.text.startswith(where)
    assert found.help
