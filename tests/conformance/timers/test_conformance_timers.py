"""Timers on the virtual clock (IEC 61131-3 table 46, figure 15; S7-1200 manual, timers).

Each row of a timing diagram: advance the clock by so many milliseconds, call with IN, expect Q, ET.
"""

from collections.abc import Callable, Sequence

import pytest

from fbgen.source import Source
from harness import LoadedProgram, load_program
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.loading import engine_named, read_program
from harness.engine.variables import BlockInstance
from harness.kernel import NS_PER_MS

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


READING = """
FUNCTION_BLOCK Reading
VAR_INPUT
  signal : BOOL;
  calls : BOOL;
END_VAR
VAR_OUTPUT
  isOn : BOOL;
  elapsed : TIME;
  seen : INT;
END_VAR
VAR
  t : {kind};
  self : TON;
END_VAR
{begin}
  IF calls THEN
    t(IN := signal, PT := T#100ms);
  END_IF;
  isOn := t.Q;
  elapsed := t.ET;
  self(IN := NOT self.Q, PT := T#30ms);
  IF self.Q THEN
    seen := seen + 1;
  END_IF;
END_FUNCTION_BLOCK
"""
DIALECTS = pytest.mark.parametrize("dialect", ["tia", "step7", "iec", "twincat"])


def reading(engine_name: str, dialect: str, kind: str) -> tuple[LoadedProgram, BlockInstance]:
    begin = "BEGIN" if dialect in ("tia", "step7") else ""
    source = Source("reading.scl", READING.format(kind=kind, begin=begin))
    program = load_program([source], dialect, engine_name)
    return program, program.instance("Reading")


@DIALECTS
@pytest.mark.parametrize(
    ("kind", "signals", "before", "behind"),
    [
        ("TON", (True,), False, True),
        ("TOF", (True, False), True, False),
        ("TP", (True,), True, False),
    ],
)
def test_tia_brings_a_timer_up_to_date_when_it_is_read(
    engine_name: str,
    dialect: str,
    kind: str,
    signals: Sequence[bool],
    *,
    before: bool,
    behind: bool,
) -> None:
    program, block = reading(engine_name, dialect, kind)
    for signal in signals:
        block(signal=signal, calls=True)
    program.clock.advance(ms=60)
    block(calls=False)
    today = dialect == "tia"
    assert (block.isOn, block.elapsed) == (before, 60 if today else 0)
    program.clock.advance(ms=60)
    block(calls=False)
    assert (block.isOn, block.elapsed) == ((behind, 100) if today else (before, 0))
    block(calls=True)
    assert block.isOn is behind


@DIALECTS
def test_a_timer_that_resets_itself_is_never_seen_on_in_tia(engine_name: str, dialect: str) -> None:
    program, block = reading(engine_name, dialect, "TON")
    for _ in range(20):
        block()
        program.clock.advance(ms=10)
    assert block.seen == (0 if dialect == "tia" else 4)


def test_a_timer_that_nobody_has_started_shows_nothing(engine_name: str) -> None:
    for kind in ("TON", "TOF", "TP"):
        program, block = reading(engine_name, "tia", kind)
        block(signal=True)
        program.clock.advance(ms=200)
        block(signal=True)
        assert (block.isOn, block.elapsed) == (False, 0)


@pytest.mark.parametrize(("called_as", "behind"), [("TON", True), ("TOF", False), ("TP", False)])
def test_an_iec_timer_is_read_as_what_it_was_called(
    engine_name: str, called_as: str, *, behind: bool
) -> None:
    text = READING.format(kind="IEC_TIMER", begin="BEGIN").replace("t(IN", f"t.{called_as}(IN")
    program = load_program([Source("reading.scl", text)], "tia", engine_name)
    block = program.instance("Reading")
    block(signal=True, calls=True)
    block(signal=called_as != "TOF", calls=True)
    program.clock.advance(ms=150)
    block(calls=False)
    assert (block.isOn, block.elapsed) == (behind, 100)


