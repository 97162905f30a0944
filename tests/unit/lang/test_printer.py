"""Printing: canonical, stable, complete."""

from pathlib import Path

import pytest
from trees import body, comments, read, shape

from fbgen.diagnostics import DiagnosticError
from fbgen.lang import ast
from fbgen.lang.printer import print_file, print_generated
from fbgen.lang.printer.lines import WIDTH

_SAMPLES = Path(__file__).parent / "samples"
_IEC = """\
TYPE a : STRUCT x : INT; n : ARRAY[0..2] OF BYTE := [1, 2(0)]; END_STRUCT; b : INT := 5; END_TYPE
VAR_GLOBAL g : a; END_VAR
FUNCTION f : INT VAR_INPUT x : INT; END_VAR f := -x ** 2; END_FUNCTION
PROGRAM main VAR_EXTERNAL g : a; END_VAR VAR t : TON; END_VAR
(* call *) t(IN := g.x > 3, PT := T#5s); IF t.Q THEN RETURN; END_IF; (* done *)
END_PROGRAM
CONFIGURATION c VAR_GLOBAL i AT %IX0.3 : BOOL; END_VAR RESOURCE r ON PLC
TASK t(INTERVAL := T#10ms, PRIORITY := 0); PROGRAM p WITH t : main; END_RESOURCE END_CONFIGURATION
"""


def _samples() -> list[tuple[str, str]]:
    texts = [(path.read_text(encoding="utf-8"), "tia") for path in sorted(_SAMPLES.glob("*.scl"))]
    return [*texts, (_IEC, "iec")]


@pytest.mark.parametrize(("text", "dialect"), _samples())
def test_printed_text_reads_as_the_same_tree(text: str, dialect: str) -> None:
    tree = read(text, dialect)
    again = read(print_file(tree).text, dialect)
    assert _without_header_order(shape(again)) == _without_header_order(shape(tree))
    assert comments(again) == comments(tree)


def _without_header_order(tree: object) -> object:
    """Header lines are put in order when printed; sort them on both sides."""
    if isinstance(tree, tuple):
        if len(tree) == 2 and tree[0] == "header":
            return ("header", tuple(sorted(map(repr, tree[1]))))
        return tuple(_without_header_order(item) for item in tree)
    return tree


@pytest.mark.parametrize(("text", "dialect"), _samples())
def test_printing_again_changes_nothing(text: str, dialect: str) -> None:
    once = print_file(read(text, dialect)).text
    assert print_file(read(once, dialect)).text == once


def test_the_layout_of_tia() -> None:
    text = (
        "// about\nfunction_block \"B\" // more\nVERSION : 0.1\nTITLE = x\n{ a := 'b' }\n"
        "var_input a : Int; // c\nend_var begin\nif #a=1 then #a:=2; else ; end_if;\n"
        "case #a of 1,2: ; else #a := 3; end_case;\nend_function_block"
    )
    assert print_file(read(text)).text == (
        "// about\n// more\nFUNCTION_BLOCK \"B\"\nTITLE = x\n{ a := 'b' }\nVERSION : 0.1\n"
        "   VAR_INPUT\n      a : Int;   // c\n   END_VAR\n\nBEGIN\n   IF #a = 1 THEN\n"
        "      #a := 2;\n   ELSE\n      ;\n   END_IF;\n   CASE #a OF\n      1, 2:\n         ;\n"
        "      ELSE\n         #a := 3;\n   END_CASE;\nEND_FUNCTION_BLOCK\n"
    )


def test_the_layout_of_iec() -> None:
    text = "PROGRAM p VAR a:INT;END_VAR FOR a:=1 TO 3 DO a:=a+1;END_FOR;END_PROGRAM"
    assert print_file(read(text, "iec")).text == (
        "PROGRAM p\n    VAR\n        a : INT;\n    END_VAR\n    FOR a := 1 TO 3 DO\n"
        "        a := a + 1;\n    END_FOR;\nEND_PROGRAM\n"
    )


def test_iec_has_no_line_comments() -> None:
    text = "PROGRAM p\n// a *) b\n;\nEND_PROGRAM"
    assert "    (* a * ) b *)\n" in print_file(read(text, "iec")).text


def test_long_lines_are_broken_in_front_of_operators_and_between_arguments() -> None:
    condition = " AND ".join(f"#condition{n}" for n in range(12))
    arguments = ", ".join(f"parameter{n} := #value{n}" for n in range(8))
    text = f'FUNCTION_BLOCK "B"\nBEGIN\nIF {condition} THEN #i({arguments}); END_IF;\n'
    tree = read(f"{text}END_FUNCTION_BLOCK")
    printed = print_file(tree).text
    assert max(map(len, printed.splitlines())) <= WIDTH
    assert "      AND #condition1\n" in printed
    assert "         parameter1 := #value1,\n" in printed
    assert shape(read(printed)) == shape(tree)


def test_trees_that_were_built_get_the_parentheses_they_need() -> None:
    (statement,) = body("x := a * b;")
    assert isinstance(statement, ast.Assignment)
    product = statement.value
    assert isinstance(product, ast.Binary)
    (other,) = body("x := a + b;")
    assert isinstance(other, ast.Assignment)
    built = ast.Binary(product.span, "*", other.value, other.value)
    (block,) = read('FUNCTION_BLOCK "B"\nBEGIN\n;\nEND_FUNCTION_BLOCK').units
    assert isinstance(block, ast.Block)
    new = ast.Assignment(product.span, statement.target, ":=", built)
    unit = ast.Block(block.span, block.kind, block.name, None, (), (), (new,))
    printed = print_file(ast.File(product.span.source, "tia", (unit,))).text
    assert "x := (a + b) * (a + b);" in printed


def test_generated_text_is_ascii_or_a_finding() -> None:
    tree = read('FUNCTION_BLOCK "B"\nBEGIN\n// 5 °C\n;\n// ok\n;\n// §\nEND_FUNCTION_BLOCK')
    with pytest.raises(DiagnosticError) as problem:
        print_generated(tree)
    places = [(one.code, one.span.line) for one in problem.value.diagnostics if one.span]
    assert places == [("FB3040", 4), ("FB3040", 8)]


def test_generated_text_has_plain_line_ends() -> None:
    tree = read('FUNCTION_BLOCK "B"\r\nBEGIN\r\n(* a\r\nb *)\r\n;\r\nEND_FUNCTION_BLOCK\r\n')
    assert "\r" not in print_generated(tree).text
