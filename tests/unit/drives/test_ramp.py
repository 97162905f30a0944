"""Ramps that are worked out when somebody looks."""

from math import inf

import pytest

from harness.drives.ramp import Ramp, standing
from harness.kernel import NS_PER_S


@pytest.mark.parametrize(
    ("seconds", "hz"), [(0, 0.0), (1, 5.0), (2.5, 12.5), (4, 20.0), (100, 20.0)]
)
def test_frequency_rises_in_a_straight_line_to_the_target(seconds: float, hz: float) -> None:
    ramp = Ramp(NS_PER_S, 0.0, 20.0, 5.0, 10.0)
    assert ramp.at(NS_PER_S + round(seconds * NS_PER_S)) == pytest.approx(hz)


def test_towards_zero_the_deceleration_counts() -> None:
    ramp = Ramp(0, -20.0, -10.0, 5.0, 10.0)
    assert ramp.at(NS_PER_S // 2) == pytest.approx(-15.0)
    assert ramp.end_ns == NS_PER_S


def test_change_of_direction_goes_through_zero_with_both_rates() -> None:
    ramp = Ramp(0, 20.0, -10.0, 5.0, 10.0)
    assert [ramp.at(t * NS_PER_S) for t in (1, 2, 3, 4, 5)] == pytest.approx(
        [10.0, 0.0, -5.0, -10.0, -10.0]
    )
    assert ramp.end_ns == 4 * NS_PER_S
    assert [ramp.slope(t * NS_PER_S) for t in (1, 3, 4)] == [-10.0, 5.0, 0.0]


def test_ramp_time_of_zero_jumps() -> None:
    assert Ramp(0, 0.0, 50.0, inf, inf).at(0) == 50.0
    assert Ramp(0, 30.0, -50.0, inf, inf).at(0) == -50.0
    assert Ramp(0, 30.0, -50.0, inf, inf).end_ns == 0


def test_what_stands_still_has_arrived() -> None:
    assert (standing(7).at(9), standing(7).end_ns, standing(7).slope(9)) == (0.0, 7, 0.0)
