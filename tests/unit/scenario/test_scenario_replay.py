"""The same seed gives the same run, byte for byte; another seed gives other reply times."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from harness.scenario import prepare, scenario_cases
from harness.trace.telegrams import TelegramRecord
from tests.unit.scenario.scenario_files import ROOT, ran, steps

SCENARIOS = ROOT / "tests" / "scenarios"


def records(path: Path, seed: int) -> list[TelegramRecord]:
    """All telegrams of a run with their frames and times."""
    run = prepare(scenario_cases(path)[0], load_catalog(), seed)
    run.run()
    return [record for recorder in run.recorders.values() for record in recorder.records]


@pytest.mark.parametrize("name", ["start_and_stop", "line_broken"])
def test_the_same_seed_gives_the_same_telegrams_at_the_same_times(name: str) -> None:
    path = SCENARIOS / f"{name}.scenario.yaml"
    first = records(path, 5)
    assert first
    assert first == records(path, 5)


def test_another_seed_gives_the_same_bytes_at_other_reply_times() -> None:
    path = SCENARIOS / "start_and_stop.scenario.yaml"
    first, other = records(path, 5), records(path, 6)
    assert [item.output for item in first] == [item.output for item in other]
    assert [item.input for item in first] == [item.input for item in other]
    answers = [[item.frames[1].start_ns for item in run] for run in (first, other)]
    assert answers[0] != answers[1]


def test_noise_is_the_same_with_the_same_seed() -> None:
    path = SCENARIOS / "noise_on_the_line.scenario.yaml"
    assert records(path, 11) == records(path, 11)


def test_a_fixed_reply_time_does_not_depend_on_the_seed(tmp_path: Path) -> None:
    text = "drives: {pump: {reply_time: 15 ms}}\n" + steps(
        "- wait: 100 ms",
        "- set: {plc.TOS_Plant.gw1.pump.read_status.execute: true}",
        "- expect: {plc.TOS_Plant.gw1.pump.read_status.done: true}",
        "  within: 1 s",
    )
    first, other = ran(tmp_path, text, 1), ran(tmp_path, text, 2)
    assert first.passed
    assert first.virtual_ns == other.virtual_ns
    assert (first.seed, other.seed) == (1, 2)
