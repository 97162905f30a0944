"""Whole programs: declarations over several files, initial values, data blocks, tasks."""

import pytest
from checking import errors_of, in_program, program_of

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Program, Variable, VariableKind
from fbgen.lang.checker import check, rules_for
from fbgen.lang.parser import parse
from fbgen.lang.types import (
    INT,
    ArrayInitial,
    ArrayType,
    BlockType,
    StructInitial,
    StructType,
)
from fbgen.source import Source

UDT = """
TYPE "typeFrame" VERSION : 0.1
STRUCT
  inv : BYTE := 16#0B;
  data : ARRAY[0..3] OF WORD := [1, 2(16#FF)];
  inner : STRUCT a : INT := 5; b : REAL; END_STRUCT;
END_STRUCT;
END_TYPE
"""


def variable(program: Program, block: str, name: str) -> Variable:
    return next(one for one in program.blocks[block].variables if one.name == name)


def in_static(declarations: str) -> str:
    return f'FUNCTION_BLOCK "Test"\nVAR {declarations} END_VAR\nBEGIN\n;\nEND_FUNCTION_BLOCK\n'


def test_files_may_come_in_any_order() -> None:
    user = parse(
        Source("a", "PROGRAM main VAR f : Fb; t : Rec; END_VAR f(x := t.n); END_PROGRAM"), "iec"
    )
    block = parse(
        Source(
            "b",
            "FUNCTION_BLOCK Fb VAR_INPUT x : INT; END_VAR VAR y : Rec; END_VAR y.n := x;"
            " END_FUNCTION_BLOCK",
        ),
        "iec",
    )
    types = parse(Source("c", "TYPE Rec : STRUCT n : INT; END_STRUCT; END_TYPE"), "iec")
    for order in ([user, block, types], [types, block, user], [block, user, types]):
        program = check(order, "iec")
        assert set(program.blocks) == {"main", "fb"}
        assert set(program.structures) == {"rec"}


def test_errors_of_all_files_are_raised_together() -> None:
    files = [
        parse(Source(name, in_program("x : INT;", f"x := y{name};").replace("main", name)), "iec")
        for name in ("one", "two")
    ]
    with pytest.raises(DiagnosticError) as caught:
        check(files, "iec")
    places = [one.span.source.name for one in caught.value.diagnostics if one.span]
    assert places == ["one", "two"]


def test_unknown_dialect_is_refused() -> None:
    with pytest.raises(DiagnosticError) as caught:
        rules_for("siemens")
    assert caught.value.diagnostics[0].code == "FB4000"


def test_section_decides_where_a_variable_lives() -> None:
    program = program_of(
        "FUNCTION_BLOCK b\nVAR_INPUT a : INT; END_VAR VAR_OUTPUT o : INT; END_VAR\n"
        "VAR_IN_OUT c : INT; END_VAR VAR s : INT; END_VAR VAR_TEMP t : INT; END_VAR\n"
        "VAR RETAIN r : INT; END_VAR\nEND_FUNCTION_BLOCK\n"
        "FUNCTION f : INT\nVAR t : INT; END_VAR\nf := t;\nEND_FUNCTION"
    )
    assert [one.kind for one in program.blocks["b"].variables] == [
        VariableKind.INPUT,
        VariableKind.OUTPUT,
        VariableKind.IN_OUT,
        VariableKind.STATIC,
        VariableKind.TEMP,
        VariableKind.STATIC,
    ]
    assert variable(program, "b", "r").remanent
    assert variable(program, "f", "t").kind is VariableKind.TEMP
    result = program.blocks["f"].result
    assert result is not None
    assert (result.name, result.kind, result.type) == ("f", VariableKind.RESULT, INT)


def test_initial_values_of_arrays_are_flat_with_repetition() -> None:
    program = program_of(in_static("x : ARRAY[0..1, 1..3] OF INT := [1, 3(7), 9];"), "tia")
    assert variable(program, "test", "x").initial == ArrayInitial((1, 7, 7, 7, 9, None))


def test_initial_value_of_a_structure_overlays_that_of_its_type() -> None:
    program = program_of(
        UDT + in_static('x : "typeFrame" := (inv := 16#22, inner := (b := 1.5));'), "tia"
    )
    assert variable(program, "test", "x").initial == StructInitial(
        (("inv", 0x22), ("inner", StructInitial((("b", 1.5),))))
    )
    frame = program.structures["typeframe"]
    assert frame.field("INV") is not None
    assert [part.initial for part in frame.fields][:2] == [
        0x0B,
        ArrayInitial((1, 0xFF, 0xFF, None)),
    ]


