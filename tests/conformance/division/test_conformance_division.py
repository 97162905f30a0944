"""Division cuts towards zero, MOD has the sign of the dividend (IEC 61131-3 table 29)."""

import math
from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]


@pytest.mark.parametrize(
    ("dividend", "divisor", "quotient", "remainder"),
    [
        (7, 2, 3, 1),
        (-7, 2, -3, -1),
        (7, -2, -3, 1),
        (-7, -2, 3, -1),
        (-7, 3, -2, -1),
        (6, 3, 2, 0),
        (-32768, -1, -32768, 0),
        (0, 5, 0, 0),
    ],
)
def test_quotient_is_cut_and_remainder_follows_the_dividend(
    load: Load, dividend: int, divisor: int, quotient: int, remainder: int
) -> None:
    block = load("division.scl").instance("Division")
    block(dividend=dividend, divisor=divisor)
    assert (block.quotient, block.remainder) == (quotient, remainder)


def test_division_of_whole_numbers_by_zero_is_reported_at_its_place(load: Load) -> None:
    block = load("division.scl").instance("Division")
    with pytest.raises(DiagnosticError) as failure:
        block(dividend=1, divisor=0)
    diagnostic = failure.value.diagnostics[0]
    assert diagnostic.code == "FB6003"
    assert diagnostic.span is not None
    assert diagnostic.span.text == "#dividend / #divisor"


def test_division_of_a_duration_by_zero_is_reported(load: Load) -> None:
    block = load("division.scl").instance("DurationDivision")
    with pytest.raises(DiagnosticError, match="FB6003"):
        block(duration=1000, divisor=0)


@pytest.mark.parametrize(
    ("dividend", "divisor", "quotient"),
    [(1.0, 0.0, math.inf), (-1.0, 0.0, -math.inf), (1.0, -0.0, -math.inf), (1.0, 4.0, 0.25)],
)
def test_division_of_reals_follows_ieee_754(
    load: Load, dividend: float, divisor: float, quotient: float
) -> None:
    block = load("division.scl").instance("RealDivision")
    block(dividend=dividend, divisor=divisor)
    assert block.quotient == quotient


def test_zero_by_zero_is_not_a_number_and_unequal_to_itself(load: Load) -> None:
    block = load("division.scl").instance("RealDivision")
    block(dividend=0.0, divisor=0.0)
    assert not block.isNumber


def test_division_of_a_duration_is_cut(load: Load) -> None:
    block = load("division.scl").instance("DurationDivision")
    block(duration=-1000, divisor=3)
    assert block.quotient == -333
