"""VARIANT and ANY handed over from Python: a value with its type, or a variable of the program."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram, load_program

_PROGRAM = Path(__file__).with_name("outside.scl")


@pytest.fixture
def program(engine_name: str) -> LoadedProgram:
    return load_program([_PROGRAM], engine=engine_name)


def test_a_value_has_the_type_that_is_said(program: LoadedProgram) -> None:
    block = program.instance("Outside")
    value = program.variant("Int", 5)
    block(what=value)
    assert (block["isInt"], block["isPoint"], block["count"]) == (True, False, 0)
    assert (block["number"], value.value) == (6, 6)


def test_structures_and_arrays_have_their_declared_names_and_bounds(program: LoadedProgram) -> None:
    block = program.instance("Outside")
    point = program.variant('"typePoint"', {"x": 3, "y": 0.5})
    block(what=point)
    assert block["isPoint"]
    assert point.value == {"x": 6, "y": 0.5}
    block(what=program.variant("ARRAY[1..7] OF BYTE", [1, 2, 3, 4, 5, 6, 7]))
    assert block["count"] == 7


def test_a_variable_of_the_program_is_handed_over_itself(program: LoadedProgram) -> None:
    block = program.instance("Outside")
    block(what=program.reference("Store.number"))
    assert program.globals["Store"]["number"] == 42
    program.globals["Store"]["point"] = {"x": 5}
    block(what=program.reference("Store.point"))
    assert program.globals["Store"]["point"]["x"] == 10
    element = program.reference("Store.list[2]")
    element.value = 7
    block(what=element)
    assert list(program.globals["Store"]["list"]) == [0, 0, 8, 0]


def test_an_input_keeps_what_was_handed_over(program: LoadedProgram) -> None:
    block = program.instance("Outside")
    value = program.variant("Int")
    block(what=value)
    block()
    assert value.value == 2
    block(what=False)
    assert (block["isInt"], block["number"]) == (False, 2)


def test_an_any_has_an_address(program: LoadedProgram) -> None:
    assert program.call("First", area=program.variant("ARRAY[0..3] OF BYTE", [9, 8, 7, 6])) == 209
    assert program.call("First", area=program.variant("WORD", 0x0708)) == 407


@pytest.mark.parametrize(
    ("type_name", "value", "code"),
    [
        ("Int", 100_000, "FB6021"),
        ("Int", "text", "FB6021"),
        ('"typeOther"', None, "FB6020"),
        ("ARRAY[0..n] OF INT", None, "FB6024"),
        ("STRUCT x : INT; END_STRUCT", None, "FB6024"),
        ("5", None, "FB6024"),
    ],
)
def test_what_cannot_be_handed_over(
    program: LoadedProgram, type_name: str, value: int | str | None, code: str
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        program.variant(type_name, value)
    assert [one.code for one in failure.value.diagnostics] == [code]


@pytest.mark.parametrize("given", [5, True, "Store.number"])
def test_a_plain_value_has_no_type(program: LoadedProgram, given: int | str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        program.instance("Outside")(what=given)
    (found,) = failure.value.diagnostics
    assert found.code == "FB6021"
    assert "program.variant('INT', 5)" in found.message
    with pytest.raises(DiagnosticError) as failure:
        program.call("First", area=given)
    assert failure.value.diagnostics[0].code == "FB6021"