def test_array_bounds_may_be_named_constants_declared_later() -> None:
    program = program_of(
        'FUNCTION_BLOCK "Test"\nVAR x : ARRAY[0..#LAST] OF INT; END_VAR\n'
        "VAR CONSTANT LAST : INT := #HALF * 2; HALF : INT := 3; END_VAR\n"
        "BEGIN\n#x[#LAST] := 1;\nEND_FUNCTION_BLOCK\n",
        "tia",
    )
    assert variable(program, "test", "x").type == ArrayType(((0, 6),), INT)


def test_constants_that_need_each_other_are_recursive() -> None:
    text = "PROGRAM main\nVAR CONSTANT a : INT := b; b : INT := a; END_VAR\n;\nEND_PROGRAM\n"
    assert "FB4050" in {one.code for one in errors_of(text)}


def test_constant_array_stays_a_variable_that_nobody_writes() -> None:
    text = (
        "FUNCTION_BLOCK b\nVAR CONSTANT tab : ARRAY[0..1] OF INT := [4, 5]; END_VAR\n"
        "VAR_OUTPUT x : INT; END_VAR\n{}\nEND_FUNCTION_BLOCK\n"
    )
    program = program_of(text.format("x := tab[1];"))
    assert variable(program, "b", "tab").initial == ArrayInitial((4, 5))
    found = errors_of(text.format("tab[1] := 3;"))
    assert [one.code for one in found] == ["FB4020"]


def test_data_blocks_are_global_variables_with_start_values() -> None:
    program = program_of(
        UDT
        + in_static("n : INT := 3;").replace("VAR n", "VAR a : INT; n")
        + 'DATA_BLOCK "Own"\nSTRUCT x : INT := 3; y : ARRAY[1..2] OF INT; END_STRUCT;\n'
        "BEGIN\nx := 7;\ny[2] := 9;\nEND_DATA_BLOCK\n"
        'DATA_BLOCK "OfType" "typeFrame"\nBEGIN\ninner.b := 2.5;\ndata[3] := 16#AA;\n'
        "END_DATA_BLOCK\n"
        'DATA_BLOCK "Inst" "Test"\nBEGIN\nn := 8;\nEND_DATA_BLOCK\n',
        "tia",
    )
    own, of_type, inst = (program.globals[key] for key in ("own", "oftype", "inst"))
    assert isinstance(own.type, StructType)
    assert own.initial == StructInitial((("x", 7), ("y", ArrayInitial((None, 9)))))
    assert of_type.type is program.structures["typeframe"]
    assert of_type.initial == StructInitial(
        (
            ("inner", StructInitial((("b", 2.5),))),
            ("data", ArrayInitial((1, 0xFF, 0xFF, 0xAA))),
        )
    )
    assert isinstance(inst.type, BlockType)
    assert inst.initial == StructInitial((("n", 8),))


def test_instances_of_one_block_share_one_type() -> None:
    program = program_of(in_program("a : TON; b : ton;", "a(IN := b.Q); b(IN := a.Q);"))
    assert variable(program, "main", "a").type is variable(program, "main", "b").type


def test_located_and_external_variables() -> None:
    program = program_of(
        "VAR_GLOBAL CONSTANT LAST : INT := 4; END_VAR\n"
        "VAR_GLOBAL b : Fb; x : INT := LAST; inp AT %IW4 : WORD; END_VAR\n"
        "FUNCTION_BLOCK Fb\nVAR_EXTERNAL x : INT; inp : WORD; END_VAR\n"
        "x := WORD_TO_INT(inp);\nEND_FUNCTION_BLOCK\n"
    )
    assert set(program.globals) == {"b", "x", "inp"}
    assert program.globals["x"].initial == 4
    address = program.globals["inp"].address
    assert address is not None
    assert (address.area, address.byte, address.bits) == ("I", 4, 16)
    assert program.blocks["fb"].variables == ()


