"""CONST of STEP 7: names without a type that stand for their values."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import load_program

TEXT = """\
FUNCTION_BLOCK Unit
CONST
  LAST := 3;
  BASE := LAST * 2;
  LIMIT_BITS := W#16#00F0;
  FACTOR := 2.5;
END_CONST
VAR_OUTPUT
  small : INT;
  large : DINT;
  real : REAL;
  bits : WORD;
  size : INT;
END_VAR
VAR
  list : ARRAY[0..LAST] OF INT := 1, 2, 3, 4;
END_VAR
BEGIN
  small := BASE;
  large := BASE;
  real := BASE * FACTOR;
  bits := LIMIT_BITS;
  size := list[LAST];
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_a_constant_takes_the_type_that_its_place_asks_for(engine: str) -> None:
    text = TEXT.replace("1, 2, 3, 4", "[1, 2, 3, 4]")
    block = load_program([Source("unit", text)], "step7", engine).instance("Unit")
    block()
    assert (block.small, block.large, block.real) == (6, 6, 15.0)
    assert (block.bits, block.size) == (0x00F0, 4)


def test_a_value_that_is_not_constant_is_refused() -> None:
    text = TEXT.replace("LAST * 2", "small * 2").replace("1, 2, 3, 4", "[1, 2, 3, 4]")
    with pytest.raises(DiagnosticError) as refused:
        load_program([Source("unit", text)], "step7")
    assert "FB4017" in {found.code for found in refused.value.diagnostics}


@pytest.mark.parametrize("initial", ["1, 2, 3, 4", "4(7)"])
def test_arrays_may_have_their_values_without_brackets(initial: str) -> None:
    text = TEXT.replace("1, 2, 3, 4", initial)
    block = load_program([Source("unit", text)], "step7").instance("Unit")
    assert block.list[3] == (7 if "7" in initial else 4)
