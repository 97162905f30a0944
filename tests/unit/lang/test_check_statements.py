"""Statements: what an engine gets, and what is refused."""

import pytest
from checking import errors_of, findings_of, in_block, in_program, program_of

from fbgen.lang.checked import (
    Assignment,
    Binary,
    Case,
    Constant,
    For,
    If,
    Repeat,
    Statement,
    VariableRef,
    While,
)
from fbgen.lang.types import INT, UINT


def statements(text: str, dialect: str = "iec") -> tuple[Statement, ...]:
    return next(iter(program_of(text, dialect).bodies.values()))


def test_regions_and_empty_statements_leave_no_trace() -> None:
    found = statements(
        in_block("x : INT;", "REGION a 'b\n;\n#x := 1;\nEND_REGION end\n#x := 2;"), "tia"
    )
    assert [type(one) for one in found] == [Assignment, Assignment]


def test_operator_assignment_is_a_calculation() -> None:
    (found,) = statements(in_block("x : INT;", "#x += 2;"), "tia")
    assert isinstance(found, Assignment)
    assert isinstance(found.value, Binary)
    assert found.value.operator == "+"


def test_case_ranges_are_numbers() -> None:
    (found,) = statements(
        in_program("x : INT;", "CASE x OF 1, 3..5: x := 0; -2: x := 1; ELSE x := 2; END_CASE;")
    )
    assert isinstance(found, Case)
    assert [arm.ranges for arm in found.arms] == [((1, 1), (3, 5)), ((-2, -2),)]
    assert len(found.otherwise) == 1


def test_case_selects_by_bit_string() -> None:
    (found,) = statements(in_program("w : WORD;", "CASE w OF 16#8000..16#FFFF: w := 0; END_CASE;"))
    assert isinstance(found, Case)
    assert found.arms[0].ranges == ((0x8000, 0xFFFF),)


def test_every_overlapping_label_is_reported_with_the_first_place() -> None:
    text = in_program("x : INT;", "CASE x OF\n1..9: ;\n3: ;\n5..12: ;\n20: ;\n20: ;\nEND_CASE;")
    found = errors_of(text)
    assert [(one.code, one.span and one.span.line) for one in found] == [
        ("FB4030", 5),
        ("FB4030", 6),
        ("FB4030", 8),
    ]
    assert found[0].notes[0].span is not None
    assert found[0].notes[0].span.line == 4


def test_for_counts_in_the_type_of_its_variable() -> None:
    (found,) = statements(in_program("i : INT; s : SINT;", "FOR i := s TO 7 DO ; END_FOR;"))
    assert isinstance(found, For)
    assert {found.first.type, found.last.type, found.step.type} == {INT}
    assert isinstance(found.step, Constant)
    assert found.step.value == 1


def test_unsigned_for_counts_down_by_a_signed_step() -> None:
    (found,) = statements(in_program("i : UINT;", "FOR i := 7 TO 0 BY -1 DO ; END_FOR;"))
    assert isinstance(found, For)
    assert isinstance(found.step, Constant)
    assert (found.variable.type, found.step.type, found.step.value) == (UINT, INT, -1)


def test_loops_keep_their_conditions() -> None:
    found = statements(
        in_program(
            "i : INT;",
            "WHILE i < 5 DO i := i + 1; EXIT; END_WHILE;"
            " REPEAT CONTINUE; UNTIL TRUE END_REPEAT; IF i = 1 THEN ; ELSIF TRUE THEN ; END_IF;",
        )
    )
    assert [type(one) for one in found] == [While, Repeat, If]


def test_structures_are_copied_if_they_are_of_one_type() -> None:
    types = "TYPE P : STRUCT a : INT; END_STRUCT; Q : STRUCT a : INT; END_STRUCT; END_TYPE\n"
    good = types + in_program("x : P; y : P;", "x := y;")
    assert isinstance(statements(good)[0], Assignment)
    bad = types + in_program("x : P; y : Q;", "x := y;")
    assert [one.code for one in errors_of(bad)] == ["FB4010"]


