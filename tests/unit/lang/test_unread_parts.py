"""Names and types are checked around what could not be read, without follow-up errors."""

import pytest

from fbgen.diagnostics import DiagnosticError, Severity
from fbgen.lang import ast
from fbgen.lang.checker import check_reporting
from fbgen.lang.parser import parse_recovering
from fbgen.source import Source
from harness import load_program

TYPE = 'TYPE "typeData"\nSTRUCT\n  a : Int;\n  {field}\nEND_STRUCT;\nEND_TYPE\n'
MOTOR = """FUNCTION_BLOCK "Motor"
VAR_INPUT speed : Int; {inputs} END_VAR
VAR state : Int; END_VAR
BEGIN
  #state := {value};
END_FUNCTION_BLOCK
"""
USER = """FUNCTION_BLOCK "User"
VAR motor : "Motor"; data : "typeData"; number : Int; END_VAR
BEGIN
  {statement}
  #number := 1.5;
END_FUNCTION_BLOCK
"""


def _found(*texts: str) -> list[tuple[str, str]]:
    """Code and place of all errors but those of the parser."""
    files: list[ast.File] = []
    unread = []
    for number, text in enumerate(texts):
        file, findings = parse_recovering(Source(f"file{number}.scl", text), "tia")
        files.append(file)
        unread += findings
    assert unread
    _, found = check_reporting(files, "tia", unread=unread)
    return [
        (one.code, one.span.text if one.span else "")
        for one in found
        if one.severity is Severity.ERROR
    ]


def _program(statement: str, field: str = "", inputs: str = "", value: str = "0") -> str:
    text = TYPE.format(field=field) + MOTOR.format(inputs=inputs, value=value)
    return text + USER.format(statement=statement)


def test_blocks_without_syntax_errors_are_checked() -> None:
    assert _found(_program("", value=":= 5")) == [("FB4010", "1.5")]


def test_an_error_in_statements_leaves_the_declarations_known() -> None:
    text = _program("#motor(speed := 1, direction := 2); #motor.stop := TRUE;", value=":= 5")
    assert _found(text) == [
        ("FB4006", "direction := 2"),
        ("FB4005", "#motor.stop"),
        ("FB4010", "1.5"),
    ]


@pytest.mark.parametrize(
    "statement",
    [
        "#motor(speed := 1, direction := 2);",
        "#motor.stop := TRUE;",
        "#number := #motor.speed + #motor.stop;",
        "#motor(1, 2, 3);",
    ],
)
def test_what_a_broken_declaration_may_have_declared_is_no_error(statement: str) -> None:
    assert _found(_program(statement, inputs="direction direction;")) == [("FB4010", "1.5")]


def test_what_was_declared_in_a_broken_block_keeps_its_type() -> None:
    text = _program("#motor(speed := 2.5);", inputs="direction direction;")
    assert _found(text) == [("FB4010", "2.5"), ("FB4010", "1.5")]


def test_parts_of_a_broken_type_are_no_error() -> None:
    text = _program("#number := #data.b; #data.a := TRUE;", field="b : ;")
    assert _found(text) == [("FB4011", "TRUE"), ("FB4010", "1.5")]


def test_names_of_a_unit_that_is_lost_are_no_error() -> None:
    lost = 'FUNCTION "Lost : Int\nVAR_INPUT y : Int; END_VAR\nBEGIN\nEND_FUNCTION\n'
    text = lost + _program('#number := "Lost"(y := 3); #number := "Found"(y := 3);')
    assert _found(text) == [("FB4004", '"Found"'), ("FB4010", "1.5")]


def test_the_broken_unit_may_be_in_another_file() -> None:
    broken = TYPE.format(field="") + MOTOR.format(inputs="direction direction;", value="0")
    user = USER.format(statement="#motor(speed := 1, direction := 2);")
    assert _found(broken, user) == [("FB4010", "1.5")]


def test_a_missing_semicolon_hides_nothing() -> None:
    text = _program("", value="2.5").replace("state : Int;", "state : Int")
    assert _found(text) == [("FB4010", "2.5"), ("FB4010", "1.5")]


def test_loading_reports_errors_of_both_sorts() -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_program([Source("motor.scl", _program("", value=":= 5"))])
    assert [one.code for one in failure.value.diagnostics] == ["FB3001", "FB4010"]


def test_no_warning_blames_what_was_not_read() -> None:
    text = """FUNCTION_BLOCK "Caller"
VAR t : "Holder"; END_VAR
BEGIN
  #t.set := := 3;
END_FUNCTION_BLOCK

FUNCTION_BLOCK "Holder"
VAR_OUTPUT out : Int; END_VAR
VAR set : Int; END_VAR
BEGIN
  #out := #set;
END_FUNCTION_BLOCK
"""
    file, unread = parse_recovering(Source("holder.scl", text), "tia")
    _, alone = check_reporting([file], "tia")
    _, found = check_reporting([file], "tia", unread=unread)
    assert "FB4205" in {one.code for one in alone}
    assert found == []
