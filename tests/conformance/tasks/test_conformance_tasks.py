"""When organization blocks and tasks run.

Expected: STEP 7 System Software reference (OB100 before OB1; OB30 to OB38 with periods of 5 s down
to 10 ms, the first run one period after the start; the higher class first) and IEC 61131-3 table
63 (INTERVAL, SINGLE at the rising edge, PRIORITY with 0 the most urgent).
"""

from collections.abc import Callable
from pathlib import Path

import pytest

from harness import LoadedProgram, ObSettings, Period, load_program

Load = Callable[[str], LoadedProgram]
HERE = Path(__file__).parent


def test_the_start_up_block_runs_once_before_the_program_cycle(load: Load) -> None:
    program = load("organization_blocks.scl")
    program.scan(3)
    seen = program.globals.Seen
    assert (seen.starts, seen.cycles, seen.further) == (1, 3, 3)
    assert list(seen.order)[:5] == [100, 1, 123, 1, 123]


def test_cyclic_interrupts_have_their_periods_from_the_start_on(load: Load) -> None:
    program = load("organization_blocks.scl")
    program.run_for(s=1, ms=1)
    seen = program.globals.Seen
    assert (seen.cycles, seen.fast, seen.slow) == (101, 10, 2)


def test_at_one_instant_the_higher_class_goes_first(load: Load) -> None:
    program = load("organization_blocks.scl")
    program.run_for(ms=500)
    program.globals.Seen.count = 0
    program.run_for(ms=1)
    assert list(program.globals.Seen.order)[:4] == [35, 33, 1, 123]


def test_periods_and_phases_can_be_set(engine_name: str) -> None:
    obs = ObSettings(
        numbers={"OB33": 38}, periods={"ob35": Period(7_000_000, 2_000_000), "OB33": Period(10**9)}
    )
    program = load_program(
        [HERE / "organization_blocks.scl"], engine=engine_name, cycle_ms=50, obs=obs
    )
    program.run_for(ms=9)
    assert program.globals.Seen.fast == 0
    program.run_for(ms=91.5)
    seen = program.globals.Seen
    assert (seen.fast, seen.cycles, seen.slow) == (14, 3, 0)


def test_time_passes_while_the_program_runs_by_itself(load: Load) -> None:
    program = load("organization_blocks.scl")
    program.scan(4)
    assert program.clock.now_ns == 30_000_000
    program.run_for(ms=12.5)
    assert program.clock.now_ns == 42_500_000


def test_tasks_run_at_their_intervals_and_at_edges(load: Load) -> None:
    program = load("tasks.st")
    program.run_for(ms=100)
    values = program.engine.global_value
    assert values("Fast.n") == 20
    assert [values("S1.n"), values("S2.n")] == [5, 5]
    assert values("OnEdge.n") == 1


@pytest.mark.parametrize("warm", [True, False])
def test_a_start_begins_anew(load: Load, warm: bool) -> None:
    program = load("organization_blocks.scl")
    program.scan(5)
    program.start(warm=warm)
    program.scan(2)
    seen = program.globals.Seen
    assert (seen.starts, seen.cycles, seen.fast) == (1, 2, 0)
