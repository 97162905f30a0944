"""A slice of a slice is a part of the whole: IEC 61131-3 third edition, 6.5.5 (partial access)."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import load_program

TEXT = """
FUNCTION_BLOCK F
VAR_INPUT w : LWORD; n : DWORD; END_VAR
VAR_OUTPUT b : BOOL; y : BYTE; z : DWORD; END_VAR
{m}b := {m}w.%D1.%W1.%B1.%X1;
{m}y := {m}w.%D0.%B3;
{m}z := {m}n;
{m}z.%W1.%X15 := TRUE;
{m}z.%W0.%B1 := 16#AB;
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize("dialect", ["tia", "iec"])
def test_a_part_of_a_part_is_read_and_written(dialect: str, engine_name: str) -> None:
    text = TEXT.format(m="#" if dialect == "tia" else "")
    block = load_program([Source("f.st", text)], dialect, engine_name).instance("F")
    block(w=0xABCD_EF12_3456_7890, n=0x0000_0011)
    assert (block.b, block.y, block.z) == (True, 0x34, 0x8000_AB11)
    block(w=0, n=0)
    assert (block.b, block.y, block.z) == (False, 0, 0x8000_AB00)


@pytest.mark.parametrize("part", ["%W0.%B2", "%B1.%W0", "%X3.%X0"])
def test_a_part_has_only_the_parts_of_its_own_width(part: str) -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR a, y : DWORD; b : BOOL; END_VAR\n"
        f"b := a.{part} = a.{part};\nEND_FUNCTION_BLOCK\n"
    )
    with pytest.raises(DiagnosticError) as refused:
        load_program([Source("f.st", text)], "iec")
    assert {one.code for one in refused.value.diagnostics} == {"FB4018"}
