"""ARRAY[*] parameters (IEC 61131-3 third edition, 6.5.3 and table 33; TIA Portal help)."""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def program(load: Load) -> LoadedProgram:
    return load("open_arrays.scl")


def test_bounds_come_with_the_argument(program: LoadedProgram) -> None:
    block = program.instance("Arrays")
    block()
    assert (block.sumShort, block.sumLong) == (6, 150)
    assert (block.low, block.high, block.lowLong, block.highLong) == (-1, 1, 1, 5)


def test_an_input_is_a_copy_and_an_in_out_the_array_itself(program: LoadedProgram) -> None:
    block = program.instance("Arrays")
    block()
    assert block.spoilt == 99
    assert block.long == [10, 20, 30, 40, 8]
    assert block.short == [12, 0, 0]
    assert block.cleared == 12


def test_several_dimensions(program: LoadedProgram) -> None:
    block = program.instance("Arrays")
    block()
    assert block.trace == 5.0
    assert block.square == [-1.0, 2.0, -1.0, 4.0]
    assert block.fixed == 6


def test_arrays_of_any_length_come_from_python(program: LoadedProgram) -> None:
    assert program.call("Sum", values=[]) == 0
    assert program.call("Sum", values=[4, -5, 6, 7]) == 12
    found = program.call_with_outputs("Trace", m=[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])
    assert found.value == 6.0
    assert found.outputs["m"] == [-1.0, 2.0, 3.0, -1.0, 5.0, 6.0]


def test_an_instance_keeps_the_array_it_was_given(program: LoadedProgram) -> None:
    filler = program.instance("Filler")
    filler(value=3, at=1, values=[0, 0])
    filler(value=4, at=0)
    assert filler["values"] == [4, 3]
    assert filler["values"][1] == 3


def test_the_bounds_of_the_argument_are_watched(program: LoadedProgram) -> None:
    with pytest.raises(DiagnosticError) as caught:
        program.call("Spoil", values=[1, 2])
    (found,) = caught.value.diagnostics
    assert found.code == "FB6002"
    assert "the index is 2, the array has 0..1" in found.message
    assert found.span is not None
    assert found.span.text == "values[2]"


def test_rows_from_python_have_one_length(program: LoadedProgram) -> None:
    with pytest.raises(DiagnosticError) as caught:
        program.call("Trace", m=[[1.0], [2.0, 3.0]])
    assert [one.code for one in caught.value.diagnostics] == ["FB6021"]
