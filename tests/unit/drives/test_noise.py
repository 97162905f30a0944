"""Noise on a line for an hour: no wrong value is taken unless a check sum collides."""

from pathlib import Path

import pytest
from noise import KINDS, Count, count

PAGE = Path(__file__).parents[3] / "docs" / "reference" / "protocols.md"
HOUR_S = 3600
MINUTES_S = 120


@pytest.mark.parametrize(("protocol", "parity"), [kind[1:] for kind in KINDS])
def test_minutes_of_noise_bring_no_wrong_value(protocol: str, parity: str) -> None:
    found = count(protocol, parity, MINUTES_S, seed=1)
    assert (found.wrong_in_inverter, found.wrong_in_master) == (0, 0)
    assert 0.8 < found.answered / found.telegrams < 0.9


def test_wrong_values_that_a_colliding_sum_lets_through_are_counted() -> None:
    found = count("toshiba", "none", 5 * MINUTES_S, seed=1, rate=1e-2)
    assert found.wrong_in_inverter > 0
    assert found.wrong_in_master > 0


def test_a_quiet_line_loses_nothing() -> None:
    assert count("modbus", "even", 10, seed=1, rate=0.0) == Count(226, 226, 0, 0)


@pytest.mark.slow
@pytest.mark.parametrize("rate", [1e-3, 1e-2])
@pytest.mark.parametrize(("title", "protocol", "parity"), KINDS)
def test_an_hour_of_noise_is_as_the_page_says(
    title: str, protocol: str, parity: str, rate: float
) -> None:
    found = count(protocol, parity, HOUR_S, seed=1, rate=rate)
    assert found.row(title) in PAGE.read_text(encoding="utf-8")
    if parity == "even" or protocol == "modbus":
        assert (found.wrong_in_inverter, found.wrong_in_master) == (0, 0)
