"""Deep and long texts: what is stated as readable is read, what is deeper is a finding."""

import pytest
from trees import body, found_in, value

from fbgen.diagnostics import DiagnosticError
from fbgen.lang import ast
from fbgen.lang.depth import DEEPEST
from fbgen.lang.lowering import lower
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import Source


def _block(statements: str) -> str:
    return f'FUNCTION_BLOCK "B"\nBEGIN\n{statements}\nEND_FUNCTION_BLOCK\n'


def test_a_chain_of_ten_thousand_operands_is_read_and_printed() -> None:
    tree = value(" + ".join(["x"] * 10_001))
    operators = 0
    while isinstance(tree, ast.Binary):
        tree, operators = tree.left, operators + 1
    assert operators == 10_000
    text = _block(f"x := {' + '.join(['x'] * 10_001)};")
    printed = print_file(parse(Source("x", text), "tia")).text
    assert printed.count("+ x") == 10_000


@pytest.mark.parametrize(
    "text",
    [
        "x := " + "(" * 200 + "1" + ")" * 200 + ";",
        "x := " + "f(" * 200 + "1" + ")" * 200 + ";",
        "x := " + "a[" * 200 + "1" + "]" * 200 + ";",
        "x := " + "NOT " * 200 + "y;",
        "IF a THEN\n" * 120 + ";\n" + "END_IF;\n" * 120,
        "CASE a OF 1:\n" * 120 + ";\n" + "END_CASE;\n" * 120,
        "x := " + "(a + " * 200 + "1" + ")" * 200 + ";",
        "REGION r\n" * 200 + ";\n" + "END_REGION\n" * 200,
    ],
)
def test_nesting_within_the_limit_is_read_and_printed(text: str) -> None:
    tree = parse(Source("x", _block(text)), "tia")
    again = print_file(tree).text
    assert print_file(parse(Source("y", again), "tia")).text == again


def test_deep_nesting_is_lowered() -> None:
    deep = "(#a + " * 200 + "1" + ")" * 200
    ifs = "IF #a = 1 THEN\n" * 120 + f"#a := {deep};\n" + "END_IF;\n" * 120
    text = _block(f"#a := {deep};\n{ifs}").replace("BEGIN", "VAR\n a : Int;\nEND_VAR\nBEGIN")
    with pytest.raises(DiagnosticError, match="FB3006"):
        parse(Source("x", text), "tia")
    text = text.replace(f"#a := {deep};\n{ifs}", f"#a := {deep};\n{ifs.replace(deep, '1')}")
    assert print_file(lower(parse(Source("x", text), "tia"), "iec")).text.count("(a + ") == 200


@pytest.mark.parametrize(
    "text",
    [
        "x := " + "(" * 5000 + "1" + ")" * 5000 + ";",
        "x := " + "f(" * 5000 + "1" + ")" * 5000 + ";",
        "x := " + "-" * 5000 + "1;",
        "IF a THEN\n" * 1000 + ";\n" + "END_IF;\n" * 1000,
    ],
)
def test_deeper_nesting_is_a_finding(text: str) -> None:
    codes = {found.code for found in found_in(_block(text))}
    assert "FB3006" in codes
    assert codes <= {"FB3006", "FB3008"}


def test_structures_and_arrays_nest_up_to_the_limit() -> None:
    deep = "ARRAY[0..1] OF " * 5000
    found = found_in(f'FUNCTION_BLOCK "B"\nVAR\n x : {deep} INT;\nEND_VAR\nEND_FUNCTION_BLOCK')
    assert [one.code for one in found] == ["FB3006"]
    assert str(DEEPEST) in found[0].message


def test_thousands_of_branches_are_read() -> None:
    (statement,) = body("IF a THEN ;\n" + "ELSIF b THEN ;\n" * 3000 + "END_IF;")
    assert isinstance(statement, ast.If)
    assert len(statement.branches) == 3001
