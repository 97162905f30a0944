"""Types and constructs that a CPU family does not have."""

from pathlib import Path

import pytest
from checking import in_block

from fbgen.lang.analysis.cpu import missing_on
from fbgen.lang.families import MISSING_TYPES, Cpu
from fbgen.lang.instruction_families import MISSING_INSTRUCTIONS
from fbgen.lang.parser import parse
from fbgen.source import Source

_BAD = Path(__file__).parent.parent / "bad"


def found(text: str, cpu: Cpu) -> list[tuple[str, int, int]]:
    file = parse(Source("test", text), "tia")
    return [
        (one.code, one.span.line, one.span.column)
        for one in missing_on(cpu, [file])
        if one.span is not None
    ]


@pytest.mark.parametrize(
    ("name", "cpu", "line", "column"),
    [
        ("FB4301_type_not_on_cpu.scl", Cpu.S7_300, 3, 7),
        ("FB4302_construct_not_on_cpu.scl", Cpu.S7_400, 9, 3),
        ("FB4303_instruction_not_on_cpu.scl", Cpu.S7_300, 9, 15),
    ],
)
def test_broken_file_is_reported_at_its_place(name: str, cpu: Cpu, line: int, column: int) -> None:
    text = (_BAD / name).read_text(encoding="utf-8")
    assert (name[:6], line, column) in found(text, cpu)
    assert found(text, Cpu.S7_1500) == []


@pytest.mark.parametrize(
    ("cpu", "kind", "missing"),
    [
        (Cpu.S7_300, "UINT", True),
        (Cpu.S7_1200, "UINT", False),
        (Cpu.S7_1200, "LINT", True),
        (Cpu.S7_1500, "LINT", False),
        (Cpu.S7_1200, "S5TIME", True),
        (Cpu.S7_400, "S5TIME", False),
        (Cpu.S7_300, "WSTRING", True),
        (Cpu.S7_300, "STRING", False),
    ],
)
def test_each_family_has_its_types(cpu: Cpu, kind: str, missing: bool) -> None:
    text = in_block(f"x : {kind};", ";")
    assert [code for code, _, _ in found(text, cpu)] == (["FB4301"] if missing else [])


@pytest.mark.parametrize(
    "statement", ["#x := LINT#5;", "#x := LINT_TO_DINT(#y);", "#x := DINT_TO_LINT(#y);"]
)
def test_literals_and_conversions_name_types_too(statement: str) -> None:
    assert [code for code, _, _ in found(in_block("", statement), Cpu.S7_1200)] == ["FB4301"]


@pytest.mark.parametrize(
    ("declarations", "statement"),
    [
        ("x : WORD;", "#x.%X0 := TRUE;"),
        ("x : INT;", "#x += 1;"),
        ("x : INT;", "REGION one\n#x := 1;\nEND_REGION"),
        ("x : REF_TO INT;", ";"),
    ],
)
def test_the_classic_families_lack_what_came_later(declarations: str, statement: str) -> None:
    text = in_block(declarations, statement)
    assert [code for code, _, _ in found(text, Cpu.S7_300)] == ["FB4302"]
    assert found(text, Cpu.S7_1500) == []


def test_a_type_of_the_user_with_such_a_name_is_his() -> None:
    text = "TYPE DTL : STRUCT x : INT; END_STRUCT; END_TYPE\n".replace("DTL :", '"DTL"\n')
    assert found(text + in_block('x : "DTL";', ";"), Cpu.S7_300) == []


_CLASSIC = (Cpu.S7_300, Cpu.S7_400)
_NEW = (Cpu.S7_1200, Cpu.S7_1500)


@pytest.mark.parametrize(
    ("declarations", "statement", "lacking"),
    [
        ("x : REAL;", "#x := SCALE_X(MIN := 0.0, VALUE := #x, MAX := 1.0);", _CLASSIC),
        ("x : BYTE;", "#x := PEEK(area := 16#83, dbNumber := 0, byteOffset := 1);", _CLASSIC),
        ("x : ARRAY[0..3] OF INT;", "MOVE_BLK(IN := #x[0], COUNT := 1, OUT => #x[1]);", _CLASSIC),
        ("t : R_TRIG;", "#t(CLK := TRUE);", _CLASSIC),
        ("t : TONR_TIME;", "#t(IN := TRUE);", _CLASSIC),
        ("t : TON;", "#t(IN := TRUE, PT := T#1s);", ()),
        ("c : CTUD_LINT;", "#c(CU := TRUE);", (*_CLASSIC, Cpu.S7_1200)),
        ("x : WORD;", "#x := S_CU(C_NO := C5, CU := TRUE);", (Cpu.S7_1200,)),
        ("x : INT;", "#x := BLKMOV(SRCBLK := #x, DSTBLK => #x);", (Cpu.S7_1200,)),
        ("x : INT;", "#x := SFC20(SRCBLK := #x, DSTBLK => #x);", _NEW),
        ("x : INT;", "#x := READ_CLK(CDT => #x);", _NEW),
        ("x : DWORD;", "#x := DECO(IN := 3);", ()),
        ("x : INT;", "#x := LIMIT(MN := 0, IN := #x, MX := 9);", ()),
    ],
)
def test_each_family_has_its_instructions(
    declarations: str, statement: str, lacking: tuple[Cpu, ...]
) -> None:
    text = in_block(declarations, statement)
    told = [cpu for cpu in Cpu if "FB4303" in {code for code, _, _ in found(text, cpu)}]
    assert told == list(lacking)


def test_a_block_of_the_user_with_such_a_name_is_his_also_in_another_file() -> None:
    block = parse(
        Source("own", 'FUNCTION "PEEK" : INT\nBEGIN\n"PEEK" := 1;\nEND_FUNCTION\n'), "tia"
    )
    call = parse(Source("call", in_block("x : INT;", "#x := PEEK();")), "tia")
    assert list(missing_on(Cpu.S7_300, [call, block])) == []
    quoted = in_block("x : INT;", '#x := "PEEK"();')
    assert found(quoted, Cpu.S7_300) == []


def test_every_family_has_its_table() -> None:
    assert set(MISSING_TYPES) == set(MISSING_INSTRUCTIONS) == set(Cpu)
