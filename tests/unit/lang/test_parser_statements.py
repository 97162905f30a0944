"""Statements and blocks as trees, with their comments."""

from pathlib import Path

import pytest
from trees import body, comments, read

from fbgen.lang import ast
from fbgen.lang.encoding import read_source
from fbgen.lang.parser import parse

_SAMPLES = Path(__file__).parent / "samples"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("#x := 1;", ast.Assignment),
        ("#x += 1;", ast.Assignment),
        ("%QB4 := 1;", ast.Assignment),
        ("f(1);", ast.CallStatement),
        ("IF #a THEN #x := 1; ELSIF #b THEN ; ELSE ; END_IF;", ast.If),
        ("CASE #x OF 1: ; END_CASE;", ast.Case),
        ("FOR #i := 1 TO 10 BY 2 DO ; END_FOR;", ast.For),
        ("WHILE #a DO ; END_WHILE;", ast.While),
        ("REPEAT ; UNTIL #a END_REPEAT;", ast.Repeat),
        ("REPEAT ; UNTIL #a; END_REPEAT;", ast.Repeat),
        ("REGION a 'b\nEND_REGION c", ast.Region),
        ("EXIT;", ast.Jump),
        ("return;", ast.Jump),
        ("GOTO there;", ast.Goto),
        (";", ast.Empty),
    ],
)
def test_statements(text: str, kind: type) -> None:
    (statement,) = body(text)
    assert type(statement) is kind


def test_case_labels_are_values_ranges_and_constants() -> None:
    (case,) = body('CASE #x OF\n -1, 3..5: ;\n #MAX: ;\n "C".d, A + 1: ;\n ELSE: ; END_CASE;')
    assert isinstance(case, ast.Case)
    assert [len(arm.labels) for arm in case.arms] == [2, 1, 2]
    assert isinstance(case.arms[0].labels[1], ast.LabelRange)
    assert case.otherwise is not None


def test_a_jump_label_in_a_case_is_known_by_the_gotos() -> None:
    (case,) = body("CASE #x OF\n 1: GOTO next;\n next: #y := 1;\n TWO: ;\nEND_CASE;")
    assert isinstance(case, ast.Case)
    assert len(case.arms) == 2
    assert [type(item).__name__ for item in case.arms[0].body] == ["Goto", "Label", "Assignment"]


def test_comments_stand_at_their_statements() -> None:
    statements = body("// a\n#x := 1; // b\n\n(* c *)\n#y := 2;\n// d")
    first, second = statements
    assert isinstance(first, ast.Assignment)
    assert [item.text for item in first.leading] == ["// a"]
    assert first.trailing is not None
    assert first.trailing.text == "// b"
    assert isinstance(second, ast.Assignment)
    assert [item.text for item in second.leading] == ["", "(* c *)"]


def test_a_comment_inside_an_expression_moves_in_front_of_its_statement() -> None:
    (statement,) = body("#x := 1 // why\n + 2;")
    assert isinstance(statement, ast.Assignment)
    assert [item.text for item in statement.leading] == ["// why"]


def test_comments_behind_arguments_stay_there() -> None:
    (statement,) = body("f(a := 1, // one\n  // two before\n  b := 2 // two\n);")
    assert isinstance(statement, ast.CallStatement)
    first, second = statement.call.arguments
    assert first.trailing is not None
    assert first.trailing.text == "// one"
    assert [item.text for item in second.leading] == ["// two before"]
    assert second.trailing is not None
    assert second.trailing.text == "// two"


def test_every_comment_of_a_file_is_in_its_tree() -> None:
    source = read_source(_SAMPLES / "everything.scl")
    tree = parse(source, "tia")
    lines = [line.partition("//")[2] for line in source.text.splitlines() if "//" in line]
    expected = [f"//{rest}" for rest in lines if rest != " x"]  # that one belongs to a raw TITLE
    assert [item for item in comments(tree) if item.startswith("//")] == sorted(expected)
    assert "(* why *)" in comments(tree)


def test_the_header_of_a_block() -> None:
    file = read(
        "FUNCTION \"F\" : Void { S7_Optimized_Access := 'TRUE' }\n"
        "TITLE = It's (free\n// why\nAUTHOR : O'Neil\nVERSION : '0.1'\nKNOW_HOW_PROTECT\n"
        "VAR_INPUT\n a : Int;\nEND_VAR\nBEGIN\nEND_FUNCTION"
    )
    block = file.units[0]
    assert isinstance(block, ast.Block)
    assert [(item.keyword, item.text) for item in block.header] == [
        ("{}", "{ S7_Optimized_Access := 'TRUE' }"),
        ("TITLE", "It's (free"),
        ("AUTHOR", "O'Neil"),
        ("VERSION", "'0.1'"),
        ("KNOW_HOW_PROTECT", ""),
    ]
    assert [item.text for item in block.header_comments] == ["// why"]
    assert isinstance(block.return_type, ast.NamedType)
    assert block.return_type.name == "Void"


