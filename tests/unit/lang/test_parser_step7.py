"""Classic STEP 7 SCL: its own spellings, and advice for what it does not have."""

import pytest
from trees import body, found_in, read, shape, value

from fbgen.lang import ast
from fbgen.lang.printer import print_file


def _block(declarations: str = "", statements: str = "") -> str:
    return f"FUNCTION_BLOCK FB1\n{declarations}\nBEGIN\n{statements}\nEND_FUNCTION_BLOCK\n"


@pytest.mark.parametrize(
    ("text", "area", "size", "byte", "bit"),
    [
        ("M0.1", "M", "X", 0, 1),
        ("E4.7", "I", "X", 4, 7),
        ("I4.7", "I", "X", 4, 7),
        ("A1.0", "Q", "X", 1, 0),
        ("MX1.0", "M", "X", 1, 0),
        ("EW4", "I", "W", 4, 0),
        ("AB6", "Q", "B", 6, 0),
        ("QD8", "Q", "D", 8, 0),
        ("T5", "T", "", 5, 0),
        ("Z3", "C", "", 3, 0),
        ("C3", "C", "", 3, 0),
    ],
)
def test_an_address_needs_no_sign(text: str, area: str, size: str, byte: int, bit: int) -> None:
    node = value(text, "step7")
    assert isinstance(node, ast.DirectAddress)
    assert (node.area, node.size, node.byte, node.bit) == (area, size, byte, bit)
    assert node.span.text == text
    assert node.german is (text[0] in "EAZ")


@pytest.mark.parametrize("text", ["PIW256", "PEB4", "PAD8", "PQW2"])
def test_a_peripheral_address_begins_with_p(text: str) -> None:
    node = value(text, "step7")
    assert isinstance(node, ast.DirectAddress)
    assert node.peripheral
    assert text in print_file(read(_block("", f"x := {text};"), "step7")).text


def test_a_declared_name_that_looks_like_an_address_is_that_variable() -> None:
    file = read(_block("VAR EW8 : INT; T1 : SFB4; END_VAR", "EW8 := EW9; T1(IN := x);"), "step7")
    (block,) = file.units
    assert isinstance(block, ast.Block)
    assignment, call = block.body
    assert isinstance(assignment, ast.Assignment)
    assert isinstance(assignment.target, ast.Name)
    assert isinstance(assignment.value, ast.DirectAddress)
    assert isinstance(call, ast.CallStatement)


@pytest.mark.parametrize("text", ["M1", "E1", "A7"])
def test_a_word_without_bit_is_a_name(text: str) -> None:
    assert isinstance(value(text, "step7"), ast.Name)


@pytest.mark.parametrize(
    ("text", "db", "size", "byte", "bit"),
    [
        ("DB100.DW4", 100, "W", 4, 0),
        ("DB100.DBW4", 100, "W", 4, 0),
        ("DB1.D5.1", 1, "X", 5, 1),
        ("DB1.DX5.1", 1, "X", 5, 1),
        ("DB1.DBX5.1", 1, "X", 5, 1),
        ("DB1.DB20", 1, "B", 20, 0),
        ("DB1.DD9", 1, "D", 9, 0),
    ],
)
def test_an_address_in_a_data_block(text: str, db: int, size: str, byte: int, bit: int) -> None:
    node = value(text, "step7")
    assert isinstance(node, ast.DirectAddress)
    assert (node.area, node.db, node.size, node.byte, node.bit) == ("DB", db, size, byte, bit)


@pytest.mark.parametrize(
    ("text", "area", "size", "count", "has_base"),
    [
        ("MW[i]", "M", "W", 1, False),
        ("M[i, 3]", "M", "X", 2, False),
        ("PEB[1]", "I", "B", 1, False),
        ("DB100.DW[5]", "DB", "W", 1, True),
        ('"values".DX[i, j]', "DB", "X", 2, True),
        ("WORD_TO_BLOCK_DB(w).DX[32, 5]", "DB", "X", 2, True),
    ],
)
def test_an_address_with_an_index(
    text: str, area: str, size: str, count: int, has_base: bool
) -> None:
    node = value(text, "step7")
    assert isinstance(node, ast.IndexedAddress)
    assert (node.area, node.size, len(node.indices)) == (area, size, count)
    assert (node.base is not None) is has_base
    assert f"x := {text};" in print_file(read(_block("", f"x := {text};"), "step7")).text


def test_members_of_absolute_data_blocks_and_calls_of_absolute_blocks_are_names() -> None:
    assert isinstance(value("DB10.member", "step7"), ast.Member)
    first, second = body("FB4200.DB10(IN1 := 1); SFC14(LADDR := w);", "step7")
    assert isinstance(first, ast.CallStatement)
    assert isinstance(second, ast.CallStatement)


