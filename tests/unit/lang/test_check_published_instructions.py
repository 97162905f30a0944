"""Instructions and types of TIA Portal as published sources use them."""

import pytest
from checking import errors_of, findings_of, hints_of

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.parser import parse_recovering
from fbgen.source import Source
from harness import load_program

_ENGINES = pytest.mark.parametrize("engine_name", ["reference", "compiled"])


def _block(declarations: str, body: str) -> str:
    return (
        'FUNCTION_BLOCK "Station"\nVAR_INPUT go : Bool; END_VAR\n'
        f"VAR\n{declarations}\nEND_VAR\nBEGIN\n{body}\nEND_FUNCTION_BLOCK\n"
    )


@pytest.mark.parametrize(
    ("declarations", "body"),
    [
        ("client : MB_CLIENT;", "#client.MB_Unit_ID := 1;\n#client(REQ := #go);"),
        ("pid : PID_Compact;", "#pid.Config.InputUpperLimit := 10.0;\n#pid(Input := 1.0);"),
        ("axis : TO_PositioningAxis; x : LReal;", "#x := #axis.ActualPosition;\n#x := #x + 1.0;"),
        ("name : String;", "#name := GetSymbolName(VARIABLE := #go, SIZE := 0);"),
    ],
)
def test_what_has_no_model_is_a_warning_and_does_not_run(declarations: str, body: str) -> None:
    text = _block(declarations, body)
    assert errors_of(text, "tia") == []
    assert "FB4141" in [one.code for one in findings_of(text, "tia")]
    with pytest.raises(DiagnosticError) as refused:
        load_program([Source("station.scl", text)])
    assert {one.code for one in refused.value.diagnostics} == {"FB4141"}


def test_an_instruction_has_the_name_of_a_constant() -> None:
    text = (
        'FUNCTION "F" : Int\nVAR_INPUT a : Int; END_VAR\nVAR CONSTANT MAX : Int := 5; END_VAR\n'
        "BEGIN\n#F := MAX(IN1 := #a, IN2 := #MAX);\nEND_FUNCTION\n"
    )
    assert load_program([Source("f.scl", text)]).call("F", a=3) == 5


def test_a_variant_that_is_written_through_is_no_changed_input() -> None:
    text = (
        'FUNCTION "F" : Int\nVAR_INPUT from : Variant; to : Variant; END_VAR\nBEGIN\n'
        "#F := MOVE_BLK_VARIANT(SRC := #from, COUNT := 1, SRC_INDEX := 0, DEST_INDEX := 0,"
        " DEST => #to);\nEND_FUNCTION\n"
    )
    assert findings_of(text, "tia") == []


@_ENGINES
@pytest.mark.parametrize(
    ("target", "value", "expected"),
    [("INT", "16#8001", -32_767), ("WORD", "-1", 0xFFFF), ("DINT", "16#FFFF_FFFF", -1)],
)
def test_the_bits_of_a_constant_are_taken_as_they_are(
    engine_name: str, target: str, value: str, expected: int
) -> None:
    text = f'FUNCTION "F" : {target}\nBEGIN\n#F := {value};\nEND_FUNCTION\n'
    assert [one.code for one in findings_of(text, "tia")] == ["FB4112"]
    assert load_program([Source("f.scl", text)], engine=engine_name).call("F") == expected


@pytest.mark.parametrize("value", ["40000", "16#1_0000", "70000"])
def test_a_constant_that_is_too_large_is_still_an_error(value: str) -> None:
    text = f'FUNCTION "F" : INT\nBEGIN\n#F := {value};\nEND_FUNCTION\n'
    assert [one.code for one in errors_of(text, "tia")] == ["FB4014"]


_OUTPUTS = """FUNCTION_BLOCK "Sensor"
VAR_OUTPUT
   far : DInt := 70000;
   raw : Word := 16#FFFF;
   exact : LReal := 0.1;
END_VAR
BEGIN
END_FUNCTION_BLOCK
FUNCTION "Text" : Void
VAR_OUTPUT code : UInt; END_VAR
BEGIN
   #code := 65535;
END_FUNCTION
FUNCTION_BLOCK "User"
VAR
   sensor : "Sensor";
   near, level, code : Int;
   rough : Real;
   list : Array[0..3] of SInt;
END_VAR
BEGIN
   #near := 1;
   #sensor(far => #list[#near], raw => #level, exact => #rough);
   "Text"(code => #code);
END_FUNCTION_BLOCK
"""


@_ENGINES
def test_outputs_are_converted_behind_the_call(engine_name: str) -> None:
    program = load_program([Source("user.scl", _OUTPUTS)], engine=engine_name)
    user = program.instance("User")
    user()
    assert (user.level, user.code, user.list[1]) == (-1, -1, 0x70)
    assert user.rough == pytest.approx(0.1)


@_ENGINES
def test_a_text_is_converted_to_its_output(engine_name: str) -> None:
    text = "FUNCTION \"F\" : INT\nBEGIN\nS_CONV(IN := '42', OUT => #F);\nEND_FUNCTION\n"
    assert load_program([Source("f.scl", text)], engine=engine_name).call("F") == 42


