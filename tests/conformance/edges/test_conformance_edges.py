"""Edges, also at the first call, and bistables (IEC 61131-3 tables 43 and 44).

By the standard F_TRIG is `Q := NOT CLK AND NOT M; M := NOT CLK` with M FALSE at the start, so
that CLK = FALSE at the first call gives Q = TRUE. On S7 it does not.
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]


def test_an_edge_lasts_one_call(load: Load) -> None:
    block = load("edges.scl").instance("Edges")
    seen = []
    for clock in (False, True, True, False, False, True):
        block(clock=clock)
        seen.append((block.rises, block.falls))
    assert seen == [
        (False, False),
        (True, False),
        (False, False),
        (False, True),
        (False, False),
        (True, False),
    ]


@pytest.mark.parametrize(
    ("name", "clock", "rises", "falls"),
    [
        ("edges.scl", True, True, False),
        ("edges.scl", False, False, False),
        ("edges.st", True, True, False),
        ("edges.st", False, False, True),
    ],
)
def test_the_first_call(load: Load, name: str, clock: bool, rises: bool, falls: bool) -> None:
    block = load(name).instance("Edges")
    block(clock=clock)
    assert (block.rises, block.falls) == (rises, falls)
    block(clock=clock)
    assert (block.rises, block.falls) == (False, False)


@pytest.mark.parametrize(
    ("steps", "set_dominant", "reset_dominant"),
    [
        ([(False, False)], False, False),
        ([(True, False), (False, False)], True, True),
        ([(True, False), (False, True)], False, False),
        ([(True, True)], True, False),
        ([(True, False), (True, True)], True, False),
    ],
)
def test_bistables(
    load: Load, steps: list[tuple[bool, bool]], set_dominant: bool, reset_dominant: bool
) -> None:
    block = load("edges.st").instance("Bistables")
    for is_set, is_reset in steps:
        block(set=is_set, reset=is_reset)
    assert (block.setDominant, block.resetDominant) == (set_dominant, reset_dominant)
