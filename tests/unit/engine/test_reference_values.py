"""Values of the reference evaluator's functions that no conformance program asks for.

Expected values are worked out by hand from the definitions that the functions name.
"""

import math
from dataclasses import replace

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checker import RULES, check
from fbgen.lang.parser import parse
from fbgen.lang.types import Scalar
from fbgen.source import Source
from harness import LoadedProgram, load_program
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.reference import ReferenceEngine


def evaluated(expression: str, kind: str, variables: str = "", dialect: str = "tia") -> Scalar:
    """The value of an expression; `variables` are declarations with initial values."""
    tia = dialect == "tia"
    name = '"F"' if tia else "F"
    text = (
        f"FUNCTION_BLOCK {name}\nVAR_OUTPUT result : {kind}; END_VAR\nVAR {variables} END_VAR\n"
        f"{'BEGIN' if tia else ''}\n{'#' if tia else ''}result := {expression};\n"
        "END_FUNCTION_BLOCK\n"
    )
    block = load_program([Source("value", text)], dialect, "reference").instance("F")
    block()
    result = block.result
    assert isinstance(result, bool | int | float | str)
    return result


@pytest.mark.parametrize(
    ("expression", "kind", "expected"),
    [
        ("WORD_BCD_TO_INT(#w)", "INT", -123),
        ("INT_TO_BCD_WORD(#i)", "WORD", 0xF045),
        ("TIME_TO_S5TIME(#t)", "S5TIME", 0x1123),
        ("S5TIME_TO_TIME(#s)", "TIME", 127_000),
        ("#base ** 3", "INT", -27),
        ("#base ** #down", "INT", 0),
        ("#r ** 0.5", "REAL", 1.5),
        ("SQR(#r)", "REAL", 5.0625),
        ("FRAC(#negative)", "REAL", -0.25),
        ("SWAP(#d)", "DWORD", 0x78563412),
        ("TOD_TO_DINT(#day + T#1h)", "DINT", 1_800_000),
        ("#day - #early", "TIME", 84_600_000),
        ("MAX(IN1 := #text, IN2 := 'b')", "STRING", "b"),
        ("STRING_TO_CHAR(#text)", "CHAR", "a"),
        ("CHAR_TO_INT('A')", "INT", 65),
        ("STRING_TO_REAL(' -1.5E1 ')", "REAL", -15.0),
        ("LREAL_TO_STRING(#wide)", "STRING", "1.00000000000000E-3"),
    ],
)
def test_values(expression: str, kind: str, expected: Scalar) -> None:
    variables = (
        "w : WORD := 16#F123; i : INT := -45; t : TIME := T#12s345ms; s : S5TIME := S5T#127s;"
        "base : INT := -3; down : INT := -1; r : REAL := 2.25; negative : REAL := -1.25;"
        "d : DWORD := 16#12345678; day : TIME_OF_DAY := TOD#23:30:00;"
        "early : TIME_OF_DAY := TOD#0:0:0; text : STRING := 'abc'; wide : LREAL := 0.001;"
    )
    assert evaluated(expression, kind, variables) == expected


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("LN(#zero)", -math.inf),
        ("EXP(#large)", math.inf),
        ("#zero ** -1.0", math.inf),
        ("#large ** #large", math.inf),
        ("-#large * #huge", -math.inf),
    ],
)
def test_reals_become_infinite(expression: str, expected: float) -> None:
    variables = "zero : REAL; large : REAL := 1000.0; huge : REAL := 3.0E38;"
    assert evaluated(expression, "REAL", variables) == expected


@pytest.mark.parametrize("expression", ["SQRT(#m)", "LN(#m)", "ASIN(#m)", "#m ** 0.5"])
def test_reals_outside_of_a_function_are_not_a_number(expression: str) -> None:
    result = evaluated(expression, "REAL", "m : REAL := -2.0;")
    assert isinstance(result, float)
    assert math.isnan(result)


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        # 24 bits hold steps of 2 ** 29 here: a little above a tie goes up, the tie itself to even.
        # By way of LREAL both would be ties.
        ((1 << 53) + (1 << 29) + 1, float((1 << 53) + (1 << 30))),
        ((1 << 53) + (1 << 29), float(1 << 53)),
        (-(1 << 53) - (1 << 29) - 1, -float((1 << 53) + (1 << 30))),
    ],
)
def test_a_long_number_becomes_real_in_one_rounding(value: int, expected: float) -> None:
    assert evaluated("LINT_TO_REAL(#n)", "REAL", f"n : LINT := {value};") == expected


@pytest.mark.parametrize(
    ("expression", "code"),
    [
        ("INT_TO_BCD_WORD(#i)", "FB6006"),
        ("TIME_TO_S5TIME(#t)", "FB6006"),
        ("DINT_TO_WORD(CEIL(#r))", "FB6006"),
        ("INT_TO_WORD(#i / #zero)", "FB6003"),
        ("INT_TO_WORD(#zero ** #minus)", "FB6003"),
    ],
)
def test_faults(expression: str, code: str) -> None:
    kind = "S5TIME" if "S5TIME" in expression else "WORD"
    variables = (
        "i : INT := 1000; t : TIME := T#-1s; r : REAL := 1.0E10; zero : INT; minus : INT := -1;"
    )
    with pytest.raises(DiagnosticError, match=code):
        evaluated(expression, kind, variables)


DATES = """
FUNCTION_BLOCK Dates
VAR
    day : DATE := D#1970-01-02;
    hour : TIME_OF_DAY := TOD#06:00:00;
    stamp : DATE_AND_TIME;
    later : DATE_AND_TIME;
    back : DATE;
    rest : TIME_OF_DAY;
    between : TIME;
    difference : TIME;
END_VAR
    stamp := CONCAT_DATE_TOD(day, hour);
    later := stamp + T#1d;
    back := DATE_AND_TIME_TO_DATE(later);
    rest := DATE_AND_TIME_TO_TIME_OF_DAY(later);
    between := later - stamp;
    difference := back - day;
END_FUNCTION_BLOCK
"""


def test_dates_and_times_of_day() -> None:
    program: LoadedProgram = load_program([Source("dates", DATES)], "iec", "reference")
    block = program.instance("Dates")
    block()
    assert block.stamp == 86_400 + 21_600
    assert block.later == 2 * 86_400 + 21_600
    assert (block.back, block.rest) == (2 * 86_400, 21_600_000)
    assert (block.between, block.difference) == (86_400_000, 86_400_000)


def test_defaults_depend_on_the_dialect() -> None:
    variables = "c : CHAR;"
    assert evaluated("#c", "CHAR", variables) == " "
    assert evaluated("c", "CHAR", variables, "iec") == "\0"


def test_shifts_of_signed_numbers_outside_of_s7_are_filled_with_zeros() -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR_OUTPUT result : INT; END_VAR\nVAR n : INT := -16; END_VAR\n"
        "result := SHR(n, 4);\nEND_FUNCTION_BLOCK\n"
    )
    rules = replace(RULES["iec"], shifts_integers=True)
    program = check([parse(Source("value", text), "iec")], "iec", rules=rules)
    block = ReferenceEngine(program, StandaloneEnvironment(), Limits()).instance("F")
    block.call({})
    assert block.get("result") == 0x0FFF