def test_declarations_with_attributes_views_and_reserved_words_as_names() -> None:
    file = read(
        'FUNCTION_BLOCK "B"\nVAR RETAIN\n'
        " t {InstructionName := 'TON_TIME'} : TON_TIME;\n a, \"b c\" : Int := 5;\n"
        " view AT a : Array[0..1] of Byte;\n s : String[#LEN];\n type : Int;\n"
        " p : {x} Struct\n  q : Bool;\n END_STRUCT\nEND_VAR\nVAR CONSTANT\n LEN : Int := 5;\n"
        "END_VAR\nVAR_IN_OUT\n v : Array[*] of Int;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK"
    )
    block = file.units[0]
    assert isinstance(block, ast.Block)
    first, constants, in_out = block.sections
    assert first.qualifiers == ("RETAIN",)
    assert first.declarations[0].names[0].attributes == "{InstructionName := 'TON_TIME'}"
    assert [name.name for name in first.declarations[1].names] == ["a", "b c"]
    assert isinstance(first.declarations[2].at, ast.Name)
    assert isinstance(first.declarations[3].type, ast.StringSpec)
    assert first.declarations[4].names[0].name == "type"
    assert first.declarations[5].type_attributes == "{x}"
    assert constants.qualifiers == ("CONSTANT",)
    spec = in_out.declarations[0].type
    assert isinstance(spec, ast.ArraySpec)
    assert spec.bounds[0].first is None


def test_data_blocks_of_every_kind() -> None:
    file = read(
        'DATA_BLOCK "A"\nVERSION : 0.1\nNON_RETAIN\nSTRUCT\n a : Int;\nEND_STRUCT;\nBEGIN\n'
        ' a := 5;\nEND_DATA_BLOCK\nDATA_BLOCK "B" "FB"\nBEGIN\n x.y := 1;\nEND_DATA_BLOCK\n'
        'DATA_BLOCK "C"\nVAR\n a : Int;\nEND_VAR\nBEGIN\nEND_DATA_BLOCK'
    )
    own, instance, sections = file.units
    assert isinstance(own, ast.DataBlock)
    assert own.struct is not None
    assert len(own.assignments) == 1
    assert isinstance(instance, ast.DataBlock)
    assert instance.type is not None
    assert instance.type.name == "FB"
    assert isinstance(sections, ast.DataBlock)
    assert len(sections.sections) == 1


def test_types_of_both_spellings() -> None:
    siemens = read('TYPE "T" VERSION : 0.1 STRUCT a : Int; END_STRUCT END_TYPE').units
    assert [type(unit).__name__ for unit in siemens] == ["TypeDeclaration"]
    plain = read("TYPE a : STRUCT x : INT; END_STRUCT; b : INT := 5; END_TYPE", "iec").units
    assert [unit.name.name for unit in plain if isinstance(unit, ast.TypeDeclaration)] == ["a", "b"]


def test_a_configuration() -> None:
    file = read(
        "CONFIGURATION c\nVAR_GLOBAL\n i AT %IB0 : BYTE;\nEND_VAR\nRESOURCE r ON PLC\n"
        "TASK t(INTERVAL := T#10ms, PRIORITY := 0);\nPROGRAM p WITH t : main;\nEND_RESOURCE\n"
        "END_CONFIGURATION\nPROGRAM main\nVAR_EXTERNAL i : BYTE; END_VAR\n;\nEND_PROGRAM",
        "iec",
    )
    configuration, program = file.units
    assert isinstance(configuration, ast.Configuration)
    (resource,) = configuration.resources
    assert (resource.name, resource.on) == ("r", "PLC")
    assert resource.tasks[0].name == "t"
    assert (resource.programs[0].task, resource.programs[0].type.name) == ("t", "main")
    assert isinstance(configuration.sections[0].declarations[0].at, ast.DirectAddress)
    assert isinstance(program, ast.Block)


def test_spans_cover_what_was_written() -> None:
    (statement,) = body("  #x := SHL(#y, 2) + 1; // c")
    assert isinstance(statement, ast.Assignment)
    assert statement.span.text == "#x := SHL(#y, 2) + 1;"
    assert statement.value.span.text == "SHL(#y, 2) + 1"
