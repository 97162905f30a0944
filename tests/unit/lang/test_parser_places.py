"""References, chained assignments and absolute addresses of TIA Portal."""

import pytest
from trees import body, found_in, read, value

from fbgen.lang import ast
from fbgen.lang.depth import DEEPEST
from fbgen.lang.printer import print_file


def _assignment(text: str) -> ast.Assignment:
    (statement,) = body(text)
    assert isinstance(statement, ast.Assignment)
    return statement


def test_a_chained_assignment_nests_to_the_right() -> None:
    statement = _assignment("#a := #b += #c[1] := 5;")
    first = statement.value
    assert isinstance(first, ast.Chained)
    assert isinstance(first.target, ast.Name)
    assert (statement.operator, first.operator) == (":=", "+=")
    second = first.value
    assert isinstance(second, ast.Chained)
    assert isinstance(second.target, ast.Index)
    assert second.span.text == "#c[1] := 5"
    assert isinstance(second.value, ast.Literal)


def test_only_places_stand_in_front_of_an_assignment_sign() -> None:
    (found,) = found_in('FUNCTION_BLOCK "B"\nBEGIN\n#a := #b + 1 := 2;\nEND_FUNCTION_BLOCK\n')
    assert (found.code, found.span and found.span.text) == ("FB3001", ":=")


def test_a_chain_may_be_as_deep_as_anything_else() -> None:
    for links, codes in ((DEEPEST - 2, []), (DEEPEST + 1, ["FB3006"])):
        text = "x := " * (links + 1) + "1;"
        found = found_in(f'FUNCTION_BLOCK "B"\nBEGIN\n{text}\nEND_FUNCTION_BLOCK\n')
        assert [one.code for one in found] == codes


def test_a_reference_is_declared_and_followed() -> None:
    file = read(
        'FUNCTION_BLOCK "B"\nVAR r : REF_TO "t"; a : Array[0..1] of REF_TO Int; END_VAR\n'
        "BEGIN\n#r^.x := #a[0]^;\nEND_FUNCTION_BLOCK\n"
    )
    (block,) = file.units
    assert isinstance(block, ast.Block)
    first, second = (one.type for one in block.sections[0].declarations)
    assert isinstance(first, ast.ReferenceSpec)
    assert (first.keyword, first.target.span.text) == ("REF_TO", '"t"')
    assert isinstance(second, ast.ArraySpec)
    assert isinstance(second.element, ast.ReferenceSpec)
    (statement,) = block.body
    assert isinstance(statement, ast.Assignment)
    assert isinstance(statement.target, ast.Member)
    assert isinstance(statement.target.base, ast.Dereference)
    assert isinstance(statement.value, ast.Dereference)


def test_an_assignment_attempt_has_its_own_operator() -> None:
    assert _assignment("#ref ?= #variant;").operator == "?="


@pytest.mark.parametrize(
    ("text", "area", "size", "numbers", "peripheral"),
    [
        ("%I0.3", "I", "X", (0, 3), False),
        ("%E0.3", "I", "X", (0, 3), False),
        ("%IW4:P", "I", "W", (4, 0), True),
        ("%PIW4", "I", "W", (4, 0), True),
        ("%MD10", "M", "D", (10, 0), False),
        ("%DB100.DBX4.1", "DB", "X", (4, 1), False),
        ("%DB100.DW4", "DB", "W", (4, 0), False),
        ("%T5", "T", "", (5, 0), False),
        ("%Z5", "C", "", (5, 0), False),
    ],
)
def test_an_absolute_address(
    text: str, area: str, size: str, numbers: tuple[int, int], peripheral: bool
) -> None:
    node = value(text)
    assert isinstance(node, ast.DirectAddress)
    assert (node.area, node.size, (node.byte, node.bit)) == (area, size, numbers)
    assert node.peripheral is peripheral
    assert node.span.text == text


@pytest.mark.parametrize("text", ["%I0.8", "%IW4.1", "%X", "%DB", "%MX5", "%T5:P", "%I0.x"])
def test_what_is_no_absolute_address(text: str) -> None:
    found = found_in(f'FUNCTION_BLOCK "B"\nBEGIN\nx := {text};\nEND_FUNCTION_BLOCK\n')
    assert [(one.code, one.span and one.span.text) for one in found] == [("FB3001", text)]


@pytest.mark.parametrize(
    ("text", "printed"),
    [
        ("%MW(#i)", "%MW(#i)"),
        ("%MX(1, #j)", "%M(1, #j)"),
        ("%DB100.DW(5)", "%DB100.DW(5)"),
        ("EB(1):P", "%EB(1):P"),
        ('"values".DX(1, 2)', '"values".DX(1, 2)'),
        ("WORD_TO_BLOCK_DB(#w).DW(#i)", "WORD_TO_BLOCK_DB(#w).DW(#i)"),
        ("#block.%DBX4.1", "#block.%DBX4.1"),
        ('"block".%DBW4', '"block".%DBW4'),
    ],
)
def test_an_address_with_an_index(text: str, printed: str) -> None:
    node = value(text)
    assert isinstance(node, ast.IndexedAddress)
    block = f'FUNCTION_BLOCK "B"\nBEGIN\nx := {text};\nEND_FUNCTION_BLOCK\n'
    assert f"x := {printed};" in print_file(read(block)).text


def test_a_block_instance_may_be_called_like_an_area() -> None:
    (first, second) = body("#inst.DW(in := 1); MB(in := 2);")
    assert isinstance(first, ast.CallStatement)
    assert isinstance(second, ast.CallStatement)


@pytest.mark.parametrize("text", ['"tag"', '"a".b', '"a"[#i]', "#x"])
def test_p_behind_a_tag_goes_past_the_process_image(text: str) -> None:
    node = value(f"{text}:P")
    assert isinstance(node, ast.Peripheral)
    assert node.base.span.text == text


def test_p_behind_a_case_label_is_a_variable_if_there_is_a_blank() -> None:
    (case,) = body('CASE #x OF\n"A": P := 1;\n"B":P := 2;\nEND_CASE;')
    assert isinstance(case, ast.Case)
    (arm,) = case.arms
    first, second = arm.body
    assert isinstance(first, ast.Assignment)
    assert isinstance(first.target, ast.Name)
    assert isinstance(second, ast.Assignment)
    assert isinstance(second.target, ast.Peripheral)


def test_quoted_parameters_keep_their_quotes() -> None:
    (statement,) = body('"f"("in 1" := 1, "out 1" => #x);')
    assert isinstance(statement, ast.CallStatement)
    assert [one.quoted for one in statement.call.arguments] == [True, True]


def test_an_absolute_block_is_a_name_and_may_have_members() -> None:
    member = value("%DB5.level.high")
    assert isinstance(member, ast.Member)
    assert isinstance(member.base, ast.Member)
    assert isinstance(member.base.base, ast.Name)
    assert (member.base.base.name, member.base.base.span.text) == ("%DB5", "%DB5")
    assert member.base.span.text == "%DB5.level"
    call = value("%FC12(1)")
    assert isinstance(call, ast.Call)
    address = value("%DB1.%DBX0.5")
    assert isinstance(address, ast.DirectAddress)
    assert (address.db, address.byte, address.bit) == (1, 0, 5)
