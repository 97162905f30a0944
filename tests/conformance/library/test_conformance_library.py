"""Standard functions with values worked out by hand; each row names where its rule comes from."""

import math

import pytest

from fbgen.source import Source
from harness import load_program
from harness.engine.interface import Value

NORM = "IEC 61131-3 third edition, tables 22 to 36"
TIA = "TIA Portal help, the page of the instruction"
S7 = "STEP 7 help, FC105, FC106, BCD numbers"

VALUES: list[tuple[str, str, Value, str]] = [
    ("LREAL", "ATAN2(LREAL#1.0, LREAL#-1.0)", 3 * math.pi / 4, NORM),
    ("BOOL", "GT(5, 4, 3)", True, NORM),
    ("BOOL", "GT(5, 4, 4)", False, NORM),
    ("BOOL", "GE(5, 4, 4)", True, NORM),
    ("UINT", "WORD_BCD_TO_UINT(16#9876)", 9876, NORM),
    ("BYTE", "USINT_TO_BCD_BYTE(42)", 0x42, NORM),
    ("BOOL", "IS_VALID_BCD(WORD#16#12A4)", False, NORM),
    ("BOOL", "IS_VALID(REAL#1.0)", True, NORM),
    ("USINT", "DAY_OF_WEEK(D#2024-02-29)", 4, "2024-02-29 was a Thursday"),
    ("USINT", "DAY_OF_WEEK(D#2000-01-01)", 6, "2000-01-01 was a Saturday"),
    ("DATE", "CONCAT_DATE(1990, 1, 2)", 1, "days from 1990-01-01"),
    ("TOD", "CONCAT_TOD(1, 2, 3, 4)", 3_723_004, NORM),
    ("DT", "CONCAT_DT(1970, 1, 2, 0, 0, 1, 0)", 86_401_000_000_000, NORM),
    ("STRING", "TIME_TO_STRING(T#1d2h3m4s5ms)", "T#1d2h3m4s5ms", "the literal"),
    ("STRING", "BOOL_TO_STRING(TRUE)", "TRUE", NORM),
    ("REAL", "BOOL_TO_REAL(TRUE)", 1.0, NORM),
    ("INT", "MUX(K := 7, IN0 := 1, IN1 := 2, INELSE := 9)", 9, TIA),
    ("REAL", "NORM_X(MIN := 0, VALUE := 13824, MAX := 27648)", 0.5, TIA),
    ("INT", "SCALE_X(MIN := 10, VALUE := 0.25, MAX := 30)", 15, TIA),
    ("INT", "SCALE_X_INT(MIN := 0, VALUE := 1.5, MAX := 100)", 150, TIA),
    ("WORD", "DECO_WORD(IN := 3)", 8, TIA),
    ("WORD", "DECO_WORD(IN := 19)", 8, TIA),
    ("INT", "ENCO(IN := WORD#16#0060)", 5, TIA),
    ("INT", "BITSUM(DWORD#16#12345678)", 13, TIA),
    ("REAL", "ROUND_REAL(2.5)", 2.0, TIA),
    ("REAL", "TRUNC_REAL(-2.5)", -2.0, TIA),
    ("DINT", "BCD32_TO_DINT(DWORD#16#F0001234)", -1234, S7),
    ("DWORD", "DINT_TO_BCD32(-1234567)", 0xF1234567, S7),
    ("INT", "MAX_LEN(#text)", 12, TIA),
    ("TIME", "T_DIFF(TOD#10:00:00, TOD#09:59:00)", 60_000, TIA),
    ("DT", "AD_DT_TM(T := DT#2024-01-01-00:00:00, D := T#1s)", 1_704_067_201_000_000_000, S7),
    ("BOOL", "GT_STRNG(S1 := 'b', S2 := 'a')", True, S7),
    ("INT", "STRNG_I(S := '-12')", -12, S7),
]


@pytest.mark.parametrize(("kind", "call", "expected", "source"), VALUES, ids=str)
def test_a_function_gives_what_its_source_says(
    kind: str, call: str, expected: Value, source: str, engine_name: str
) -> None:
    text = (
        'FUNCTION_BLOCK "F"\nVAR\n  text : STRING[12];\nEND_VAR\nVAR_OUTPUT\n'
        f"  y : {kind};\nEND_VAR\nBEGIN\n#y := {call};\nEND_FUNCTION_BLOCK\n"
    )
    block = load_program([Source("f.scl", text)], engine=engine_name).instance("F")
    block()
    assert block.y == expected, source


