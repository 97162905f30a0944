"""What stops a running program: both engines report the same thing at the same place."""

from pathlib import Path

import pytest

from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness import load_program
from harness.engine.interface import Limits

BAD = Path(__file__).parents[2] / "unit" / "bad"
TIGHT = Limits(loop_passes=1000, call_depth=2)

PLACES = {
    "FB6001_no_hardware": (7, 16, "DPRD_DAT needs a controller with hardware"),
    "FB6002_index_out_of_range": (9, 11, "the index is 4, the array has 1..3"),
    "FB6002_second_index": (7, 5, "index 2 is -2, the array has -1..1"),
    "FB6002_in_argument": (9, 50, "the index is 43, the array has 1..3"),
    "FB6003_division_by_zero": (9, 9, "division by zero"),
    "FB6003_remainder_of_zero": (7, 15, "division by zero"),
    "FB6004_endless_while": (7, 5, "'WHILE NOT #done DO': more than 1000 loop passes"),
    "FB6004_endless_repeat_in_for": (8, 9, "'REPEAT': more than 1000 loop passes"),
    "FB6004_for_that_is_set_back": (6, 5, "'FOR #i := 1 TO 3 DO': more than 1000"),
    "FB6005_nested_too_deep": (8, 16, "the call of 'Third' is nested more than 2 deep"),
    "FB6006_real_too_large": (7, 15, "50000.0 does not fit into INT"),
    "FB6007_text_is_no_number": (7, 15, "the text '12 Hz' cannot be read as INT"),
    "FB6008_step_is_zero": (7, 5, "the step of this FOR is 0"),
    "FB6009_mux_selector": (7, 19, "MUX has the inputs 0..1, the selector is 2"),
    "FB6010_address_behind_the_memory": (3, 5, "%MW1023 lies outside of its area"),
    "FB6013_instance_as_area": (7, 52, "a variable of type TON cannot be used as an area"),
    "FB6014_not_decimal": (7, 15, "16#01A3 is not binary coded decimal"),
    "FB6041_too_many_elements": (4, 3, "FILL_BLK works on 8 elements, the array has 5"),
    "FB6040_unknown_area": (4, 9, "there is no memory area 16#85"),
    "FB6015_no_such_day": (7, 13, "2023-2-29 is not in the calendar"),
    "FB6016_stop": (7, 9, "the program stops the CPU"),
    "FB6070_no_stub": (7, 15, "nobody has said what GET_DIAG(MODE) does"),
}


def fault(name: str, engine_name: str) -> Diagnostic:
    program = load_program([BAD / f"{name}.scl"], engine=engine_name, limits=TIGHT)
    block = program.instance("Faulty")
    with pytest.raises(DiagnosticError) as failure:
        block()
    (diagnostic,) = failure.value.diagnostics
    return diagnostic


@pytest.mark.parametrize("name", PLACES)
def test_a_fault_has_its_code_place_and_message(name: str, engine_name: str) -> None:
    diagnostic = fault(name, engine_name)
    line, column, message = PLACES[name]
    assert diagnostic.code == name[:6]
    assert diagnostic.span is not None
    assert (diagnostic.span.line, diagnostic.span.column) == (line, column)
    assert message in diagnostic.message
    assert diagnostic.help


def test_the_watchdog_counts_anew_for_each_call(engine_name: str) -> None:
    program = load_program(
        [Path(__file__).with_name("hundred_passes.scl")],
        engine=engine_name,
        limits=Limits(loop_passes=100),
    )
    block = program.instance("HundredPasses")
    block(last=100)
    block(last=100)
    with pytest.raises(DiagnosticError, match="FB6004"):
        block(last=101)


def test_a_program_whose_in_out_nobody_connects_is_reported(engine_name: str) -> None:
    path = BAD / "FB6012_program_with_in_out.st"
    program = load_program([path], dialect="iec", engine=engine_name)
    with pytest.raises(DiagnosticError, match="FB6012") as failure:
        program.run("Faulty")
    span = failure.value.diagnostics[0].span
    assert span is not None
    assert (span.line, span.column) == (8, 14)


def test_the_watchdog_counts_the_loops_of_called_blocks_too(engine_name: str) -> None:
    program = load_program(
        [Path(__file__).with_name("hundred_passes.scl")],
        engine=engine_name,
        limits=Limits(loop_passes=100),
    )
    with pytest.raises(DiagnosticError, match="FB6004"):
        program.instance("Outer")()


@pytest.mark.parametrize(
    ("which", "notes"),
    [
        (0, ["#total = 40", "#parts = 7"]),
        (1, ["#row = 2"]),
        (2, ["#row = 4"]),
        (3, ["#text = '12 Hz'"]),
        (4, ["#which = 4"]),
        (5, ["#wait.PT = T#1s", "#limit = 16#0010", "#limit.%B1 = 16#00"]),
    ],
)
def test_the_values_of_what_failed_stand_beside_it(
    which: int, notes: list[str], engine_name: str
) -> None:
    program = load_program([Path(__file__).with_name("values_in_notes.scl")], engine=engine_name)
    block = program.instance("Mixing")
    with pytest.raises(DiagnosticError) as failure:
        block(which=which, total=40, parts=7, text="12 Hz")
    assert [note.message for note in failure.value.diagnostics[0].notes] == notes
