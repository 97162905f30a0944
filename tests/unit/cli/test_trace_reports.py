"""`fbgen test --trace` and `--vcd`: which files come of it."""

from pathlib import Path

import pytest
from vcdvcd import VCDVCD

from fbgen.cli.reports.trace_reports import file_names
from fbgen.source import Source
from harness.trace import read_traces
from tests.unit.cli.running import Fbgen
from tests.unit.scenario.scenario_files import written

STEPS = "steps:\n  - wait: 50 ms\n  - expect: {cpu.mode: RUN}\n"
TWICE = "variations: [{}, {layout: doc9}]\n"


@pytest.fixture
def once(tmp_path: Path) -> Path:
    """A scenario that runs once."""
    return written(tmp_path, STEPS)


@pytest.fixture
def twice(tmp_path: Path) -> Path:
    """A scenario with two variations."""
    return written(tmp_path, TWICE + STEPS)


def test_all_runs_go_into_one_trace_file(fbgen: Fbgen, twice: Path, tmp_path: Path) -> None:
    file = tmp_path / "new" / "runs.jsonl"
    run = fbgen("test", str(twice), "--trace", str(file), "-j", "2")
    assert run.status == 0
    traces = list(read_traces(Source("runs.jsonl", file.read_text(encoding="ascii"))))
    assert [trace.title for trace in traces] == ["Tried out", "Tried out [doc9]"]
    assert all(trace.end_ns == 50_000_000 for trace in traces)


def test_a_failing_scenario_leaves_its_trace_too(fbgen: Fbgen, tmp_path: Path) -> None:
    path = written(tmp_path, "steps: [{expect: {drive.pump.running: true}}]\n")
    file = tmp_path / "runs.jsonl"
    assert fbgen("test", str(path), "--trace", str(file)).status == 1
    [trace] = read_traces(Source("runs.jsonl", file.read_text(encoding="ascii")))
    assert [mark.verdict for mark in trace.marks] == ["failed", "failed"]


def test_a_folder_gets_a_vcd_file_for_each_run(fbgen: Fbgen, twice: Path, tmp_path: Path) -> None:
    folder = tmp_path / "waves"
    assert fbgen("test", str(twice), "--vcd", str(folder)).status == 0
    assert sorted(path.name for path in folder.iterdir()) == ["tried.vcd", "tried_doc9.vcd"]
    assert "drive.pump.running" in VCDVCD(str(folder / "tried_doc9.vcd")).signals


def test_one_run_goes_into_one_vcd_file(fbgen: Fbgen, once: Path, tmp_path: Path) -> None:
    file = tmp_path / "run.vcd"
    assert fbgen("test", str(once), "--vcd", str(file)).status == 0
    assert VCDVCD(str(file)).endtime == 50_000_000


def test_several_runs_do_not_go_into_one_vcd_file(
    fbgen: Fbgen, twice: Path, tmp_path: Path
) -> None:
    file = tmp_path / "run.vcd"
    run = fbgen("test", str(twice), "--vcd", str(file))
    assert run.status == 1
    assert "error[FB8042]: 2 scenarios ran" in run.err
    assert not file.exists()


def test_a_missing_package_is_told_before_anything_runs(
    fbgen: Fbgen, once: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("harness.trace.vcd.find_spec", lambda name: None)
    run = fbgen("test", str(once), "--vcd", "waves")
    assert run.status == 1
    assert "error[FB8041]" in run.err
    assert "passed" not in run.out


def test_file_names_are_plain_and_differ() -> None:
    titles = ["start ", "start [iec, a=b]", "Start", "a b", "a_b"]
    names = ["start.vcd", "start_iec_a=b.vcd", "Start-2.vcd", "a_b.vcd", "a_b-2.vcd"]
    assert file_names(titles) == names


def test_a_report_that_cannot_be_written_keeps_no_other_from_it(
    fbgen: Fbgen, twice: Path, tmp_path: Path
) -> None:
    (tmp_path / "taken").write_text("no folder", encoding="utf-8")
    lost, waves = str(tmp_path / "taken" / "runs.jsonl"), tmp_path / "waves"
    run = fbgen("test", str(twice), "--trace", lost, "--vcd", str(waves))
    assert run.status == 1
    assert "error[FB9002]" in run.err
    assert "2 passed" in run.err
    assert len(list(waves.iterdir())) == 2