ROUTINES: list[tuple[str, str, dict[str, Value], str]] = [
    (
        "i : INT; r : REAL; w : WORD;",
        "#w := SCALE(IN := 0, HI_LIM := 50.0, LO_LIM := -50.0, BIPOLAR := TRUE, OUT => #r);",
        {"r": 0.0, "w": 0},
        S7,
    ),
    (
        "r : REAL; w : WORD;",
        "#w := SCALE(IN := -1, HI_LIM := 50.0, LO_LIM := 10.0, BIPOLAR := FALSE, OUT => #r);",
        {"r": 10.0, "w": 8},
        S7,
    ),
    (
        "i : INT; w : WORD;",
        "#w := UNSCALE(IN := 75.0, HI_LIM := 100.0, LO_LIM := 0.0, BIPOLAR := FALSE, OUT => #i);",
        {"i": 20736, "w": 0},
        S7,
    ),
    (
        "y : UINT; m, d : INT;",
        "SPLIT_DATE(IN := D#2024-02-29, YEAR => #y, MONTH => #m, DAY => #d);",
        {"y": 2024, "m": 2, "d": 29},
        NORM,
    ),
    (
        "a, b, c : INT;",
        "DEMUX(K := 4, IN := 5, OUT0 => #a, OUT1 => #b, OUTELSE => #c);",
        {"a": 0, "b": 0, "c": 5},
        TIA,
    ),
    (
        "i : INT; r : REAL;",
        "STRG_VAL(IN := '  -1,234.5', FORMAT := 16#0, P := 1, OUT => #r);\n"
        "STRG_VAL(IN := 'no', FORMAT := 16#0, P := 1, OUT => #i);",
        {"r": -1234.5, "i": 0},
        TIA,
    ),
    (
        "s : STRING[10] := 'T=        ';",
        "VAL_STRG(IN := 1234, SIZE := 7, PREC := 2, FORMAT := 16#4, P := 3, OUT => #s);",
        {"s": "T= +12.34 "},
        TIA,
    ),
    (
        "w, x : WORD;",
        "#x := ATH(IN := '1A2F', N := 4, OUT => #w);",
        {"w": 0x1A2F, "x": 0},
        TIA,
    ),
    (
        "s : STRING[4]; x : WORD;",
        "#x := HTA(IN := WORD#16#1A2F, N := 2, OUT => #s);",
        {"s": "1A2F"},
        TIA,
    ),
    ("i : INT; t : LDT;", "#i := RD_SYS_T(OUT => #t);", {"t": 1_325_376_000_000_000_000}, "clock"),
]


@pytest.mark.parametrize(("variables", "call", "expected", "source"), ROUTINES)
def test_an_instruction_gives_what_its_source_says(
    variables: str, call: str, expected: dict[str, Value], source: str, engine_name: str
) -> None:
    text = f'FUNCTION_BLOCK "F"\nVAR\n{variables}\nEND_VAR\nBEGIN\n{call}\nEND_FUNCTION_BLOCK\n'
    block = load_program([Source("f.scl", text)], engine=engine_name).instance("F")
    block()
    assert {name: block[name] for name in expected} == expected, source


TIMER = """FUNCTION_BLOCK "F"
VAR_INPUT
    s, r : BOOL;
END_VAR
VAR_OUTPUT
    q : BOOL;
    left : S5TIME;
    units : WORD;
END_VAR
BEGIN
    #left := {name}(T_NO := T7, S := #s, TV := S5T#2s, R := #r, Q => #q, BI => #units);
END_FUNCTION_BLOCK
"""
HISTORIES = {
    "S_PULSE": [True, True, False, False, False],
    "S_PEXT": [True, True, False, False, False],
    "S_ODT": [False, False, True, True, False],
    "S_ODTS": [False, False, True, True, True],
    "S_OFFDT": [True, True, True, True, True],
}
"""Q with S = 1 at 0, 1, 2 and 3 s, and S = 0 at 4 s (S7-SCL manual, timing diagrams)."""


@pytest.mark.parametrize("name", HISTORIES)
def test_s5_timers(name: str, engine_name: str) -> None:
    program = load_program([Source("f.scl", TIMER.format(name=name))], engine=engine_name)
    block = program.instance("F")
    seen = []
    for signal in (True, True, True, True, False):
        block(s=signal)
        seen.append(block.q)
        program.clock.advance(s=1)
    assert seen == HISTORIES[name]
    block(r=True)
    assert (block.q, block.left, block.units) == (False, 0, 0)


def test_what_is_left_of_an_s5_timer_is_decimal_with_its_base(engine_name: str) -> None:
    program = load_program([Source("f.scl", TIMER.format(name="S_PEXT"))], engine=engine_name)
    block = program.instance("F")
    block(s=True)
    program.clock.advance(ms=500)
    block()
    assert (block.left, block.units) == (0x0150, 150)


def test_the_calendar_can_be_set_and_goes_on(engine_name: str) -> None:
    text = (
        'FUNCTION_BLOCK "F"\nVAR_INPUT\n  set : BOOL;\nEND_VAR\n'
        "VAR\n  i : INT; now : DTL;\nEND_VAR\n"
        "BEGIN\nIF #set THEN #i := WR_SYS_T(IN := LDT#2024-02-28-23:59:59); END_IF;\n"
        "#i := RD_LOC_T(OUT => #now);\nEND_FUNCTION_BLOCK\n"
    )
    program = load_program([Source("f.scl", text)], engine=engine_name)
    block = program.instance("F")
    block(set=True)
    program.clock.advance(s=1.5)
    block(set=False)
    now = block.now
    assert [now.YEAR, now.MONTH, now.DAY, now.WEEKDAY] == [2024, 2, 29, 5]
    assert [now.HOUR, now.SECOND, now.NANOSECOND] == [0, 0, 500_000_000]