@_ENGINES
@pytest.mark.parametrize(
    ("condition", "expected"),
    [("#t < 0", True), ("0 < #t", False), ("#t > 5 - 10", True), ("#t = #n", True)],
)
def test_a_duration_is_compared_with_a_whole_number(
    engine_name: str, condition: str, expected: bool
) -> None:
    text = (
        'FUNCTION "F" : Bool\nVAR_INPUT t : Time; n : DInt; END_VAR\nBEGIN\n'
        f"#F := {condition};\nEND_FUNCTION\n"
    )
    program = load_program([Source("f.scl", text)], engine=engine_name)
    assert program.call("F", t=-1, n=-1) == expected
    assert "FB4112" in [one.code for one in findings_of(text, "tia")]


def test_a_constant_without_a_value_has_the_default_of_its_type() -> None:
    text = (
        'FUNCTION "F" : Int\nVAR CONSTANT EMPTY : String; NOTHING : Int; END_VAR\nBEGIN\n'
        "#F := #NOTHING + LEN(#EMPTY);\nEND_FUNCTION\n"
    )
    assert load_program([Source("f.scl", text)]).call("F") == 0


def test_the_day_of_a_stamp_on_s7_300() -> None:
    text = (
        "FUNCTION F : INT\nVAR_INPUT t : DATE_AND_TIME; END_VAR\nBEGIN\n"
        "F := DT_DAY(IN := t);\nEND_FUNCTION\n"
    )
    assert errors_of(text, "step7") == []


def test_an_unknown_line_of_a_header_is_one_error() -> None:
    text = (
        "FUNCTION FC1 : VOID\nTITLE = 'x'\nPURPOSE : 'cooling'\nVAR_TEMP a : INT; END_VAR\n"
        "BEGIN\na := 1;\nEND_FUNCTION\n"
    )
    _, found = parse_recovering(Source("x", text), "step7")
    assert [(one.code, one.message) for one in found] == [
        ("FB3001", "a block's header has no PURPOSE")
    ]


def test_the_length_of_a_text_in_step_7() -> None:
    text = (
        "FUNCTION Size : INT\nVAR_INPUT t : STRING; END_VAR\n"
        "BEGIN\nSize := LEN(S := t);\nEND_FUNCTION\n"
    )
    assert errors_of(text, "step7") == []


_READER = """FUNCTION_BLOCK "Reader"
VAR_IN_OUT
   begin : Bool;
   list : Array[0..3] of Int;
END_VAR
BEGIN
IF #begin THEN #begin := FALSE; #list[0] := 1; END_IF;
END_FUNCTION_BLOCK
FUNCTION_BLOCK "Main"
VAR
   reader : "Reader";
   values : Array[0..3] of Int;
END_VAR
BEGIN
#reader.begin := TRUE;
#reader(list := #values);
END_FUNCTION_BLOCK
"""


def test_an_in_out_keeps_its_value_in_the_instance() -> None:
    assert errors_of(_READER, "tia") == []
    structured = _READER.replace("list := #values", "begin := #values[0] > 0")
    assert "FB4040" in [one.code for one in errors_of(structured, "tia")]


def test_hardware_blocks_have_the_types_of_step_7() -> None:
    text = (
        "FUNCTION_BLOCK FB1\nVAR receive : TRCV; length : INT; data : BYTE; END_VAR\nBEGIN\n"
        "receive(EN_R := TRUE, ID := W#16#1, LEN := length, DATA := data);\n"
        "length := receive.RCVD_LEN;\nEND_FUNCTION_BLOCK\n"
    )
    assert errors_of(text, "step7") == []


def test_data_of_the_name_of_an_instruction_does_not_hide_it() -> None:
    text = (
        "FUNCTION_BLOCK FB1\nVAR\nTEST_DB : STRUCT result : INT; length : WORD; locked : BOOL; "
        "END_STRUCT;\nEND_VAR\nBEGIN\nTEST_DB.result := TEST_DB(DB_NUMBER := W#16#5, "
        "DB_LENGTH := TEST_DB.length, WRITE_PROT := TEST_DB.locked);\nEND_FUNCTION_BLOCK\n"
    )
    assert errors_of(text, "step7") == []


def test_a_row_of_an_array_is_read_and_stops_a_run() -> None:
    text = (
        "FUNCTION_BLOCK FB1\nVAR\nrows : ARRAY[1..3, 1..8] OF BYTE; row : ARRAY[1..8] OF BYTE; "
        "n : INT;\nEND_VAR\nBEGIN\nrow := rows[n + 1];\n"
        "END_FUNCTION_BLOCK\n"
    )
    assert errors_of(text, "step7") == []
    assert "FB4142" in [one.code for one in hints_of(text, "step7")]


def test_an_overlay_of_an_in_out_is_read_and_has_no_model() -> None:
    text = (
        "FUNCTION FC1 : VOID\nVAR_IN_OUT data : ARRAY[1..8] OF BYTE; "
        "words AT data : ARRAY[1..4] OF WORD;\nEND_VAR\nBEGIN\nwords[1] := W#16#12;\n"
        "END_FUNCTION\n"
    )
    assert errors_of(text, "step7") == []
    assert "FB4141" in [one.code for one in findings_of(text, "step7")]


def test_a_slice_without_its_sign_is_told_how_to_write_it() -> None:
    text = _block("w : Word; b : Bool;", "#b := #w.X3;")
    (found,) = errors_of(text, "tia")
    assert (found.code, found.help) == ("FB4005", "a slice is written with '%': .%X3")
