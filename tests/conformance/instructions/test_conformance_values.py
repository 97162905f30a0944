"""Instructions with values worked out by hand; each row names where its rule comes from."""

import math

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import LoadedProgram, load_program
from harness.engine.interface import Value

TIA = "TIA Portal help, the page of the instruction"
S7 = "STEP 7, System and Standard Functions; IEC library"

VALUES: list[tuple[str, str, Value, str]] = [
    ("REAL", "SQR(3.0)", 9.0, TIA),
    ("REAL", "LN(1.0)", 0.0, TIA),
    ("REAL", "EXP(0.0)", 1.0, TIA),
    ("REAL", "LOG(1000.0)", 3.0, S7),
    ("REAL", "SIN(0.0)", 0.0, TIA),
    ("REAL", "COS(0.0)", 1.0, TIA),
    ("REAL", "TAN(0.0)", 0.0, TIA),
    ("LREAL", "ASIN(LREAL#1.0)", math.pi / 2, TIA),
    ("LREAL", "ACOS(LREAL#-1.0)", math.pi, TIA),
    ("LREAL", "ATAN(LREAL#1.0)", math.pi / 4, TIA),
    ("REAL", "FRAC(-2.75)", -0.75, TIA),
    ("DWORD", "DECO(IN := 33)", 2, TIA),
    ("TIME", "T_CONV(DINT#1500)", 1_500, TIA),
    ("DINT", "T_CONV(T#2s)", 2_000, TIA),
    ("TIME", "T_SUB(IN1 := T#3s, IN2 := T#5s)", -2_000, TIA),
    ("TOD", "T_SUB(IN1 := TOD#10:00:00, IN2 := T#1s)", 35_999_000, TIA),
    ("DT", "T_COMBINE(IN1 := D#1990-01-01, IN2 := TOD#00:00:01)", 631_152_001_000_000_000, TIA),
    ("INT", "S_CONV('-12')", -12, TIA),
    ("STRING", "S_CONV(DINT#-12)", "-12", TIA),
    ("DT", "SB_DT_TM(T := DT#1990-01-01-00:00:02, D := T#1s)", 631_152_001_000_000_000, S7),
    ("TIME", "SB_DT_DT(DT1 := DT#1990-01-02-0:0:0, DT2 := DT#1990-01-01-0:0:0)", 86_400_000, S7),
    ("DT", "D_TOD_DT(IN1 := D#1990-01-01, IN2 := TOD#00:00:01)", 631_152_001_000_000_000, S7),
    ("STRING", "I_STRNG(I := -5)", "-5", S7),
    ("STRING", "DI_STRNG(I := 70000)", "70000", S7),
    ("STRING", "R_STRNG(IN := 1.5)", "1.500000E+0", S7),
    ("DINT", "STRNG_DI(S := '-70000')", -70_000, S7),
    ("REAL", "STRNG_R(S := '1.5')", 1.5, S7),
]


def _block(engine_name: str, variables: str, statements: str) -> LoadedProgram:
    text = f'FUNCTION_BLOCK "F"\nVAR {variables} END_VAR\nBEGIN\n{statements}\nEND_FUNCTION_BLOCK\n'
    return load_program([Source("f.scl", text)], engine=engine_name)


@pytest.mark.parametrize(("kind", "call", "expected", "source"), VALUES, ids=str)
def test_an_instruction_gives_what_its_source_says(
    kind: str, call: str, expected: Value, source: str, engine_name: str
) -> None:
    block = _block(engine_name, f"y : {kind};", f"#y := {call};").instance("F")
    block()
    assert block.y == expected, source


def test_the_clock_is_set_and_read(engine_name: str) -> None:
    program = _block(
        engine_name,
        "set, read, ticks : INT; at : DT; moment : TIME; local : DTL;",
        "#set := SET_CLK(PDT := DT#2024-02-29-10:00:00);\n"
        "#read := READ_CLK(CDT => #at);\n"
        "#moment := TIME_TCK();\n"
        "#ticks := WR_LOC_T(LOCTIME := DTL#2025-01-01-00:00:00, DST := FALSE);\n"
        "#ticks := RD_LOC_T(OUT => #local);",
    )
    program.clock.advance(ms=250)
    block = program.instance("F")
    block()
    assert (block["set"], block["read"], block["ticks"]) == (0, 0, 0)
    assert block["at"] == 1_709_200_800_000_000_000
    assert block["moment"] == 250
    assert block["local.YEAR"] == 2025


def test_texts_become_characters_and_come_back(engine_name: str) -> None:
    program = _block(
        engine_name,
        "text, back : STRING[8] := 'abc'; chars : ARRAY[0..5] OF CHAR; count : UINT;",
        "Strg_TO_Chars(STRG := #text, PCHARS := 2, CNT => #count, CHARS := #chars);\n"
        "Chars_TO_Strg(CHARS := #chars, PCHARS := 3, CNT := 2, STRG => #back);",
    )
    block = program.instance("F")
    block()
    assert list(block["chars"]) == [" ", " ", "a", "b", "c", " "]
    assert (block["count"], block["back"]) == (3, "bc")


def test_counters_count_down_and_both_ways(engine_name: str) -> None:
    program = _block(
        engine_name,
        "edge, set : BOOL; down, both : WORD; q : BOOL;",
        "#down := S_CD(C_NO := C1, CD := #edge, S := #set, PV := 16#0012, Q => #q);\n"
        "#both := S_CUD(C_NO := C2, CU := #edge, CD := FALSE, S := #set, PV := 16#0012);",
    )
    block = program.instance("F")
    block["set"] = True
    block()
    assert (block["down"], block["both"]) == (0x12, 0x12)
    block["edge"] = True
    block()
    assert (block["down"], block["both"], block["q"]) == (0x11, 0x13, True)


def test_without_an_error_the_operand_of_get_err_id_stays(engine_name: str) -> None:
    program = _block(engine_name, "id : WORD := 16#FFFF;", "#id := GET_ERR_ID(); RE_TRIGR();")
    block = program.instance("F")
    block()
    assert block["id"] == 0xFFFF


def test_stp_stops(engine_name: str) -> None:
    with pytest.raises(DiagnosticError) as stop:
        _block(engine_name, "x : INT;", "STP();").instance("F")()
    assert stop.value.diagnostics[0].code == "FB6016"
