"""Rules that differ between dialects and settings, and the limits of nesting."""

import sys
from dataclasses import replace

import pytest
from checking import errors_of, findings_of, in_block, in_program, program_of

from fbgen.lang import ast
from fbgen.lang.checker import RULES, check_reporting
from fbgen.lang.checker.context import NESTING_LIMIT
from fbgen.lang.checker.supplied.standard_functions import (
    CHAINED_COMPARISONS,
    DATE_FUNCTIONS,
    ROUNDED_TO_REAL,
    ROUNDED_UP_OR_DOWN,
    STANDARD_FUNCTIONS,
    TEXT_CONVERSIONS,
    canonical_names,
)
from fbgen.lang.parser import parse
from fbgen.source import Source


def codes(text: str, dialect: str, rules: str) -> list[str]:
    """What the rules decide; warnings of the flow analysis are left out."""
    file = parse(Source("test", text), dialect)
    found = [one.code for one in check_reporting([file], rules=RULES[rules])[1]]
    return [code for code in found if not code.startswith("FB42")]


def test_byte_and_int_mix_without_the_iec_check() -> None:
    text = in_block("x : INT; b : BYTE;", "#x := #b;\n#b := BYTE#16#1;")
    assert codes(text, "tia", "step7") == []
    assert codes(text, "tia", "tia") == ["FB4112"]


def test_settings_of_a_project_replace_those_of_the_dialect() -> None:
    text = in_block("x : INT; b : BYTE;", "#x := #b;")
    file = parse(Source("test", text), "tia")
    off = replace(RULES["tia"], iec_check=False)
    on = replace(RULES["tia"], iec_check_open=False)
    assert "FB4011" not in [one.code for one in check_reporting([file], rules=off)[1]]
    assert "FB4011" in [one.code for one in check_reporting([file], rules=on)[1]]


def test_own_input_may_be_changed_with_a_warning() -> None:
    text = "FUNCTION_BLOCK b\nVAR_INPUT x : INT; END_VAR\nx := 1;\nEND_FUNCTION_BLOCK\n"
    assert codes(text, "iec", "iec") == ["FB4103"]
    assert codes(text, "iec", "tia") == ["FB4103"]


def test_statics_of_an_instance_are_visible_in_tia_only() -> None:
    text = (
        "FUNCTION_BLOCK b\nVAR s : INT; END_VAR\ns := 1;\nEND_FUNCTION_BLOCK\n"
        "FUNCTION_BLOCK c\nVAR i : b; x : INT; END_VAR\nx := i.s;\nEND_FUNCTION_BLOCK\n"
    )
    assert codes(text, "iec", "iec") == ["FB4058"]
    assert codes(text, "iec", "tia") == []


def test_temporaries_are_never_visible_from_outside_and_in_outs_on_s7_only() -> None:
    text = (
        "FUNCTION_BLOCK b\nVAR_TEMP t : INT; END_VAR\nVAR_IN_OUT io : INT; END_VAR\nt := io;\n"
        "END_FUNCTION_BLOCK\n"
        "FUNCTION_BLOCK c\nVAR i : b; x : INT; END_VAR\ni(io := x); x := i.t; x := i.io;\n"
        "END_FUNCTION_BLOCK\n"
    )
    assert codes(text, "iec", "iec") == ["FB4058", "FB4058"]
    assert codes(text, "iec", "tia") == ["FB4058"]


def test_shifts_take_integers_on_s7_only() -> None:
    assert errors_of(in_block("i : INT;", "#i := SHR(IN := #i, N := 2);"), "tia") == []
    (found,) = errors_of(in_program("i : INT;", "i := SHR(i, 2);"))
    assert found.code == "FB4012"


@pytest.mark.parametrize("opening", ["(", "ABS(", "-(", "1 + ("])
def test_expressions_are_checked_as_deep_as_the_parser_reads_them(opening: str) -> None:
    depth = 100
    text = in_program("x : INT;", f"x := {opening * depth}x{')' * depth};")
    assert errors_of(text) == []


def test_statements_are_checked_as_deep_as_the_parser_reads_them() -> None:
    depth = 200
    text = in_program("x : INT;", "IF x = 1 THEN " * depth + "x := 2;" + " END_IF;" * depth)
    assert errors_of(text) == []


def test_chain_of_five_thousand_elsifs_is_checked() -> None:
    arms = "".join(f"ELSIF x = {i} THEN x := {i};\n" for i in range(1, 5000))
    assert errors_of(in_program("x : INT;", f"IF x = 0 THEN x := 0;\n{arms}END_IF;")) == []


def test_trees_deeper_than_the_limit_are_refused_and_leave_the_interpreter_as_it_was() -> None:
    file = parse(Source("test", in_program("x : INT;", "x := x;")), "iec")
    (block,) = file.units
    assert isinstance(block, ast.Block)
    (assignment,) = block.body
    assert isinstance(assignment, ast.Assignment)
    value: ast.Expression = assignment.value
    for _ in range(NESTING_LIMIT + 1):
        value = ast.Parenthesized(value.span, value)
    deep = ast.Assignment(assignment.span, assignment.target, ":=", value)
    unit = ast.Block(block.span, block.kind, block.name, None, (), block.sections, (deep,))
    before = sys.getrecursionlimit()
    program, found = check_reporting([ast.File(file.source, "iec", (unit,))], "iec")
    assert program is None
    assert [one.code for one in found] == ["FB4053"]
    assert sys.getrecursionlimit() == before


def test_types_and_instances_nested_too_deeply_are_refused() -> None:
    types = "".join(f"T{i} : STRUCT x : T{i + 1}; END_STRUCT;\n" for i in range(100))
    text = f"TYPE\n{types}T100 : INT;\nEND_TYPE\n"
    assert {one.code for one in errors_of(text)} == {"FB4053"}
    blocks = "".join(
        f"FUNCTION_BLOCK B{i}\nVAR x : B{i + 1}; END_VAR\nx();\nEND_FUNCTION_BLOCK\n"
        for i in range(100)
    )
    text = blocks + "FUNCTION_BLOCK B100\n;\nEND_FUNCTION_BLOCK\n"
    assert {one.code for one in errors_of(text)} == {"FB4053"}


def test_every_standard_function_has_one_entry() -> None:
    tables = (STANDARD_FUNCTIONS, ROUNDED_UP_OR_DOWN, DATE_FUNCTIONS, TEXT_CONVERSIONS)
    further = {*CHAINED_COMPARISONS, *(one.name for one in ROUNDED_TO_REAL.values())}
    further |= {"MUX_ELSE", "LIMIT_OR_IN"}
    assert len(canonical_names()) == sum(len(table) for table in tables) + len(further)


def test_global_variable_without_external_is_a_warning_in_iec() -> None:
    text = (
        "PROGRAM main\ng := 1;\nEND_PROGRAM\n"
        "CONFIGURATION c\nVAR_GLOBAL g : INT; END_VAR\nEND_CONFIGURATION\n"
    )
    assert [one.code for one in findings_of(text)] == ["FB4104"]
    assert program_of(text).globals
