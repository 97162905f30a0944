"""Calls from outside: what is accepted, what is refused, and the fast call by keyword."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness.engine.compiled import CompiledEngine, CompiledInstance
from harness.engine.environment import StandaloneEnvironment
from harness.engine.loading import read_program

TEXT = """
TYPE "typePair" STRUCT a : INT; b : REAL; END_STRUCT; END_TYPE
FUNCTION_BLOCK "Adder"
VAR_INPUT
    flag : BOOL; number : INT; "type" : USINT; real : REAL; text : STRING[4]; pair : "typePair";
END_VAR
VAR_OUTPUT sum : DINT; calls : INT; END_VAR
VAR_IN_OUT total : DINT; END_VAR
VAR i : INT; END_VAR
BEGIN
    #sum := #number + #"type" + #pair.a + REAL_TO_INT(#real) + LEN(#text);
    IF #flag THEN #sum := -#sum; END_IF;
    #total := #total + #sum;
    #calls := #calls + 1;
    FOR #i := 1 TO #number DO ; END_FOR;
END_FUNCTION_BLOCK
"""


@pytest.fixture
def adder() -> CompiledInstance:
    program = read_program([Source("adder.scl", TEXT)])
    return CompiledEngine(program, StandaloneEnvironment()).instance("Adder")


def test_inputs_that_are_not_given_keep_their_value(adder: CompiledInstance) -> None:
    adder.call({"number": 5, "TYPE": 2, "pair": {"a": 10}})
    adder.call({"real": 2.5})
    assert (adder.get("sum"), adder.get("calls"), adder.get("total")) == (19, 2, 36)


def test_the_call_by_keyword_does_the_same(adder: CompiledInstance) -> None:
    call = adder.keyword_call(dict)
    adder.call({"pair": {"a": 10}})
    call(number=5, type=2)
    call(real=2.5, flag=True)
    call(text="abcd", flag=False)
    assert (adder.get("sum"), adder.get("calls"), adder.get("total")) == (23, 4, 31)


def test_the_call_by_keyword_works_before_any_other(adder: CompiledInstance) -> None:
    adder.keyword_call(dict)(number=3)
    assert adder.get("total") == 3


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("flag", 1),
        ("flag", None),
        ("number", 32_768),
        ("number", -32_769),
        ("number", True),
        ("number", 1.0),
        ("type", -1),
        ("real", "1.0"),
        ("text", "abcde"),
        ("text", 5),
    ],
)
def test_values_that_an_input_cannot_hold_are_refused(
    adder: CompiledInstance, name: str, value: object
) -> None:
    with pytest.raises(DiagnosticError, match="FB6021") as failure:
        adder.keyword_call(dict)(**{name: value})
    with pytest.raises(DiagnosticError) as second_failure:
        adder.call({name: value})  # type: ignore[dict-item]  # wrong on purpose
    assert name in str(failure.value)
    assert str(second_failure.value) == str(failure.value)
    assert adder.get("calls") == 0


def test_whole_numbers_are_fine_for_a_real(adder: CompiledInstance) -> None:
    adder.keyword_call(dict)(real=3)
    assert adder.get("real") == 3.0
    assert isinstance(adder.get("real"), float)


def test_what_stops_a_call_by_keyword_is_a_diagnostic(adder: CompiledInstance) -> None:
    with pytest.raises(DiagnosticError, match="FB6006"):
        adder.keyword_call(dict)(real=1.0e9)


def test_standard_blocks_are_called_in_the_same_ways() -> None:
    program = read_program([Source("empty.scl", TEXT)])
    counter = CompiledEngine(program, StandaloneEnvironment()).instance("CTU")
    counter.call({"CU": True, "pv": 2})
    counter.keyword_call(dict)(CU=False)
    counter.keyword_call(dict)(CU=True)
    assert (counter.get("CV"), counter.get("Q")) == (2, True)
    with pytest.raises(DiagnosticError, match="FB6020"):
        counter.call({"CD": True})


def test_a_snapshot_is_a_state_of_any_instance_of_the_block(adder: CompiledInstance) -> None:
    adder.call({"number": 5, "pair": {"a": 1, "b": 0.5}, "text": "ab"})
    kept = adder.snapshot()
    adder.call({"number": 6, "pair": {"a": 2}})
    assert adder.snapshot() != kept
    adder.restore(kept)
    assert adder.snapshot() == kept
    assert (adder.get("number"), adder.get("pair")) == (5, {"a": 1, "b": 0.5})
