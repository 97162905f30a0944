"""CASE takes the first arm that has the value, else ELSE, and goes on behind END_CASE."""

from collections.abc import Callable

import pytest

from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]


@pytest.mark.parametrize(
    ("selector", "chosen"),
    [(-6, 5), (-5, 1), (-1, 1), (0, 2), (1, 3), (2, 5), (3, 3), (9, 5), (10, 3), (12, 3), (13, 5)],
)
def test_the_arm_with_the_value_is_taken(load: Load, selector: int, chosen: int) -> None:
    block = load("case.scl").instance("Choose")
    block(selector=selector)
    assert block.chosen == chosen


@pytest.mark.parametrize(("pattern", "expected"), [(0, 1), (1, 0), (0xEF, 0), (0xF0, 2), (0xFF, 2)])
def test_a_bit_string_selects_too_and_without_else_nothing_happens(
    load: Load, pattern: int, expected: int
) -> None:
    block = load("case.scl").instance("Choose")
    block(selector=32767, pattern=pattern)
    assert (block.chosen, block.byPattern) == (4, expected)


def test_return_inside_an_arm_leaves_the_block(load: Load) -> None:
    block = load("case.scl").instance("Choose")
    block(selector=11, pattern=0xFF)
    assert (block.chosen, block.byPattern) == (3, 0)
