"""Types of constants and expressions, and what converts by itself, per dialect."""

from dataclasses import replace

import pytest
from checking import errors_of, in_block, in_program, program_of

from fbgen.lang.checked import (
    Assignment,
    Binary,
    Constant,
    Convert,
    Expression,
    StandardCall,
)
from fbgen.lang.checker import RULES, check_reporting
from fbgen.lang.parser import parse
from fbgen.lang.types import (
    BYTE,
    DINT,
    DWORD,
    INT,
    LREAL,
    REAL,
    TIME,
    UINT,
    USINT,
    WORD,
)
from fbgen.source import Source


def value_of(declarations: str, target: str, expression: str, dialect: str = "iec") -> Expression:
    """The checked right side of `target := expression`."""
    if dialect == "iec":
        text = in_program(declarations, f"{target} := {expression};")
    else:
        text = in_block(declarations, f"#{target} := {expression};")
    program = program_of(text, dialect)
    statement = next(iter(program.bodies.values()))[0]
    assert isinstance(statement, Assignment)
    assert statement.value.type == statement.target.type
    return statement.value


def constant_of(declarations: str, target: str, expression: str, dialect: str = "iec") -> object:
    value = value_of(declarations, target, expression, dialect)
    assert isinstance(value, Constant)
    return value.value


@pytest.mark.parametrize(
    ("kind", "expression", "expected"),
    [
        ("WORD", "16#FF", 255),
        ("BYTE", "255", 255),
        ("SINT", "-128", -128),
        ("REAL", "5", 5.0),
        ("LREAL", "0.1", 0.1),
        ("REAL", "0.1", 0.10000000149011612),
        ("BOOL", "1", True),
        ("WORD", "NOT 16#00FF", 0xFF00),
        ("DWORD", "NOT 16#00FF", 0xFFFFFF00),
        ("INT", "3 + 4 * 5", 23),
        ("INT", "-7 / 2", -3),
        ("INT", "-7 MOD 3", -1),
        ("DINT", "INT#5 + DINT#100000", 100005),
        ("TIME", "T#1s500ms", 1500),
        ("LTIME", "T#1ms", 1_000_000),
        ("LTIME", "LTIME#5us", 5000),
        ("DATE", "D#1970-01-02", 86_400),
        ("TOD", "TOD#00:00:01", 1000),
        ("WORD", "16#F0 AND WORD#16#3C", 0x30),
        ("BOOL", "5 > 3", True),
        ("INT", "REAL_TO_INT(2.5)", 2),
        ("INT", "REAL_TO_INT(3.5)", 4),
        ("INT", "TRUNC(3.9)", 3),
        ("DINT", "WORD_TO_DINT(WORD#16#FFFF)", 65535),
        ("DINT", "INT_TO_DINT(INT#-1)", -1),
        ("UINT", "INT_TO_UINT(-1)", 65535),
        ("CHAR", "'A'", "A"),
        ("STRING[5]", "'abc'", "abc"),
        ("REAL", "16777217", 16777216.0),
        ("REAL", "9007199791611905", 9007200328482816.0),
    ],
)
def test_constant_takes_the_type_and_unit_of_its_place(
    kind: str, expression: str, expected: object
) -> None:
    assert constant_of(f"x : {kind};", "x", expression) == expected


def test_s5time_constant_is_its_bcd_word() -> None:
    assert constant_of("x : S5TIME;", "x", "S5T#2s500ms", "tia") == 0x0250
    assert constant_of("x : S5TIME;", "x", "S5T#100s", "tia") == 0x2100


@pytest.mark.parametrize(
    ("kind", "expression"),
    [
        ("SINT", "128"),
        ("USINT", "-1"),
        ("BYTE", "16#100"),
        ("INT", "16#8000"),
        ("INT", "16#7FFF + 1"),
        ("REAL", "1.0E39"),
        ("BOOL", "2"),
        ("STRING[2]", "'abc'"),
        ("ULINT", "18446744073709551616"),
        ("DINT", "99999999999 * 99999999999"),
        ("TIME", "T#30d"),
        ("WORD", "WORD#16#10000"),
    ],
)
def test_constant_outside_of_its_type_is_an_error(kind: str, expression: str) -> None:
    found = errors_of(in_program(f"x : {kind};", f"x := {expression};"))
    assert [one.code for one in found] == ["FB4014"]