def test_tasks_name_their_programs() -> None:
    program = program_of(
        in_program("x : INT;", "x := 1;")
        + "CONFIGURATION c\nVAR_GLOBAL g : INT; END_VAR\nRESOURCE r ON PLC\n"
        "TASK slow(INTERVAL := T#100ms, PRIORITY := 5);\n"
        "TASK fast(INTERVAL := T#10ms, PRIORITY := 1);\n"
        "PROGRAM one WITH fast : main;\nPROGRAM two WITH slow : main;\nPROGRAM free : main;\n"
        "END_RESOURCE\nEND_CONFIGURATION\n"
    )
    assert [(one.name, one.interval_ns, one.priority) for one in program.tasks[:2]] == [
        ("fast", 10_000_000, 1),
        ("slow", 100_000_000, 5),
    ]
    assert program.tasks[2].interval_ns is None
    assert program.tasks[0].programs == (("one", program.blocks["main"]),)
    assert "g" in program.globals


def test_organization_block_is_a_block_with_temporary_variables() -> None:
    program = program_of(
        'ORGANIZATION_BLOCK "Main"\nVAR_TEMP t : INT; END_VAR\nBEGIN\n#t := 1;\n'
        "END_ORGANIZATION_BLOCK\n",
        "tia",
    )
    assert program.blocks["main"].kind is BlockKind.ORGANIZATION_BLOCK


@pytest.mark.parametrize(
    "text",
    [
        "FUNCTION_BLOCK a VAR x : b; END_VAR ; END_FUNCTION_BLOCK\n"
        "FUNCTION_BLOCK b VAR x : ARRAY[0..1] OF a; END_VAR ; END_FUNCTION_BLOCK",
        "TYPE a : STRUCT x : b; END_STRUCT; b : ARRAY[0..1] OF a; END_TYPE",
    ],
)
def test_recursion_over_several_declarations_is_found(text: str) -> None:
    assert [one.code for one in errors_of(text)] == ["FB4050"]


def test_calls_in_a_circle_are_found() -> None:
    text = (
        "FUNCTION a : INT\na := b();\nEND_FUNCTION\nFUNCTION b : INT\nb := c();\nEND_FUNCTION\n"
        "FUNCTION c : INT\nc := a();\nEND_FUNCTION\n"
    )
    (found,) = errors_of(text)
    assert found.code == "FB4051"
    assert "a -> b -> c -> a" in found.message


def test_same_name_for_a_block_and_a_global_variable() -> None:
    text = "VAR_GLOBAL Main : INT; END_VAR\n" + in_program("x : INT;", "x := 1;")
    (found,) = errors_of(text)
    assert (found.code, len(found.notes)) == ("FB4002", 1)


def test_large_arrays_are_refused_before_they_fill_the_memory() -> None:
    text = in_program("x : ARRAY[0..2000000000] OF ARRAY[0..9] OF INT;", "x[0][0] := 1;")
    assert [one.code for one in errors_of(text)] == ["FB4052"]
    text = in_program("x : ARRAY[0..9] OF INT := [2000000000(1)];", "x[0] := 1;")
    assert [one.code for one in errors_of(text)] == ["FB4057"]


def test_each_start_value_of_a_data_block_changes_one_part() -> None:
    """Also inside of elements of an array, over what the type and earlier ones say; the initial
    values of the type stay as they are."""
    lines = (
        "frames[2].data[1] := 7; frames[2].inner.a := 8; frames[2].inner.b := 1.5; "
        "frames[1].inv := 9;"
    )
    text = (
        f"{UDT}\n"
        'DATA_BLOCK "one" STRUCT frames : ARRAY[1..2] OF "typeFrame"; END_STRUCT; '
        f"BEGIN {lines} frames[2].data[1] := 6; END_DATA_BLOCK\n"
        'DATA_BLOCK "other" "typeFrame" BEGIN inner.a := 4; data[3] := 3; END_DATA_BLOCK\n'
        'DATA_BLOCK "plain" "typeFrame" BEGIN END_DATA_BLOCK\n'
    )
    found = program_of(text, "tia").globals
    values = {name: found[name].initial for name in ("one", "other", "plain")}
    frames = StructInitial(
        (
            ("data", ArrayInitial((1, 6, 255, None))),
            ("inner", StructInitial((("a", 8), ("b", 1.5)))),
        )
    )
    first = StructInitial((("inv", 9),))
    assert values["one"] == StructInitial((("frames", ArrayInitial((first, frames))),))
    assert values["plain"] is None
    assert values["other"] == StructInitial(
        (
            ("inner", StructInitial((("a", 4),))),
            ("data", ArrayInitial((1, 255, 255, 3))),
        )
    )
