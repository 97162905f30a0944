"""RESET_TIMER and PRESET_TIMER.

Expected values: TIA Portal help, "RESET_TIMER" (all components of the timer become 0) and
"PRESET_TIMER" (the time counts for what is being timed, too).
"""

from pathlib import Path

from harness import LoadedProgram, load_program

_PROGRAM = Path(__file__).with_name("timers.scl")


def _program(engine_name: str) -> LoadedProgram:
    return load_program([_PROGRAM], engine=engine_name)


def test_a_timer_that_is_reset_begins_anew(engine_name: str) -> None:
    program = _program(engine_name)
    block = program.instance("Timers")
    block(run=True, mode=0)
    program.clock.advance(s=2)
    block(mode=0)
    assert block["et"] == 2_000
    block(mode=1)
    assert block["et"] == 0
    program.clock.advance(s=2)
    block(mode=0)
    assert (block["q"], block["et"]) == (False, 2_000)
    program.clock.advance(s=1)
    block(mode=0)
    assert block["q"]


def test_a_preset_counts_for_what_is_being_timed(engine_name: str) -> None:
    program = _program(engine_name)
    block = program.instance("Timers")
    block(run=True, mode=2)
    program.clock.advance(s=1)
    block(mode=2)
    program.clock.advance(s=3)
    block(mode=0)
    assert (block["q"], block["et"]) == (False, 4_000)
    program.clock.advance(s=5)
    block(mode=0)
    assert block["q"]
    block(run=False)
    block(run=True)
    program.clock.advance(s=3)
    block()
    assert block["q"], "the next start takes the PT of the call"


def test_an_off_delay_that_is_reset_is_off(engine_name: str) -> None:
    program = _program(engine_name)
    block = program.instance("Timers")
    block(run=True)
    block(run=False)
    assert block["off.Q"]
    block(run=False, mode=3)
    assert not block["off.Q"]
    assert block["off.ET"] == 0


def test_what_a_timer_has_collected_is_reset(engine_name: str) -> None:
    program = _program(engine_name)
    block = program.instance("Timers")
    block(run=True)
    program.clock.advance(s=2)
    block(run=False)
    assert block["sum.ET"] == 2_000
    block(run=False, mode=4)
    assert block["sum.ET"] == 0


def test_a_shorter_preset_ends_the_timing(engine_name: str) -> None:
    program = _program(engine_name)
    block = program.instance("Timers")
    block(run=True)
    program.clock.advance(s=2)
    block(mode=5)
    assert block["any.Q"]
    assert block["any.ET"] == 1_000
