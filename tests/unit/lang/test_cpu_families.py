"""Types and constructs that a CPU family does not have."""

from pathlib import Path

import pytest
from checking import in_block

from fbgen.lang.analysis.cpu import missing_on
from fbgen.lang.families import MISSING_TYPES, Cpu
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


def test_every_family_has_its_table() -> None:
    assert set(MISSING_TYPES) == set(Cpu)
