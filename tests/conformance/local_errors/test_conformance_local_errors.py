"""GET_ERROR and GET_ERR_ID: a block that handles its own errors.

TIA Portal help, "GET_ERROR: Get error locally" and "GET_ERR_ID: Get error ID locally": as soon as
the instruction stands in a block the default reaction to its programming and access errors is off.
Reading goes on with 0 (REACTION 1), writing is ignored (0). The first error since the last question
is told; the operand changes only if there was one.
"""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import load_program
from harness.engine.variables import BlockInstance

READ, WRITE, REFERENCE, NO_BLOCK = 0x2522, 0x2523, 0x2533, 0x253A


def block(engine: str, variables: str, statements: str, more: str = "") -> BlockInstance:
    text = (
        f'{more}FUNCTION_BLOCK "F"\n{variables}\nVAR\n'
        "  field : ARRAY[1..3] OF REAL := [1.0, 2.0, 3.0];\n  names : ARRAY[0..1] OF STRING[5];\n"
        "END_VAR\nBEGIN\n"
        f"{statements}\nEND_FUNCTION_BLOCK\n"
    )
    return load_program([Source("f.scl", text)], engine=engine).instance("F")


IO = (
    "VAR_INPUT i : INT; j : INT; END_VAR\n"
    "VAR_OUTPUT y : REAL; id : WORD; reaction : BYTE; kind : BYTE; END_VAR"
)


def test_what_is_read_outside_of_an_array_is_zero(engine_name: str) -> None:
    one = block(
        engine_name,
        IO + "\nVAR_TEMP error : ErrorStruct; END_VAR",
        "#y := #field[#i] * 40.5 + 1.0;\n#error.ERROR_ID := 0;\n#id := 0;\nGET_ERROR(#error);\n"
        "#id := #error.ERROR_ID;\n#reaction := #error.REACTION;\n"
        "#kind := #error.CODE_ADDRESS.BLOCK_TYPE;",
    )
    one(i=2)
    assert (one.y, one.id) == (82.0, 0)
    one(i=4)
    assert (one.y, one.id, one.reaction, one.kind) == (1.0, READ, 1, 3)
    one(i=-1)
    assert (one.y, one.id) == (1.0, READ)
    one(i=1)
    assert (one.y, one.id) == (41.5, 0)


def test_what_is_written_outside_of_an_array_is_left_out(engine_name: str) -> None:
    one = block(engine_name, IO, "#y := 7.0;\n#field[#i] := #y;\n#y := 8.0;\n#id := GET_ERR_ID();")
    one(i=0)
    assert (one.y, one.id) == (8.0, WRITE)
    assert one.field == [1.0, 2.0, 3.0]
    one(i=3)
    assert one.field == [1.0, 2.0, 7.0]


def test_the_operand_stays_where_there_is_no_error(engine_name: str) -> None:
    one = block(engine_name, IO, "#field[#i] := 1.0;\n#id := GET_ERR_ID();")
    one(i=9)
    assert one.id == WRITE
    one(i=1)
    assert one.id == WRITE


def test_the_first_error_since_the_last_question_is_told(engine_name: str) -> None:
    one = block(
        engine_name,
        "VAR_INPUT i : INT; END_VAR\nVAR_OUTPUT first, second, third : WORD; END_VAR",
        "#field[#i] := #field[#i];\n#first := GET_ERR_ID();\n#second := GET_ERR_ID();\n"
        "#field[#i] := 1.0;\n#third := GET_ERR_ID();",
    )
    one(i=7)
    assert (one.first, one.second, one.third) == (READ, 0, WRITE)


def test_an_error_does_not_outlive_the_call(engine_name: str) -> None:
    one = block(engine_name, IO, "#id := 0;\n#id := GET_ERR_ID();\n#y := #field[#i];")
    one(i=5)
    assert (one.y, one.id) == (0.0, 0)
    one(i=2)
    assert (one.y, one.id) == (2.0, 0)


