"""Functions on texts (IEC 61131-3 table 34; TIA Portal help, "Character string")."""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]

ORDINARY = {
    "size": 8,
    "leftPart": "CON",
    "rightPart": "YOR",
    "middle": "ONV",
    "joined": "CONVEYORVE",
    "inserted": "COVEYNVEYOR",
    "deleted": "CEYOR",
    "replaced": "CVEYEYOR",
    "found": 4,
    "short": "CON",
    "less": True,
}


@pytest.mark.parametrize("output", ORDINARY)
def test_functions_inside_the_text(load: Load, output: str) -> None:
    block = load("text.scl").instance("Texts")
    block()
    assert block[output] == ORDINARY[output]


BEYOND = {
    (0, 1): {"leftPart": "", "rightPart": "", "middle": "", "deleted": "CONVEYOR"},
    (0, 2): {"replaced": "CVEYONVEYOR"},
    (99, 1): {"leftPart": "CONVEYOR", "rightPart": "CONVEYOR", "middle": "CONVEYOR", "deleted": ""},
    (3, 99): {"middle": "", "inserted": "CONVEYORVEY", "deleted": "CONVEYOR"},
    (3, 0): {"middle": "", "inserted": "VEYCONVEYOR", "deleted": "", "replaced": ""},
    (-1, 1): {"leftPart": "", "rightPart": "", "middle": "", "deleted": "", "replaced": ""},
    (3, -1): {"middle": "", "inserted": "", "deleted": "", "replaced": ""},
}


@pytest.mark.parametrize("arguments", BEYOND)
def test_functions_beyond_the_text(load: Load, arguments: tuple[int, int]) -> None:
    block = load("text.scl").instance("Texts")
    block(length=arguments[0], position=arguments[1])
    assert {name: block[name] for name in BEYOND[arguments]} == BEYOND[arguments]


@pytest.mark.parametrize("part", ["X", "", "CONVEYORS"])
def test_what_is_not_there_is_found_at_zero(load: Load, part: str) -> None:
    block = load("text.scl").instance("Texts")
    block(part=part)
    assert block.found == 0


@pytest.mark.parametrize(
    ("real", "text"),
    [
        (9123.456, "9.123456E+3"),
        (0.0, "0.000000E+0"),
        (-0.0625, "-6.250000E-2"),
        (float("inf"), "INF"),
        (float("-inf"), "-INF"),
        (float("nan"), "NaN"),
    ],
)
def test_reals_as_text(load: Load, real: float, text: str) -> None:
    block = load("text.scl").instance("Numbers")
    block(real=real)
    assert block.realText == text


@pytest.mark.parametrize(("text", "number"), [("12", 12), ("-32768", -32768), (" +7 ", 7)])
def test_text_as_a_whole_number(load: Load, text: str, number: int) -> None:
    block = load("text.scl").instance("Numbers")
    block(text=text, whole=number)
    assert (block.fromText, block.wholeText) == (number, str(number))


@pytest.mark.parametrize("text", ["", "1 2", "1.5", "16#FF", "32768", "x"])
def test_text_that_is_no_number_of_the_type_is_reported(load: Load, text: str) -> None:
    block = load("text.scl").instance("Numbers")
    with pytest.raises(DiagnosticError) as failure:
        block(text=text)
    diagnostic = failure.value.diagnostics[0]
    assert diagnostic.code == "FB6007"
    assert diagnostic.span is not None
    assert diagnostic.span.text == "STRING_TO_INT(#text)"


@pytest.mark.parametrize(
    ("place", "found", "is_dash", "changed"),
    [
        (1, "A", False, "*-1"),
        (2, "-", True, "A*1"),
        (3, "1", False, "A-*"),
        (4, "\0", False, "A-1"),
        (0, "\0", False, "A-1"),
    ],
)
def test_single_characters(load: Load, place: int, found: str, is_dash: bool, changed: str) -> None:
    block = load("characters.scl").instance("Letters")
    block(word="A-1", place=place)
    assert (block.found, block.isDash, block.changed) == (found, is_dash, changed)
