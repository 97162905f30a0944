"""A sweep that takes long: processes, the journal, and an end before the end."""

import io
import json
import os
import signal
from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import load_plant
from harness.sweep import Axes, Progressed, Sweep, SweepRun, report
from harness.sweep.__main__ import main
from harness.sweep.progress import Progress

LINE = Path(__file__).parent / "line.yaml"
BAD = Path(__file__).parents[1] / "bad"
POINTS = [
    item
    for item in Axes(access=("process_image",), drive_zero=(True,), replies_ms=(4, 9)).every()
    if item.torn and item.trigger_poll and item.bus_period_ns == 2_000_000
][::3]
"""Seven that share one program, where chance decides what a transfer tears."""


@pytest.fixture(scope="module")
def whole() -> str:
    """The table of all points, in one go and one process."""
    result, all_ran = SweepRun(LINE, POINTS).run()
    assert all_ran
    assert result.passed
    return report(result)


def interrupting(how: signal.Signals, points: int) -> Callable[[Progressed], None]:
    def interrupt(progressed: Progressed) -> None:
        if progressed.done == points:
            os.kill(os.getpid(), how)

    return interrupt


def test_what_a_point_gives_depends_on_nothing_that_ran_before() -> None:
    catalog = load_catalog()
    sweep = Sweep(load_plant(LINE, catalog), catalog)
    first = [sweep.point(item) for item in POINTS]
    again = [sweep.point(item) for item in reversed(POINTS)]
    assert first == again[::-1]


def test_the_table_is_the_same_with_several_processes(whole: str) -> None:
    result, _ = SweepRun(LINE, POINTS, processes=2, together=2).run()
    assert report(result) == whole


@pytest.mark.usefixtures("usual_ctrl_c")
def test_ctrl_c_leaves_what_ran_and_the_journal_goes_on(whole: str, tmp_path: Path) -> None:
    journal = tmp_path / "new" / "journal.jsonl"
    run = SweepRun(LINE, POINTS, journal=journal, together=2)
    result, all_ran = run.run(interrupting(signal.SIGINT, 4))
    assert not all_ran
    assert not result.passed
    assert report(result).startswith("4 of 7 combinations, ")
    assert "Every rule held up to there." in report(result)

    with journal.open("a", encoding="utf-8") as file:
        file.write('{"first": 4, "points": [{"requ')  # the power fails
    shown: list[int] = []
    result, all_ran = run.run(lambda how: shown.append(how.done))
    assert all_ran
    assert report(result) == whole
    assert shown == [4, 6, 7], "what the journal has does not run again"
    lines = [json.loads(line) for line in journal.read_text("utf-8").splitlines()]
    assert [line.get("first") for line in lines] == [None, 0, 2, 4, 6]


def test_a_journal_without_its_end_is_enough_for_the_table(whole: str, tmp_path: Path) -> None:
    run = SweepRun(LINE, POINTS, journal=tmp_path / "journal.jsonl")
    assert [report(run.run()[0]) for _ in range(2)] == [whole] * 2


@pytest.mark.parametrize("other", ["points", "text", "bytes"])
def test_the_journal_of_another_sweep_is_fb8074(other: str, tmp_path: Path) -> None:
    journal = tmp_path / "journal.jsonl"
    plant = tmp_path / "line.yaml"
    plant.write_text(LINE.read_text("utf-8"), "utf-8")
    SweepRun(plant, POINTS[:1], journal=journal).run()
    before = journal.read_bytes()
    if other == "text":
        plant = tmp_path / "other.yaml"
        plant.write_text(LINE.read_text("utf-8").replace("drives:", "drives:\n"), "utf-8")
    if other == "bytes":
        journal.write_bytes(before := b"\xff\xfe\n")
    with pytest.raises(DiagnosticError) as refused:
        SweepRun(plant, POINTS[: 2 if other == "points" else 1], journal=journal).run()
    assert [item.code for item in refused.value.diagnostics] == ["FB8074"]
    assert journal.read_bytes() == before


def test_the_journal_of_another_sweep_is_shown_at_its_first_line() -> None:
    path = BAD / "FB8074_other_sweep.jsonl"
    with pytest.raises(DiagnosticError) as refused:
        SweepRun(LINE, POINTS[:1], journal=path).run()
    (found,) = refused.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == ("FB8074", 1, 1)


# --- the command ----------------------------------------------------------------------------------


def test_sigterm_prints_the_table_and_how_to_go_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(Progress, "show", lambda self, how: interrupting(signal.SIGTERM, 0)(how))
    before = signal.getsignal(signal.SIGTERM)
    journal = tmp_path / "the journal"
    assert main([str(LINE), "--points", "3", "--journal", str(journal)]) == 130
    shown = capsys.readouterr()
    assert shown.out.startswith("0 of 3 combinations, 0 requests")
    assert "The sweep was ended early." in shown.out
    go_on = f"python -m harness.sweep {LINE} --points 3 --journal '{journal}'"
    assert shown.err == f"ended early; go on with: {go_on}\n"
    assert signal.getsignal(signal.SIGTERM) is before


def test_the_command_prints_its_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(LINE), "--points", "1"]) == 0
    shown = capsys.readouterr()
    assert shown.out.startswith("1 combinations, 35 requests, ")
    assert shown.out.endswith("\nEvery rule held.\n")


def test_a_plant_with_too_few_drives_is_fb8075(capsys: pytest.CaptureFixture[str]) -> None:
    assert main([str(BAD / "FB8075_too_few_drives.yaml"), "--points", "1"]) == 1
    shown = capsys.readouterr()
    assert shown.out == ""
    assert "error[FB8075]: the plant 'line' cannot be swept" in shown.err
    assert "FB8075_too_few_drives.yaml:9:11" in shown.err


@pytest.mark.parametrize("wrong", [("-j", "0"), ("-j", "two"), ("--points", "-1")])
def test_what_is_no_count_is_wrong_usage(
    wrong: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as end:
        main([str(LINE), *wrong])
    assert end.value.code == 2
    assert "is no number from 1 on" in capsys.readouterr().err


def test_progress_tells_the_rate_and_the_time_that_is_left() -> None:
    now = 100.0
    stream = io.StringIO()
    progress = Progress(stream, lambda: now)
    progress.show(Progressed(1000, 9000))
    for seconds, done in ((10, 1100), (80, 3000), (90, 3200), (400, 9000)):
        now = 100.0 + seconds
        progress.show(Progressed(done, 9000))
    progress.end()
    assert stream.getvalue().splitlines() == [
        "1000 of 9000 are in the journal",
        "1000 of 9000",
        "3000 of 9000, 25.0 a second, 4 min left",
        "9000 of 9000, 20.0 a second, 0 s left",
    ]
