"""What the checker says about interfaces, FB_init, classes, and what cannot run."""

import pytest
from checking import errors_of, hints_of

_SHAPE = (
    "INTERFACE Shape\nMETHOD Area : INT\nVAR_INPUT a : INT; END_VAR\nEND_METHOD\nEND_INTERFACE\n"
)
_PUMP = (
    "FUNCTION_BLOCK Pump\nMETHOD FB_init : BOOL\n"
    "VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; number : INT; END_VAR\n"
    "END_METHOD\nEND_FUNCTION_BLOCK\n"
)


def _codes(text: str, dialect: str = "twincat") -> list[tuple[str, str]]:
    return [
        (one.code, one.span.text if one.span is not None else "")
        for one in errors_of(text, dialect)
    ]


@pytest.mark.parametrize(
    "method",
    [
        "METHOD Area : INT\nVAR_INPUT a : DINT; END_VAR\nArea := 1;\nEND_METHOD\n",
        "METHOD Area : INT\nVAR_INPUT b : INT; END_VAR\nArea := 1;\nEND_METHOD\n",
        "METHOD Area : DINT\nVAR_INPUT a : INT; END_VAR\nArea := 1;\nEND_METHOD\n",
        "METHOD Area\nVAR_INPUT a : INT; END_VAR\nEND_METHOD\n",
    ],
)
def test_implements_compares_parameters_and_results(method: str) -> None:
    text = f"{_SHAPE}FUNCTION_BLOCK Square IMPLEMENTS Shape\n{method}END_FUNCTION_BLOCK\n"
    assert _codes(text) == [("FB4086", "Area")]


@pytest.mark.parametrize(
    ("statement", "code", "place"),
    [
        ("shape := other;", "FB4010", "other"),
        ("shape := 5;", "FB4010", "5"),
        ("x := shape.Width;", "FB4005", "shape.Width"),
        ("x := shape^.Area(a := 1);", "FB4092", "shape^"),
        ("x := shape.Area(b := 1);", "FB4006", "b := 1"),
    ],
)
def test_variables_of_interfaces_take_and_give_what_the_interface_says(
    statement: str, code: str, place: str
) -> None:
    text = (
        f"{_SHAPE}FUNCTION_BLOCK Other\nVAR q : INT; END_VAR\nEND_FUNCTION_BLOCK\n"
        "FUNCTION_BLOCK User\nVAR shape : Shape; other : Other; x : INT; END_VAR\n"
        f"{statement}\nEND_FUNCTION_BLOCK\n"
    )
    assert _codes(text) == [(code, place)]


@pytest.mark.parametrize(
    ("declaration", "code", "place"),
    [
        ("pump : Pump;", "FB4040", "pump"),
        ("pump : Pump(1, 2);", "FB4042", "2"),
        ("pump : Pump(nmber := 1);", "FB4006", "nmber := 1"),
        ("pump : Pump('a');", "FB4010", "'a'"),
        ("empty : Empty(1);", "FB4042", "1"),
    ],
)
def test_fb_init_takes_its_own_arguments_only(declaration: str, code: str, place: str) -> None:
    text = (
        f"{_PUMP}FUNCTION_BLOCK Empty\nVAR q : INT; END_VAR\nEND_FUNCTION_BLOCK\n"
        f"FUNCTION_BLOCK User\nVAR {declaration} END_VAR\nEND_FUNCTION_BLOCK\n"
    )
    assert _codes(text) == [(code, place)]


@pytest.mark.parametrize("operator", ["__NEW(Pump)", "__QUERYINTERFACE(b, b)", "__DELETE(b)"])
def test_what_makes_instances_while_running_is_a_hint_by_name(operator: str) -> None:
    text = f"PROGRAM Main\nVAR b : BOOL; END_VAR\nb := {operator};\nEND_PROGRAM\n"
    assert _codes(text) == []
    (hint,) = hints_of(text, "twincat")
    assert (hint.code, hint.span and hint.span.text) == ("FB4142", operator.partition("(")[0])


def test_a_class_cannot_be_called() -> None:
    text = (
        "CLASS Axis\nVAR n : INT; END_VAR\nMETHOD PUBLIC Move : INT\nn := n + 1;\nMove := n;\n"
        "END_METHOD\nEND_CLASS\nPROGRAM Main\nVAR axis : Axis; END_VAR\naxis();\nEND_PROGRAM\n"
    )
    assert _codes(text, "iec") == [("FB4047", "axis()")]


def test_arguments_for_fb_init_in_a_structure_are_refused_by_name() -> None:
    text = (
        f"{_PUMP}TYPE Pair : STRUCT\nleft : Pump(number := 5);\nEND_STRUCT END_TYPE\n"
        "FUNCTION_BLOCK Plant\nVAR pair : Pair; END_VAR\npair.left();\nEND_FUNCTION_BLOCK\n"
    )
    assert ("FB4054", "number := 5") in _codes(text)
