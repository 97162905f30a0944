"""Timers on the virtual clock (IEC 61131-3 table 46, figure 15; S7-1200 manual, timers).

Each row of a timing diagram: advance the clock by so many milliseconds, call with IN, expect Q, ET.
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]

Step = tuple[float, bool, bool, int]

BOTH = pytest.mark.parametrize("name", ["timers.scl", "timers.st"])


def run(load: Load, name: str, outputs: tuple[str, str], steps: list[Step]) -> None:
    program = load(name)
    block = program.instance("Delays")
    for number, (wait_ms, signal, is_on, elapsed_ms) in enumerate(steps):
        program.clock.advance(ms=wait_ms)
        block(signal=signal)
        assert (block[outputs[0]], block[outputs[1]]) == (is_on, elapsed_ms), f"step {number}"


ON = ("onDelay", "onElapsed")
OFF = ("offDelay", "offElapsed")
PULSE = ("pulse", "pulseElapsed")
COLLECTED = ("collected", "collectedElapsed")


@BOTH
def test_ton_waits_for_the_preset_time(load: Load, name: str) -> None:
    run(load, name, ON, [
        (0, False, False, 0),
        (10, True, False, 0),
        (99, True, False, 99),
        (1, True, True, 100),
        (500, True, True, 100),
        (1, False, False, 0),
        (1, True, False, 0),
        (50, False, False, 0),
        (50, True, False, 0),
        (100, True, True, 100),
    ])  # fmt: skip


@BOTH
def test_ton_counts_whole_milliseconds(load: Load, name: str) -> None:
    run(load, name, ON, [
        (0, True, False, 0),
        (99.999, True, False, 99),
        (0.001, True, True, 100),
    ])  # fmt: skip


@BOTH
def test_tof_holds_for_the_preset_time(load: Load, name: str) -> None:
    run(load, name, OFF, [
        (0, False, False, 0),
        (10, True, True, 0),
        (500, True, True, 0),
        (1, False, True, 0),
        (99, False, True, 99),
        (1, False, False, 100),
        (500, False, False, 100),
        (1, True, True, 0),
        (1, False, True, 0),
        (50, True, True, 0),
        (100, False, True, 0),
        (100, False, False, 100),
    ])  # fmt: skip


@BOTH
def test_tp_gives_a_pulse_of_the_preset_time(load: Load, name: str) -> None:
    run(load, name, PULSE, [
        (0, False, False, 0),
        (10, True, True, 0),
        (50, False, True, 50),
        (10, True, True, 60),
        (39, True, True, 99),
        (1, True, False, 100),
        (500, True, False, 100),
        (1, False, False, 0),
        (1, True, True, 0),
        (10, False, True, 10),
        (90, False, False, 0),
    ])  # fmt: skip


@BOTH
def test_tp_starts_again_at_an_edge_that_comes_with_the_end(load: Load, name: str) -> None:
    run(load, name, PULSE, [
        (0, True, True, 0),
        (50, False, True, 50),
        (60, True, True, 0),
        (100, True, False, 100),
    ])  # fmt: skip


@BOTH
@pytest.mark.parametrize("preset", [0, -1])
def test_a_preset_time_of_zero_does_not_wait(load: Load, name: str, preset: int) -> None:
    block = load(name).instance("Delays")
    block(signal=False, preset=preset)
    assert (block.onDelay, block.offDelay, block.pulse) == (False, False, False)
    block(signal=True)
    assert (block.onDelay, block.offDelay, block.pulse) == (True, True, False)
    block(signal=False)
    assert (block.onDelay, block.offDelay, block.pulse) == (False, False, False)


def test_tonr_collects_the_time_and_holds_until_reset(load: Load) -> None:
    run(load, "timers.scl", COLLECTED, [
        (0, True, False, 0),
        (60, False, False, 60),
        (500, False, False, 60),
        (1, True, False, 60),
        (40, True, True, 100),
        (1, False, True, 100),
        (1, True, True, 100),
    ])  # fmt: skip


def test_tonr_is_reset_by_r_while_the_signal_lasts(load: Load) -> None:
    program = load("timers.scl")
    block = program.instance("Delays")
    block(signal=True)
    program.clock.advance(ms=150)
    block(signal=True, reset=True)
    assert (block.collected, block.collectedElapsed) == (False, 0)
    block(signal=True, reset=False)
    program.clock.advance(ms=30)
    block(signal=True)
    assert (block.collected, block.collectedElapsed) == (False, 30)


def test_tia_keeps_the_preset_time_of_the_start(load: Load) -> None:
    program = load("timers.scl")
    block = program.instance("Delays")
    block(signal=True, preset=100)
    program.clock.advance(ms=50)
    block(signal=True, preset=20)
    assert (block.onDelay, block.onElapsed) == (False, 50)
    program.clock.advance(ms=50)
    block(signal=True, preset=500)
    assert (block.onDelay, block.onElapsed) == (True, 100)


def test_iec_looks_at_the_preset_time_in_each_call(load: Load) -> None:
    program = load("timers.st")
    block = program.instance("Delays")
    block(signal=True, preset=100)
    program.clock.advance(ms=50)
    block(signal=True, preset=20)
    assert (block.onDelay, block.onElapsed) == (True, 20)
    block(signal=True, preset=500)
    assert (block.onDelay, block.onElapsed) == (True, 20)


def test_outputs_change_with_a_call_only(load: Load) -> None:
    program = load("timers.scl")
    block = program.instance("Delays")
    block(signal=True)
    program.clock.advance(ms=200)
    assert (block.instOn.Q, block.instOn.ET) == (False, 0)
    block(signal=True)
    assert (block.instOn.Q, block.instOn.ET) == (True, 100)