def test_it_may_be_asked_in_a_condition_and_in_loops(engine_name: str) -> None:
    one = block(
        engine_name,
        "VAR_OUTPUT sum : REAL; errors : INT; n : INT; END_VAR",
        "FOR #n := 0 TO 5 DO\n  #sum := #sum + #field[#n];\n"
        "  IF GET_ERR_ID() <> 0 THEN\n    #errors := #errors + 1;\n  END_IF;\nEND_FOR;",
    )
    one()
    assert (one.sum, one.errors) == (6.0, 3)


@pytest.mark.parametrize(
    ("variables", "statement", "number"),
    [
        ("VAR r : REF_TO INT; y : INT := 5; END_VAR", "#y := #r^;", REFERENCE),
        ("VAR r : REF_TO INT; y : INT := 5; END_VAR", "#r^ := 1;\n#y := 0;", REFERENCE),
        ("VAR y : INT := 5; END_VAR", "#y := WORD_TO_INT(%DB77.DBW0);", NO_BLOCK),
        ("VAR y : INT; END_VAR", "#names[#y + 2] := 'x';", WRITE),
        (
            "VAR y : INT; t : STRING; END_VAR",
            "#t := CONCAT(IN1 := 'a', IN2 := #names[9 + #y]);",
            READ,
        ),
        ("VAR y : INT; END_VAR", "IF #field[#y] > 0.0 THEN #y := 1; END_IF;", READ),
        (
            "VAR y : INT; END_VAR",
            "CASE REAL_TO_INT(#field[#y]) OF 0: #y := 0; ELSE #y := 1; END_CASE;",
            READ,
        ),
    ],
)
def test_other_errors_have_their_numbers(
    variables: str, statement: str, number: int, engine_name: str
) -> None:
    one = block(
        engine_name,
        f"{variables}\nVAR_OUTPUT id : WORD; END_VAR",
        f"{statement}\n#id := GET_ERR_ID();",
    )
    one()
    assert (one.id, one.y) == (number, 0)


def test_a_call_with_a_place_that_is_not_there_is_left_out(engine_name: str) -> None:
    more = (
        'FUNCTION "Double" : Void\nVAR_IN_OUT x : REAL; END_VAR\nBEGIN\n#x := #x * 2.0;\n'
        "END_FUNCTION\n"
    )
    one = block(
        engine_name,
        IO + "\nVAR_TEMP error : ErrorStruct; END_VAR",
        '"Double"(x := #field[#i]);\nGET_ERROR(#error);\n#id := #error.ERROR_ID;\n'
        "#reaction := #error.REACTION;",
        more,
    )
    one(i=2)
    assert (list(one.field), one.id) == ([1.0, 4.0, 3.0], 0)
    one(i=8)
    assert (one.field, one.id, one.reaction) == ([1.0, 4.0, 3.0], READ, 2)


def test_a_block_that_is_called_handles_its_own_errors_or_stops(engine_name: str) -> None:
    more = (
        'FUNCTION "Pick" : REAL\nVAR_INPUT i : INT; END_VAR\n'
        "VAR_TEMP a : ARRAY[0..1] OF REAL; END_VAR\nBEGIN\n#a[0] := 3.0;\n#a[1] := 4.0;\n"
        '"Pick" := #a[#i];\nEND_FUNCTION\n'
    )
    one = block(engine_name, IO, '#y := "Pick"(#i) + #field[#j];\n#id := GET_ERR_ID();', more)
    one(i=1, j=4)
    assert (one.y, one.id) == (4.0, READ)
    with pytest.raises(DiagnosticError) as stopped:
        one(i=2, j=1)
    assert stopped.value.diagnostics[0].code == "FB6002"


def test_division_by_zero_is_none_of_these_errors(engine_name: str) -> None:
    one = block(engine_name, IO, "#i := 7 / #j;\n#id := GET_ERR_ID();")
    with pytest.raises(DiagnosticError) as stopped:
        one(j=0)
    assert stopped.value.diagnostics[0].code == "FB6003"


def test_without_the_question_an_error_stops_the_program(engine_name: str) -> None:
    with pytest.raises(DiagnosticError) as stopped:
        block(engine_name, IO, "#y := #field[#i];")(i=4)
    assert stopped.value.diagnostics[0].code == "FB6002"
