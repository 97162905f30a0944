"""DTL (TIA Portal help, "DTL", "T_ADD", "T_DIFF"); the expected values are the calendar's."""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]
_NS_PER_S = 1_000_000_000
_SECONDS_2024_02_29 = 1_709_164_800
_STAMP = (_SECONDS_2024_02_29 + 86_399) * _NS_PER_S + 500_000_000


def _dtl(year: int, month: int, day: int, weekday: int, *clock: int) -> dict[str, int]:
    names = ("YEAR", "MONTH", "DAY", "WEEKDAY", "HOUR", "MINUTE", "SECOND", "NANOSECOND")
    numbers = (year, month, day, weekday, *clock, 0, 0, 0, 0)
    return dict(zip(names, numbers, strict=False))


@pytest.fixture
def block(load: Load) -> BlockInstance:
    instance = load("dates.scl").instance("Dates")
    instance()
    return instance


def test_literals_and_initial_values(load: Load, block: BlockInstance) -> None:
    fresh = load("dates.scl").instance("Dates")
    assert fresh.fresh == _dtl(1970, 1, 1, 5)
    assert fresh.set == _dtl(2023, 7, 1, 5)
    assert fresh.moment == _dtl(2024, 2, 29, 5, 23, 59, 59, 500_000_000)
    assert block.literal == _dtl(1999, 12, 31, 6, 12, 30, 15, 123_456_789)
    assert (block.year, block.weekday) == (1999, 5)


def test_calculation_passes_the_leap_day(block: BlockInstance) -> None:
    assert block.next == _dtl(2024, 3, 1, 6, 23, 59, 59, 500_000_000)
    assert block.summed == _dtl(1999, 12, 31, 6, 12, 31, 15, 123_456_789)
    assert block.difference == 500_000_000
    assert block.inMs == 500


def test_comparison_is_by_time(block: BlockInstance) -> None:
    assert (block.isLater, block.isEqual, block.isAfterStamp) == (True, True, True)


def test_conversions(block: BlockInstance) -> None:
    assert block.asStamp == block.asDt == _STAMP
    assert block.asDate == 12_477
    assert block.asTod == 86_399_500
    assert block.asLtod == 86_399_500_000_000
    assert block.back == block.moment
    assert block.fromDate == _dtl(2024, 12, 25, 4)
    assert block.fromDt == _dtl(2000, 1, 1, 7, 6)


def test_the_weekday_is_worked_out_anew(block: BlockInstance) -> None:
    assert block.later == _dtl(1970, 2, 1, 1)


def test_a_date_that_does_not_exist_stops_the_program(load: Load) -> None:
    block = load("dates.scl").instance("Dates")
    block.month = 13
    with pytest.raises(DiagnosticError) as caught:
        block()
    (found,) = caught.value.diagnostics
    assert found.code == "FB6032"
    assert found.span is not None
    assert found.span.text == "fresh"
