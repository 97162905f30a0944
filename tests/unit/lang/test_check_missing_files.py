"""What the checker says where a file of the project, or a library, is not there."""

import pytest
from checking import errors_of, in_program

_TEST_SUITE = (
    "FUNCTION_BLOCK Suite EXTENDS FB_TestSuite\n"
    "METHOD Adds : BOOL\nVAR n : INT; END_VAR\n"
    "TEST('adds');\nn := 1 + inherited;\nSUPER^.Adds();\nTHIS^.AssertTrue(n = 2);\nEND_METHOD\n"
    "Adds();\nEND_FUNCTION_BLOCK\n"
)


def _said(text: str) -> list[tuple[str, str]]:
    return [(one.code, one.message) for one in errors_of(text, "twincat")]


def test_a_missing_name_is_reported_once_with_all_places() -> None:
    text = in_program("x : INT;", "x := Limits.low;\nx := Limits.high;") + in_program(
        "y : INT;", "y := Limits.low;"
    ).replace("main", "other")
    (error,) = errors_of(text, "twincat")
    assert error.message == "no variable or constant is called 'Limits'"
    assert [note.span.line for note in error.notes if note.span is not None] == [4, 8]


def test_what_a_missing_base_may_have_is_not_asked_for() -> None:
    assert _said(_TEST_SUITE) == [("FB4003", "there is no type 'FB_TestSuite'")]


def test_instances_of_a_block_with_a_missing_base_take_any_input_and_member() -> None:
    derived = (
        "FUNCTION_BLOCK Axis EXTENDS AnyAxis\nVAR_INPUT own : INT; END_VAR\nEND_FUNCTION_BLOCK\n"
    )
    text = derived + in_program(
        "a : Axis; x : INT;",
        "a(own := 1, enable := TRUE);\nx := a.position;\na.Stop();\nx := lost;",
    )
    assert _said(text) == [
        ("FB4003", "there is no type 'AnyAxis'"),
        ("FB4001", "no variable or constant is called 'lost'"),
    ]


@pytest.mark.parametrize(
    ("name", "library"),
    [
        ("MC_Power", "Tc2_MC2"),
        ("FB_FormatString", "Tc2_Utilities"),
        ("FB_TestSuite", "TcUnit"),
        ("BLINK", "Util"),
        ("ST_LibVersion", "Tc2_System"),
    ],
)
def test_a_name_of_a_well_known_library_names_the_library(name: str, library: str) -> None:
    (error,) = errors_of(in_program(f"x : {name};", ";"), "twincat")
    assert error.code == "FB4003"
    assert error.help.startswith(f"it comes from the library {library}:")


def test_a_slip_of_the_pen_is_still_guessed() -> None:
    (error,) = errors_of(in_program("speed : INT;", "sped := 1;"), "twincat")
    assert error.help == "did you mean 'speed'?"