@pytest.mark.parametrize(
    ("declarations", "statement", "code"),
    [
        ("x : INT;", "IF x THEN ; END_IF;", "FB4013"),
        ("x : INT;", "WHILE 1.5 DO ; END_WHILE;", "FB4013"),
        ("x : INT;", "REPEAT ; UNTIL x END_REPEAT;", "FB4013"),
        ("x : ARRAY[0..1] OF INT;", "x := 5;", "FB4010"),
        ("x : ARRAY[0..1] OF INT; y : ARRAY[1..2] OF INT;", "x := y;", "FB4010"),
        ("x : TON; y : TOF;", "x := y;", "FB4010"),
        ("x : INT;", "CONTINUE;", "FB4034"),
        ("x : INT;", "x[1] := 5;", "FB4019"),
        ("x : INT;", "x.y := 5;", "FB4005"),
        ("x : ARRAY[0..1] OF INT; y : REAL;", "x[y] := 5;", "FB4010"),
        ("x : ARRAY[0..1] OF INT;", "x[-1] := 5;", "FB4015"),
        ("x : INT; y : INT;", "CASE x OF y: ; END_CASE;", "FB4017"),
        ("x : USINT;", "CASE x OF 256: ; END_CASE;", "FB4014"),
        ("x : INT;", "FOR x := 0 TO 40000 DO ; END_FOR;", "FB4014"),
        ("x : INT;", "x := x MOD 0;", "FB4016"),
        ("x : REAL;", "x := x / 0.0;", "FB4016"),
        ("x : REAL;", "x := x MOD 2.0;", "FB4012"),
        ("x : BOOL;", "x := x < TRUE;", "FB4012"),
        ("x : STRING;", "x := x + 'a';", "FB4012"),
        ("x : UINT;", "x := -x;", "FB4012"),
        ("x : INT;", "x := NOT x;", "FB4012"),
    ],
)
def test_wrong_statements(declarations: str, statement: str, code: str) -> None:
    found = errors_of(in_program(declarations, statement))
    assert [one.code for one in found] == [code]


def test_one_mistake_is_reported_once() -> None:
    text = in_program("x : INT;", "x := unknwon + 1 - x * 2; IF unknown2 > 5 THEN x := 1; END_IF;")
    assert [one.code for one in errors_of(text)] == ["FB4001", "FB4001"]


def test_all_mistakes_of_a_text_are_reported_together_in_order() -> None:
    text = in_program("x : INT; y : REEL;", "x := 1.5;\nx := 'a';\nIF x THEN x := zz; END_IF;")
    assert [one.code for one in errors_of(text)] == [
        "FB4003",
        "FB4010",
        "FB4010",
        "FB4013",
        "FB4001",
    ]


def test_name_with_hash_is_not_looked_up_among_the_globals() -> None:
    text = 'DATA_BLOCK "D"\nSTRUCT x : INT; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n'
    found = errors_of(text + in_block("y : INT;", "#y := #D.x;"), "tia")
    assert [one.code for one in found] == ["FB4001"]
    (good,) = statements(text + in_block("y : INT;", '#y := "D".x;'), "tia")
    assert isinstance(good, Assignment)


def test_local_name_hides_the_global_one() -> None:
    text = "VAR_GLOBAL x : REAL; END_VAR\n" + in_program("x : INT;", "x := 1;")
    (found,) = statements(text)
    assert isinstance(found, Assignment)
    assert isinstance(found.target, VariableRef)
    assert found.target.type == INT


def test_warnings_do_not_stop_the_program() -> None:
    text = in_program("x : INT; unused : INT;", "x := 1;")
    assert [(one.code, one.severity.value) for one in findings_of(text)] == [("FB4101", "warning")]
    assert program_of(text).blocks
