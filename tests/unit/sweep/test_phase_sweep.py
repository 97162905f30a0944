"""The phase sweep: the generated blocks keep its rules in every phase, spoilt ones do not.

The short form runs always; the long one (`make sweep`, everything by `make phases`) takes more of
the same combinations. Source of the times: TOSPBDP001 manual v1.1, 9.
"""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from fbgen.source import Source
from harness.kernel import NS_PER_MS
from harness.sweep import Axes, Conditions, Sweep, SweepResult, between_accesses, report
from harness.sweep.conditions import ACCESS_LAYOUTS

CATALOG = load_catalog()
LINE = load_plant(Path(__file__).parent / "line.yaml", CATALOG)
SLOW = Conditions(access="process_image", reply_ns=78 * NS_PER_MS, torn=1.0)
"""Drives that are slower than the catalogue says: late replies, and torn ones."""


LATE_MS = (5, 20, 31, 64, 78)
REPEATED = replace(SLOW, bus_period_ns=4 * NS_PER_MS, scan_offset_ns=6 * NS_PER_MS)
"""A phase in which a late reply comes just when the telegram has been repeated."""


def swept(conditions: Sequence[Conditions], cycle_ms: int = 10) -> SweepResult:
    plan = LINE.model_copy(update={"cycle_time_ms": cycle_ms})
    return Sweep(plan, CATALOG).through(conditions)


def test_the_blocks_keep_every_rule_in_a_sample_of_all_phases() -> None:
    result = swept(Axes().spread(42))
    assert result.passed, report(result)
    assert result.requests == 42 * 35


@pytest.mark.parametrize("access", ACCESS_LAYOUTS)
def test_the_bus_cycle_may_fall_between_any_two_accesses_of_a_scan(access: str) -> None:
    result = swept(list(between_accesses(access))[2::8])
    assert result.passed, report(result)


def test_a_late_reply_right_behind_a_repetition_mixes_nothing_up() -> None:
    without_zero = replace(REPEATED, drive_zero=False, bus_period_ns=5 * NS_PER_MS)
    result = swept([REPEATED, replace(without_zero, scan_offset_ns=5 * NS_PER_MS)])
    assert result.passed, report(result)


@pytest.mark.parametrize("cycle_ms", [2, 4])
def test_a_short_cycle_keeps_every_rule(cycle_ms: int) -> None:
    result = swept(Axes(drive_zero=(True,), replies_ms=LATE_MS).spread(8), cycle_ms)
    assert result.passed, report(result)


@pytest.mark.slow
@pytest.mark.parametrize("cycle_ms", [1, 2, 4, 20, 50])
def test_other_cycles_keep_every_rule(cycle_ms: int) -> None:
    result = swept(Axes().spread(240), cycle_ms)
    assert result.passed, report(result)


@pytest.mark.slow
def test_the_blocks_keep_every_rule_in_a_large_sample() -> None:
    result = swept(Axes().spread(3000))
    print(report(result))
    assert result.passed, report(result)


@pytest.mark.slow
@pytest.mark.parametrize("access", ACCESS_LAYOUTS)
def test_the_bus_cycle_may_fall_anywhere_in_a_scan(access: str) -> None:
    result = swept(list(between_accesses(access)))
    assert result.passed, report(result)


def test_the_sample_has_every_value_of_every_axis() -> None:
    axes, sample = Axes(), Axes().spread(400)
    assert {item.reply_ns // NS_PER_MS for item in sample} == set(axes.replies_ms)
    assert {item.scan_offset_ns // NS_PER_MS for item in sample} == set(axes.scan_offsets_ms)
    assert {item.bus_period_ns // NS_PER_MS for item in sample} == set(axes.bus_periods_ms)
    assert {(item.access, item.drive_zero, item.trigger_poll) for item in sample} == {
        (access, drive_zero, poll)
        for access in axes.access
        for drive_zero in axes.drive_zero
        for poll in axes.trigger_poll
    }


# --- the checker is checked -----------------------------------------------------------------------

TRIGGER = "      %QB258:P := #frameOut.trigger;\n"
FIRST_WRITE = "      %QW264:P := #frameOut.data;\n"
IN_TIME = [
    replace(Conditions(), reply_ns=ms * NS_PER_MS, scan_offset_ns=ms * NS_PER_MS // 2)
    for ms in (2, 9, 17)
]
LATE = [
    replace(SLOW, scan_offset_ns=ms * NS_PER_MS, reply_ns=(70 + ms) * NS_PER_MS) for ms in range(9)
]
SPOILT = {
    "the trigger first": (
        [(TRIGGER, ""), (FIRST_WRITE, TRIGGER + FIRST_WRITE)],
        list(between_accesses("per_identifier"))[::4],
        {"telegrams belong to requests", "an answer in time is heard"},
    ),
    "no spacer": (
        [("#statSpacers := 1;", "#statSpacers := 0;")],
        IN_TIME,
        {"the value belongs to the request"},
    ),
    "no spacers where a late reply may come": (
        [("#statSpacers := 2;", "#statSpacers := 0;")],
        LATE,
        {"the value belongs to the request"},
    ),
    "a reply is matched without its ComNo": (
        [("AND #frameIn.comNo = #tempWantedComNo", "")],
        IN_TIME,
        {"the value belongs to the request"},
    ),
    "a write to the EEPROM is repeated": (
        [("(#statState = 20 OR #statRepeats)", "TRUE")],
        IN_TIME,
        {"only what may be is repeated"},
    ),
    "no retries": (
        [("#statAttempt < #retries", "FALSE")],
        IN_TIME,
        {"an answer in time is heard"},
    ),
    "a new trigger does not wait until the gateway has seen the last one": (
        [("AND #statTaken AND", "AND NOT #sent AND")],
        [REPEATED],
        {"only what may be is repeated"},
    ),
    "time without limit": (
        [("#statExpired := #instTimer.Q;", "#statExpired := FALSE;")],
        IN_TIME[:1],
        {"every request ends"},
    ),
    "an emergency stop that waits its turn": (
        [("#tempAbort := TRUE;", "#tempAbort := FALSE;")],
        IN_TIME,
        {"the emergency stop in time"},
    ),
}
"""What is spoilt: the changes of the text, in which phases it shows, and the rules that find it."""


@pytest.mark.parametrize("spoilt", SPOILT)
def test_a_spoilt_block_is_found(spoilt: str) -> None:
    changes, conditions, rules = SPOILT[spoilt]
    changed = set()

    def alteration(sources: Sequence[Source]) -> list[Source]:
        texts = []
        for item in sources:
            text = item.text
            for old, new in changes:
                if old in text:
                    changed.add(old)
                text = text.replace(old, new)
            texts.append(Source(item.name, text))
        return texts

    result = Sweep(LINE, CATALOG, alteration).through(conditions)
    assert changed == {old for old, _ in changes}
    assert result.broken.keys() & rules, report(result)