def test_the_state_of_a_timer_is_brought_back_whole(engine_name: str) -> None:
    program, _ = reading(engine_name, "tia", "TON")
    block = program.engine.instance("Reading")
    block.call({"signal": True, "calls": True})
    state = block.snapshot()
    program.clock.advance(ms=150)
    block.call({"calls": False})
    assert block.get("isOn") is True
    block.restore(state)
    assert block.get("isOn") is False
    block.call({"calls": False})
    assert block.get("isOn") is True


class Classic(StandaloneEnvironment):
    """An S7-300 without hardware."""

    @property
    def classic(self) -> bool:
        return True


def test_on_an_s7_300_a_timer_goes_on_in_its_calls_only(engine_name: str) -> None:
    text = READING.format(kind="TON", begin="BEGIN").replace("T#100ms", "preset")
    text = text.replace("calls : BOOL;", "calls : BOOL; preset : TIME := T#100ms;")
    environment = Classic()
    program = read_program([Source("reading.scl", text)])
    block = engine_named(engine_name)(program, environment, Limits()).instance("Reading")
    block.call({"signal": True, "calls": True})
    environment.kernel.run_for(150 * NS_PER_MS)
    block.call({"calls": False})
    assert block.get("isOn") is False
    block.call({"calls": True, "preset": 200})
    assert block.get("isOn") is False  # the preset time of each call counts


def test_from_outside_a_timer_shows_what_the_program_saw_last(load: Load) -> None:
    program = load("timers.scl")
    block = program.instance("Delays")
    block(signal=True)
    program.clock.advance(ms=200)
    assert (block.instOn.Q, block.instOn.ET) == (False, 0)
    block(signal=True)
    assert (block.instOn.Q, block.instOn.ET) == (True, 100)


KINDS = """FUNCTION_BLOCK "Kinds"
VAR_INPUT a, as_tof, as_tp : BOOL; END_VAR
VAR_OUTPUT q : BOOL; et : {time}; END_VAR
VAR t : {kind}; END_VAR
BEGIN
  IF #as_tof THEN
    #t.TOF(IN := #a, PT := {pt}, Q => #q, ET => #et);
  ELSIF #as_tp THEN
    #t.TP(IN := #a, PT := {pt}, Q => #q, ET => #et);
  ELSE
    {own}(IN := #a, PT := {pt}, Q => #q, ET => #et);
  END_IF;
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize(
    ("kind", "own"), [("IEC_TIMER", "#t.TON"), ("TON_TIME", "#t"), ("IEC_LTIMER", "#t.TON")]
)
def test_a_timer_that_is_called_as_another_kind_starts_anew(
    engine_name: str, kind: str, own: str
) -> None:
    is_long = kind == "IEC_LTIMER"
    time, pt = ("LTIME", "LT#1s") if is_long else ("TIME", "T#1s")
    text = KINDS.format(kind=kind, own=own, time=time, pt=pt)
    program = load_program([Source("kinds.scl", text)], engine=engine_name)
    block = program.instance("Kinds")
    unit = 1_000_000 if is_long else 1
    seen = []
    for wait_ms, inputs in (
        (0, {"a": True}),
        (600, {}),
        (0, {"as_tof": True}),
        (0, {"a": False}),
        (300, {}),
        (0, {"as_tof": False, "as_tp": True, "a": True}),
        (200, {}),
        (0, {"as_tp": False}),
        (999, {}),
        (1, {}),
    ):
        program.clock.advance(ms=wait_ms)
        block(**inputs)
        seen.append((block.q, block.et // unit))
    assert seen == [
        (False, 0),
        (False, 600),
        (True, 0),
        (True, 0),
        (True, 300),
        (True, 0),
        (True, 200),
        (False, 0),
        (False, 999),
        (True, 1000),
    ]
