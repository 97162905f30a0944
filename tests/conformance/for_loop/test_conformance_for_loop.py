"""Loops (IEC 61131-3, 7.3.3.4.2 and following).

The end is tested before each pass, end and step are worked out once, and after the last pass the
variable is one step further.
"""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]


@pytest.mark.parametrize(
    ("first", "last", "step", "passes", "after"),
    [
        (0, 7, 1, 8, 8),
        (5, 5, 1, 1, 6),
        (5, 4, 1, 0, 5),
        (1, 10, 3, 4, 13),
        (3, 1, -1, 3, 0),
        (1, 3, -1, 0, 1),
        (32766, 32767, 1, 2, -32768),
        (-32767, -32768, -1, 2, 32767),
        (0, 32767, 20000, 2, -25536),
    ],
)
def test_passes_and_the_variable_behind_the_loop(
    load: Load, *, first: int, last: int, step: int, passes: int, after: int
) -> None:
    block = load("for_loop.scl").instance("Counting")
    block(first=first, last=last, step=step)
    assert (block.passes, block.after) == (passes, after)


def test_a_step_of_zero_is_reported(load: Load) -> None:
    block = load("for_loop.scl").instance("Counting")
    with pytest.raises(DiagnosticError, match="FB6008"):
        block(first=1, last=2, step=0)


def test_a_loop_to_the_end_of_the_type_ends(load: Load) -> None:
    block = load("for_loop.scl").instance("Narrow")
    block()
    assert (block.passes, block.after) == (6, 0)
    assert (block.downPasses, block.downAfter) == (3, 127)


def test_exit_and_continue_mean_the_innermost_loop_and_return_the_block(load: Load) -> None:
    block = load("for_loop.scl").instance("Leaving")
    block()
    # i = 1: j = 1; 2: 1, 2; 3: 1, 2; 4: 1, 2, 4
    assert block.counted == 8
    # j behind the inner loop: 2, 4 (3 is passed over), 4
    assert block.skipped == 10
    assert block.afterExit == 4
    assert block.afterReturn == 2


def test_the_end_is_worked_out_once_and_the_body_may_move_the_variable(load: Load) -> None:
    block = load("for_loop.scl").instance("Once")
    block()
    assert (block.passes, block.jumped) == (3, 5)


def test_while_may_not_run_and_repeat_runs_once_and_continue_goes_to_until(load: Load) -> None:
    block = load("for_loop.scl").instance("Others")
    block()
    assert (block.whilePasses, block.repeatPasses, block.untilSeen) == (0, 1, 2)


def test_a_loop_between_constants_that_is_not_entered_sets_its_variable(load: Load) -> None:
    block = load("for_loop.scl").instance("NeverEntered")
    block()
    assert (block.up, block.down, block.leftEarly) == (5, -3, 1)


@pytest.mark.parametrize(("again", "passes"), [(False, 54), (True, 3)])
def test_a_loop_inside_may_count_in_the_same_variable(load: Load, again: bool, passes: int) -> None:
    block = load("for_loop.scl").instance("SameVariable")
    block(again=again)
    assert (block.passes, block.after) == (passes, 255)
