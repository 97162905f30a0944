"""GOTO goes on behind its label: out of loops, into branches, forwards and backwards.

TIA Portal help, "GOTO: Jump": label and jump stand in one block; a jump may leave a loop and may
not lead into one.
"""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram, load_program
from harness.engine.interface import Limits

Load = Callable[[str], LoadedProgram]


@pytest.mark.parametrize(
    ("wanted", "place"),
    [(1, (1, 1, True)), (6, (2, 3, True)), (9, (3, 3, True)), (10, (0, 0, False))],
)
def test_a_jump_leaves_two_loops_at_once(
    load: Load, wanted: int, place: tuple[int, int, bool]
) -> None:
    block = load("jumps.scl").instance("Search")
    block(wanted=wanted)
    assert (block.row, block.column, block.found) == place


@pytest.mark.parametrize(("start", "sum_of_steps"), [(1, 1111), (2, 1110), (3, 1100), (4, 1000)])
def test_labels_are_fallen_through(load: Load, start: int, sum_of_steps: int) -> None:
    assert load("jumps.scl").call("Steps", start=start) == sum_of_steps


@pytest.mark.parametrize(("count", "total"), [(0, 0), (1, 1), (4, 10), (100, 5050)])
def test_a_jump_back_makes_a_loop_and_labels_do_not_depend_on_case(
    load: Load, count: int, total: int
) -> None:
    assert load("jumps.scl").call("Backwards", count=count) == total


@pytest.mark.parametrize(("selector", "trace"), [(1, 1378), (2, 2378), (3, 468), (4, 568), (5, 78)])
def test_a_jump_into_a_branch_does_not_ask_its_condition(
    load: Load, selector: int, trace: int
) -> None:
    block = load("jumps.scl").instance("IntoArms")
    block(selector=selector)
    assert block.trace == trace


def test_exit_and_continue_go_with_jumps_in_one_loop(load: Load) -> None:
    block = load("jumps.scl").instance("InLoops")
    block()
    assert block.trace == 135678_1245_13


def test_jumps_back_count_as_passes_for_the_watchdog(
    engine_name: str, request: pytest.FixtureRequest
) -> None:
    path = request.path.parent / "jumps.scl"
    limits = Limits(loop_passes=1000)
    block = load_program([path], engine=engine_name, limits=limits).instance("Endless")
    with pytest.raises(DiagnosticError) as stop:
        block()
    (found,) = stop.value.diagnostics
    assert (found.code, found.span and found.span.text) == ("FB6004", "GOTO top;")


def test_step7_declares_its_labels(engine_name: str, request: pytest.FixtureRequest) -> None:
    path = request.path.parent / "labels.scl"
    block = load_program([path], dialect="step7", engine=engine_name).instance("Labels")
    block(n=4)
    assert block.sum == 10
