"""Enumerations and subranges (IEC 61131-3, 6.4.4.3 and 6.4.4.4; CODESYS help, "Enumerations")."""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def block(load: Load) -> BlockInstance:
    return load("enumerations.st").instance("Traffic")


def test_variables_start_with_the_first_enumerator_and_the_lowest_value(
    block: BlockInstance,
) -> None:
    assert (block.fresh, block.named, block.mode) == (0, 5, 1)
    assert (block.i, block.level) == (1, 20)
    assert block.lamp == {"light": 2, "level": 20, "shade": 10}
    assert block.lamps[2].shade == 10


@pytest.mark.parametrize(
    ("wanted", "number", "green", "following"), [("red", 0, False, 5), ("GREEN", 5, True, 6)]
)
def test_values_go_through_the_block(
    block: BlockInstance, wanted: str, number: int, green: bool, following: int
) -> None:
    block(wanted=wanted)
    assert (block.shown, block.number, block.isGreen) == (number, number, green)
    assert block.following == following
    assert block.chosen == (6 if green else 0)
    assert (block.constant, block.modeIsRun, block.lamp.light) == (6, True, 0)


def test_a_value_reads_as_a_number_that_knows_its_name(block: BlockInstance) -> None:
    block(wanted=6)
    shown = block.shown
    assert shown == 6
    assert getattr(shown, "name") == "blue"  # noqa: B009  # it is an Item to the type checker
    block.shown = "Colour#green"
    assert block.shown == 5
    assert getattr(load_name(block), "name") == ""  # noqa: B009  # see above


def load_name(block: BlockInstance) -> object:
    block.fresh = 77
    return block.fresh


def test_a_subrange_calculates_in_its_base(block: BlockInstance) -> None:
    block(raw=99)
    assert (block.half, block.wide, block.level) == (25, 50_007 - 65_536, 99)
    assert block["from"] == 99
    assert block.sum == 6


@pytest.mark.parametrize("raw", [-1, 101])
def test_a_value_outside_of_a_subrange_stops_the_program(block: BlockInstance, raw: int) -> None:
    with pytest.raises(DiagnosticError) as caught:
        block(raw=raw)
    (found,) = caught.value.diagnostics
    assert found.code == "FB6030"
    assert found.message == f"{raw} is outside of INT (0..100)"
    assert found.span is not None
    assert found.span.text == "raw"


@pytest.mark.parametrize(("name", "value"), [("wanted", "pink"), ("level", 101), ("level", -1)])
def test_values_from_outside_are_looked_at(
    block: BlockInstance, name: str, value: str | int
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        block[name] = value
    assert [one.code for one in caught.value.diagnostics] == ["FB6021"]


def test_numbers_and_enumerations_mix_in_twincat(load: Load) -> None:
    block = load("numbers.twincat").instance("Machine")
    block(number=1)
    assert (block.state, block.sum, block.plain) == (10, 11, 1)
    assert (block.isHigh, block.seen) == (True, 9)