@pytest.mark.parametrize(
    ("source", "target"),
    [
        ("SINT", "INT"),
        ("INT", "DINT"),
        ("USINT", "INT"),
        ("UINT", "UDINT"),
        ("INT", "REAL"),
        ("REAL", "LREAL"),
        ("BYTE", "WORD"),
        ("WORD", "DWORD"),
        ("TIME", "LTIME"),
        ("CHAR", "STRING[3]"),
    ],
)
def test_widening_converts_by_itself(source: str, target: str) -> None:
    value = value_of(f"x : {target}; y : {source};", "x", "y")
    assert isinstance(value, Convert)
    assert value.implicit


@pytest.mark.parametrize(
    ("source", "target", "code"),
    [
        ("DINT", "INT", "FB4011"),
        ("REAL", "INT", "FB4011"),
        ("BYTE", "INT", "FB4011"),
        ("INT", "WORD", "FB4011"),
        ("BOOL", "BYTE", "FB4011"),
        ("BYTE", "BOOL", "FB4011"),
        ("INT", "UINT", "FB4011"),
        ("DINT", "TIME", "FB4011"),
        ("STRING[3]", "INT", "FB4010"),
    ],
)
def test_narrowing_and_changing_meaning_do_not_convert_by_themselves(
    source: str, target: str, code: str
) -> None:
    found = errors_of(in_program(f"x : {target}; y : {source};", "x := y;"))
    assert [one.code for one in found] == [code]
    file = parse(Source("x", in_block(f"x : {target}; y : {source};", "#x := #y;")), "tia")
    checked = check_reporting([file], rules=replace(RULES["tia"], iec_check_open=False))[1]
    assert code in [one.code for one in checked]


def test_help_names_the_conversion_to_write() -> None:
    (found,) = errors_of(in_program("x : INT; y : BYTE;", "x := y;"))
    assert found.help.startswith("write the conversion: BYTE_TO_INT(...);")


def test_dint_becomes_real_by_itself_on_s7_only() -> None:
    assert isinstance(value_of("x : REAL; y : DINT;", "x", "#y", "tia"), Convert)
    (found,) = errors_of(in_program("x : REAL; y : DINT;", "x := y;"))
    assert found.code == "FB4011"


def test_operands_meet_in_the_smallest_common_type() -> None:
    value = value_of("x : LINT; i : INT; u : UINT;", "x", "i + u")
    assert isinstance(value, Convert)
    assert value.operand.type == DINT


def test_constant_beyond_the_other_operand_widens_the_calculation() -> None:
    value = value_of("x : DINT; i : INT;", "x", "i + 100000")
    assert isinstance(value, Binary)
    assert isinstance(value.left, Convert)
    assert value.type == DINT


def test_bit_strings_calculate_as_unsigned_integers_on_s7() -> None:
    value = value_of("x : BYTE;", "x", "#x + 1", "tia")
    assert isinstance(value, Convert)
    assert value.type == BYTE
    assert isinstance(value.operand, Binary)
    assert value.operand.type == USINT


def test_chain_of_bit_string_sums_converts_once() -> None:
    value = value_of("x : WORD;", "x", "#x + 1 + 2 + 3", "tia")
    assert isinstance(value, Convert)
    first = value.operand
    assert isinstance(first, Binary)
    assert isinstance(first.left, Binary)
    assert isinstance(first.left.left, Binary)
    assert first.left.left.left.type == UINT


def test_bit_strings_do_not_calculate_in_iec() -> None:
    (found,) = errors_of(in_program("x : BYTE;", "x := x + 1;"))
    assert found.code == "FB4012"
    assert "BYTE_TO_USINT" in found.help


def test_byte_compares_with_int_on_s7() -> None:
    value = value_of("x : BOOL; b : BYTE; i : INT;", "x", "#b > #i", "tia")
    assert isinstance(value, Binary)
    assert value.left.type == INT


def test_duration_times_number_keeps_the_number_on_the_right() -> None:
    value = value_of("t : TIME; i : INT;", "t", "i * t")
    assert isinstance(value, Binary)
    assert (value.left.type, value.right.type, value.type) == (TIME, INT, TIME)


def test_time_of_day_and_duration_are_added_by_a_standard_function() -> None:
    value = value_of("t : TOD;", "t", "t + T#5s")
    assert isinstance(value, StandardCall)
    assert value.name == "ADD_TOD_TIME"


def test_chain_of_ten_thousand_operands_is_checked() -> None:
    value = value_of("x : INT;", "x", " + ".join(["x"] * 10_000))
    depth = 0
    while isinstance(value, Binary):
        value = value.left
        depth += 1
    assert depth == 9_999


def test_two_hundred_parentheses_are_checked() -> None:
    value = value_of("x : INT;", "x", "(" * 200 + "x + 1" + ")" * 200)
    assert isinstance(value, Binary)


