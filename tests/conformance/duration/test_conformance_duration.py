"""TIME counts milliseconds in signed 32 bit (TIA Portal help, "TIME (IEC time)")."""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


def durations(load: Load, **inputs: float) -> BlockInstance:
    block = load("duration.scl").instance("Durations")
    block(**inputs)
    return block


def test_durations_are_added_and_compared(load: Load) -> None:
    block = durations(load, a=1500, b=2500)
    assert (block.sum, block.difference, block.longer) == (4000, -1000, False)


def test_a_sum_beyond_24_days_wraps_around(load: Load) -> None:
    block = durations(load, a=2147483647, b=1)
    assert (block.sum, block.difference) == (-2147483648, 2147483646)


def test_a_duration_times_a_whole_number(load: Load) -> None:
    assert durations(load, a=250, whole=-3).times == -750


@pytest.mark.parametrize(("a", "real", "scaled"), [(1000, 0.5, 500), (5, 0.5, 2), (7, 0.5, 4)])
def test_a_duration_times_a_real_is_the_nearest_tick(
    load: Load, a: int, real: float, scaled: int
) -> None:
    assert durations(load, a=a, real=real).scaled == scaled


def test_a_duration_times_a_real_that_does_not_fit_is_reported(load: Load) -> None:
    with pytest.raises(DiagnosticError, match="FB6006"):
        durations(load, a=1_000_000, real=1.0e6)


def test_a_literal_has_all_its_parts(load: Load) -> None:
    assert durations(load).constant == ((26 * 60 + 3) * 60 + 4) * 1000 + 5
