"""__TRY, __CATCH, __FINALLY.

TwinCAT 3 help, "__TRY, __CATCH, __FINALLY, __ENDTRY": what stands in __TRY behind the fault is not
done, __CATCH is, __FINALLY in any case; the variable of __CATCH gets the number of the exception.
"""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram, load_program
from harness.engine.interface import Limits

_TIGHT = Limits(loop_passes=1000)


@pytest.fixture(params=["iec", "twincat"])
def program(request: pytest.FixtureRequest, engine_name: str) -> LoadedProgram:
    path = Path(__file__).parent / "caught.st"
    return load_program([path], dialect=request.param, engine=engine_name, limits=_TIGHT)


def test_without_a_fault_catch_is_left_out(program: LoadedProgram) -> None:
    block = program.instance("Caught")
    block(divisor=4, index=1)
    assert (block.result, block.steps, block.caught, block.done) == (25, 13, False, 1)


def test_a_division_by_zero_in_a_called_block_goes_on_behind_catch(program: LoadedProgram) -> None:
    block = program.instance("Caught")
    block(divisor=0, index=1)
    assert (block.result, block.steps, block.caught, block.done) == (-1, 11, True, 1)
    assert block.code == 0x102


def test_what_was_done_before_the_fault_stays(program: LoadedProgram) -> None:
    block = program.instance("Caught")
    block(divisor=5, index=9)
    assert (block.result, block.steps, block.caught, block.passes) == (20, 12, True, 0)
    assert block.code == 0x101


def test_finally_is_done_on_the_way_of_return(program: LoadedProgram) -> None:
    block = program.instance("Caught")
    block(divisor=5, index=0, leaves=True)
    assert (block.steps, block.done) == (2, 1)


def test_faults_go_out_to_the_next_catch_and_leave_no_nesting_behind(
    program: LoadedProgram,
) -> None:
    block = program.instance("Nested")
    block()
    assert (block.inner, block.outer, block.counter, block.depth) == (4, 4, 4, 61)


def test_the_watchdog_is_not_caught(program: LoadedProgram) -> None:
    block = program.instance("Endless")
    with pytest.raises(DiagnosticError) as stopped:
        block()
    assert stopped.value.diagnostics[0].code == "FB6004"
    assert (block.caught, block.left) == (False, True)


def test_without_catch_the_fault_stops_the_program_behind_finally(program: LoadedProgram) -> None:
    block = program.instance("NotCaught")
    block(divisor=2)
    with pytest.raises(DiagnosticError) as stopped:
        block(divisor=0)
    assert stopped.value.diagnostics[0].code == "FB6003"
    assert (block.n, block.m) == (5, 2)
