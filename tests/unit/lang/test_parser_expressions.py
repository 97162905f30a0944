"""Expressions: precedence, places, calls, initial values."""

import pytest
from trees import body, read, shape, value

from fbgen.lang import ast


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("a OR b XOR c AND d", "a OR (b XOR (c AND d))"),
        ("a = b < c", "a = (b < c)"),
        ("a AND b = c", "a AND (b = c)"),
        ("a < b + c * d", "a < (b + (c * d))"),
        ("a - b - c", "(a - b) - c"),
        ("a / b MOD c DIV d", "((a / b) MOD c) DIV d"),
        ("NOT a = b", "(NOT a) = b"),
        ("-a + b", "(-a) + b"),
        ("a ** b ** c", "(a ** b) ** c"),
        ("a * b ** c", "a * (b ** c)"),
        ("-a ** b", "-(a ** b)"),
        ("a & b", "a AND b"),
        ("a >= b <> c <= d", "(a >= b) <> (c <= d)"),
    ],
)
def test_precedence_in_tia(written: str, meant: str) -> None:
    assert shape(_bare(value(written))) == shape(_bare(value(meant)))


def test_a_sign_binds_tighter_than_a_power_in_iec() -> None:
    assert shape(_bare(value("-a ** b", "iec"))) == shape(_bare(value("(-a) ** b", "iec")))


def test_div_is_a_function_in_iec() -> None:
    assert isinstance(value("DIV(a, b)", "iec"), ast.Call)


def _bare(node: ast.Expression) -> ast.Expression:
    """The tree without its parentheses."""
    if isinstance(node, ast.Parenthesized):
        return _bare(node.inner)
    if isinstance(node, ast.Binary):
        return ast.Binary(node.span, node.operator, _bare(node.left), _bare(node.right))
    if isinstance(node, ast.Unary):
        return ast.Unary(node.span, node.operator, _bare(node.operand))
    return node


@pytest.mark.parametrize(
    ("text", "quoted", "local"),
    [("x", False, False), ("#x", False, True), ('"x"', True, False), ('#"x"', True, True)],
)
def test_names_lose_their_marks_and_keep_how_they_stood(
    text: str, quoted: bool, local: bool
) -> None:
    name = value(text)
    assert isinstance(name, ast.Name)
    assert (name.name, name.quoted, name.local) == ("x", quoted, local)


def test_a_path_through_blocks_arrays_and_quoted_members() -> None:
    path = value('"DB"."odd member"[#i, 2].b.#c')
    assert isinstance(path, ast.Member)
    assert path.name == "c"
    assert isinstance(path.base, ast.Member)
    index = path.base.base
    assert isinstance(index, ast.Index)
    assert len(index.indices) == 2
    assert isinstance(index.base, ast.Member)
    assert (index.base.name, index.base.quoted) == ("odd member", True)


@pytest.mark.parametrize(
    ("text", "dialect", "size", "index"),
    [("#w.%X15", "tia", "X", 15), ("#w.%b1", "tia", "B", 1), ("#w.%D0", "tia", "D", 0)],
)
def test_slices(text: str, dialect: str, size: str, index: int) -> None:
    part = value(text, dialect)
    assert isinstance(part, ast.Slice)
    assert (part.size, part.index) == (size, index)


@pytest.mark.parametrize("word", ["type", "Value", "TITLE", "region", "END_IF", "name"])
def test_members_may_be_called_like_keywords(word: str) -> None:
    member = value(f"#a.{word}")
    assert isinstance(member, ast.Member)
    assert member.name == word


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("%IB256:P", ("I", "B", 256, 0, 0, True)),
        ("%i0.3", ("I", "X", 0, 3, 0, False)),
        ("%QX1.7", ("Q", "X", 1, 7, 0, False)),
        ("%MD10", ("M", "D", 10, 0, 0, False)),
        ("%DB100.DBW4", ("DB", "W", 4, 0, 100, False)),
        ("%DB1.DBX2.5", ("DB", "X", 2, 5, 1, False)),
    ],
)
def test_absolute_addresses(text: str, expected: tuple[str, str, int, int, int, bool]) -> None:
    node = value(text)
    assert isinstance(node, ast.DirectAddress)
    assert (node.area, node.size, node.byte, node.bit, node.db, node.peripheral) == expected


def test_arguments_by_position_as_input_and_as_output() -> None:
    (statement,) = body('"F"(1, a := 2, "b c" := 3, d => #x, e =>);')
    assert isinstance(statement, ast.CallStatement)
    kinds = [(one.kind.value, one.name) for one in statement.call.arguments]
    assert kinds == [("", ""), (":=", "a"), (":=", "b c"), ("=>", "d"), ("=>", "e")]
    assert statement.call.arguments[-1].value is None


def test_an_instance_in_an_array_is_called() -> None:
    (statement,) = body("#inst[3](a := 1);")
    assert isinstance(statement, ast.CallStatement)
    assert isinstance(statement.call.callee, ast.Index)


def _initial(text: str) -> object:
    file = read(f'FUNCTION_BLOCK "B"\nVAR\n x : T := {text};\nEND_VAR\nEND_FUNCTION_BLOCK')
    block = file.units[0]
    assert isinstance(block, ast.Block)
    return block.sections[0].declarations[0].initial


def test_initial_values_of_arrays() -> None:
    array = _initial("[1, 3(10), 2([4, 5]), #N(0), MAX + 1]")
    assert isinstance(array, ast.ArrayLiteral)
    kinds = [type(item).__name__ for item in array.items]
    assert kinds == ["Literal", "Repeated", "Repeated", "Repeated", "Binary"]


def test_initial_values_of_structures() -> None:
    struct = _initial("(a := 1, b := (c := [1, 2]), d := 2 * 3)")
    assert isinstance(struct, ast.StructLiteral)
    assert [field.name for field in struct.fields] == ["a", "b", "d"]


def test_structures_by_position_with_empty_places() -> None:
    struct = _initial("((), , [10(-1)])")
    assert isinstance(struct, ast.StructLiteral)
    assert [field.value is None for field in struct.fields] == [False, True, False]


def test_parentheses_in_a_constant_are_no_structure() -> None:
    assert isinstance(_initial("(5 + 3) * 2"), ast.Binary)
    assert isinstance(_initial("(5)"), ast.Parenthesized)