def test_constants_have_no_type_and_labels_are_kept() -> None:
    text = _block("CONST A := 5; B := A * 2; END_CONST\nLABEL l1, l2; l3; END_LABEL", "l1: x := A;")
    (block,) = read(text, "step7").units
    assert isinstance(block, ast.Block)
    (section,) = block.sections
    assert (section.keyword, section.qualifiers) == ("VAR", ("CONSTANT",))
    types = [one.type for one in section.declarations]
    assert [spec.name for spec in types if isinstance(spec, ast.NamedType)] == ["", ""]
    (labels,) = block.labels
    assert [name.name for name in labels.names] == ["l1", "l2", "l3"]


def test_initial_values_of_an_array_need_no_brackets() -> None:
    text = _block("VAR a : ARRAY[0..3] OF INT := 1, 2, 2(5); b : ARRAY[1..2] OF INT := 7; END_VAR")
    file = read(text, "step7")
    (block,) = file.units
    assert isinstance(block, ast.Block)
    first, second = block.sections[0].declarations
    assert isinstance(first.initial, ast.ArrayLiteral)
    assert first.initial.bare
    assert isinstance(first.initial.items[2], ast.Repeated)
    assert isinstance(second.initial, ast.Literal)
    assert shape(read(print_file(file).text, "step7")) == shape(file)


@pytest.mark.parametrize(
    ("declarations", "statements", "message", "advice"),
    [
        ("", "REGION a\nEND_REGION", "no REGION", "comment"),
        ("", "x += 1;", "no assignments with +=", "write the variable again"),
        ("", "x := y := 1;", "no assignments in assignments", "one assignment a statement"),
        ("", "x := w.%X3;", "no slices", "AT view"),
        ("", "x := %MW4;", "no absolute addresses with '%'", "without '%'"),
        ("VAR CONSTANT A : INT := 1; END_VAR", "", "no VAR CONSTANT", "CONST name := value"),
        ("VAR a : LREAL; END_VAR", "", "no type LREAL", "REAL"),
        ("VAR a : VARIANT; END_VAR", "", "no type VARIANT", "ANY"),
        ("VAR a : WSTRING[5]; END_VAR", "", "no type WSTRING", "STRING"),
        ("VAR a : REF_TO INT; END_VAR", "", "no references", "VAR_IN_OUT"),
        ("", "x := LTIME#5s;", "no type LTIME", "TIME"),
        ("", "x ?= y;", "no assignment attempts", "its own type"),
    ],
)
def test_what_step7_lacks_is_refused_with_advice(
    declarations: str, statements: str, message: str, advice: str
) -> None:
    (found,) = found_in(_block(declarations, statements), "step7")
    assert found.code == "FB3009"
    assert message in found.message
    assert advice in found.help


@pytest.mark.parametrize("dialect", ["tia", "iec"])
@pytest.mark.parametrize(
    ("section", "message"),
    [
        ("CONST A := 1; END_CONST", "no CONST sections"),
        ("LABEL a, b; END_LABEL", "no LABEL sections"),
    ],
)
def test_sections_of_step7_are_refused_elsewhere(section: str, message: str, dialect: str) -> None:
    (found,) = found_in(f"FUNCTION_BLOCK b\n{section}\nx := 1;\nEND_FUNCTION_BLOCK\n", dialect)
    assert found.code == "FB3009"
    assert message in found.message


def test_const_and_label_are_names_elsewhere() -> None:
    text = "FUNCTION_BLOCK b\nVAR const : INT; label : INT; END_VAR\nlabel := const;"
    assert found_in(f"{text}\nconst := 1;\nEND_FUNCTION_BLOCK\n", "iec") == []


def test_in_tia_brackets_index_a_variable() -> None:
    assert isinstance(value("MW[i]", "tia"), ast.Index)


def test_every_error_of_a_block_is_found_in_one_go() -> None:
    text = """FUNCTION_BLOCK FB1
CONST
  A : INT := 4;
  B = 5;
  C := ;
  D := 7;
END_CONST
LABEL a b; c; END_LABEL
BEGIN
  M0.9 := 1;
  DB1.DBX0.8 := 1;
  MW[ := 2;
  x := DB10.DW[1;
  FOR i := 1 TO DO x := 1; END_FOR;
  x := y
  z := D;
END_FUNCTION_BLOCK
"""
    found = [(one.span.line, one.span.column) for one in found_in(text, "step7") if one.span]
    assert found == [
        *[(3, 5), (4, 5), (5, 8), (8, 9), (10, 3), (11, 7)],
        *[(12, 7), (13, 17), (14, 17), (15, 8)],
    ]