@pytest.mark.parametrize(
    ("expression", "name", "arguments", "result"),
    [
        ("SHL(w, 4)", "SHL", (WORD, INT), WORD),
        ("SHL(16#1, 8)", "SHL", (WORD, INT), WORD),
        ("ROR(IN := w, N := u)", "ROR", (WORD, UINT), WORD),
        ("MAX(w, b, 3)", "MAX", (WORD, WORD, WORD), WORD),
        ("SEL(TRUE, b, w)", "SEL", None, WORD),
        ("MUX(u, w, w, b)", "MUX", (UINT, WORD, WORD, WORD), WORD),
        ("LIMIT(16#1, w, 16#FFFF)", "LIMIT", (WORD, WORD, WORD), WORD),
        ("SWAP(w)", "SWAP", (WORD,), WORD),
    ],
)
def test_standard_function_works_in_the_common_type(
    expression: str, name: str, arguments: tuple[object, ...] | None, result: object
) -> None:
    value = value_of("w : WORD; b : BYTE; u : UINT;", "w", expression)
    assert isinstance(value, StandardCall)
    assert (value.name, value.type) == (name, result)
    if arguments is not None:
        assert tuple(argument.type for argument in value.arguments) == arguments


def test_mathematical_function_takes_an_integer_as_real() -> None:
    value = value_of("r : REAL; i : INT;", "r", "SQRT(i)")
    assert isinstance(value, StandardCall)
    assert value.arguments[0].type == REAL


def test_mathematical_function_of_lreal_is_lreal() -> None:
    assert value_of("r : LREAL;", "r", "SIN(r)").type == LREAL


def test_functions_that_are_operators_become_operators() -> None:
    value = value_of("i : INT;", "i", "ADD(i, 2, i)")
    assert isinstance(value, Binary)
    assert isinstance(value.left, Binary)
    assert isinstance(value_of("b : BOOL; i : INT;", "b", "GT(i, 2)"), Binary)


@pytest.mark.parametrize(
    ("target", "source", "expression", "rounding"),
    [
        ("INT", "REAL", "REAL_TO_INT(y)", "nearest"),
        ("INT", "REAL", "TO_INT(y)", "nearest"),
        ("INT", "REAL", "TRUNC(y)", "truncate"),
        ("INT", "REAL", "TRUNC_INT(y)", "truncate"),
        ("INT", "REAL", "REAL_TRUNC_INT(y)", "truncate"),
        ("DINT", "REAL", "ROUND(y)", "nearest"),
        ("INT", "BYTE", "BYTE_TO_INT(y)", "nearest"),
        ("TIME", "INT", "INT_TO_TIME(y)", "nearest"),
        ("DINT", "TIME", "TIME_TO_DINT(y)", "nearest"),
        ("BYTE", "BOOL", "BOOL_TO_BYTE(y)", "nearest"),
        ("BOOL", "WORD", "WORD_TO_BOOL(y)", "nearest"),
        ("DWORD", "REAL", "REAL_TO_DWORD(y)", "nearest"),
        ("DATE", "DT", "DT_TO_DATE(y)", "nearest"),
        ("BYTE", "CHAR", "CHAR_TO_BYTE(y)", "nearest"),
    ],
)
def test_written_conversion(target: str, source: str, expression: str, rounding: str) -> None:
    value = value_of(f"x : {target}; y : {source};", "x", expression)
    assert isinstance(value, Convert)
    assert (value.implicit, value.rounding) == (False, rounding)


def test_integer_to_bool_compares_in_iec_and_takes_the_lowest_bit_on_s7() -> None:
    assert isinstance(value_of("x : BOOL; y : INT;", "x", "INT_TO_BOOL(y)"), Binary)
    assert isinstance(value_of("x : BOOL; y : INT;", "x", "INT_TO_BOOL(#y)", "tia"), Convert)


def test_number_to_text_is_a_standard_call() -> None:
    value = value_of("x : STRING; y : INT;", "x", "INT_TO_STRING(y)")
    assert isinstance(value, StandardCall)
    assert value.name == "INT_TO_STRING"


def test_slices_are_parts_of_their_width() -> None:
    assert value_of("x : BYTE; d : DWORD;", "x", "#d.%B3", "tia").type == BYTE
    assert value_of("x : WORD; d : DWORD;", "x", "#d.%W1", "tia").type == WORD
    assert errors_of(in_block("x : WORD; d : DWORD;", "#x := #d.%W2;"), "tia")[0].code == "FB4018"


def test_absolute_addresses_are_bit_strings() -> None:
    assert value_of("x : DWORD;", "x", "%ID4:P", "tia").type == DWORD
