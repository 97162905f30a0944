"""The demo against bytes copied by hand from the manual, which the catalogue knows nothing of."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from time import process_time

import pytest

import harness.demo
from fbgen.catalog import load_catalog
from fbgen.cli import main
from fbgen.resources import shipped
from harness.demo import DemoReport, run_demo
from harness.scenario.telegram_patterns import bytes_match
from tests.unit.scenario.scenario_files import ROOT
from tests.vectors.reading import entries

ROWS = ("row1", "row2", "row3", "row4")


@pytest.fixture(scope="module")
def report() -> DemoReport:
    return run_demo()


@pytest.fixture
def example(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the example that the demo takes instead of the shipped one."""
    shutil.copytree(shipped("examples") / "manual_example", tmp_path / "manual_example")
    monkeypatch.setattr(harness.demo, "shipped", lambda name: tmp_path)
    return tmp_path / "manual_example" / "manual_example.scenario.yaml"


@pytest.mark.fact("tos.com")
@pytest.mark.fact("tos.sw.ok")
def test_the_plc_sends_and_receives_what_the_manual_prints(report: DemoReport) -> None:
    printed = entries("tospbdp001_telegrams")
    assert len(report.telegrams) == report.sent_count == len(ROWS)
    for row, telegram in zip(ROWS, report.telegrams, strict=True):
        wanted = printed[f"tos.g.{row}"]
        assert bytes_match(wanted["send"], telegram.seen.record.output), row
        assert bytes_match(wanted["receive"], telegram.seen.record.input), row


@pytest.mark.fact("tos.what")
def test_the_frames_on_the_line_are_those_of_the_manuals_with_their_checksums(
    report: DemoReport,
) -> None:
    frames = entries("toshiba_frames")
    for row, telegram in zip(ROWS, report.telegrams, strict=True):
        request = "row3.request_zero" if row == "row3" else f"{row}.request"
        wanted = [frames[f"rs485.g.{request}"], frames[f"rs485.g.{row}.reply"]]
        assert [frame.data.hex(" ").upper() for frame in telegram.seen.record.frames] == [
            item["bytes"] for item in wanted
        ]
        assert [frame.to_drives for frame in telegram.seen.record.frames] == [True, False]


@pytest.mark.fact("tos.t.total")
def test_each_telegram_takes_30_to_40_ms_from_profibus_to_profibus(report: DemoReport) -> None:
    for telegram in report.telegrams:
        assert telegram.seen.record.received_ns is not None
        assert 30e6 <= telegram.seen.record.received_ns - telegram.seen.record.sent_ns <= 42e6


def test_the_report_says_that_every_byte_is_right(report: DemoReport) -> None:
    assert report.matches
    text = report.render()
    assert text.count(" equal\n") == 2 * len(ROWS)
    assert "DIFFERENT" not in text
    assert text.splitlines()[-1].startswith("Every byte is as the manual prints it. ")
    assert "FE03 Output current" in text
    assert "10E8 (43.28 %)" in text


def test_the_report_as_data_has_bytes_frames_and_times(report: DemoReport) -> None:
    data = json.loads(json.dumps(report.as_json()))
    assert data["matches"] is True
    third = data["telegrams"][2]
    assert third["output"] == "E0 00 03 0B 47 FE 03 00 00"
    assert third["input"] == "DF 00 0B 47 FE 03 10 E8"
    assert third["manual"] == {
        "output": "E0 00 03 0B 47 FE 03 xx xx",
        "input": "DF 00 0B 47 FE 03 10 E8",
    }
    assert [frame["bytes"] for frame in third["line"]] == [
        "2F 0B 47 FE 03 00 00 82",
        "2F 0B 47 FE 03 10 E8 7A",
    ]
    times = [third["sent_ns"], *(frame["start_ns"] for frame in third["line"])]
    assert times == sorted(times) < [third["received_ns"]] * 3
    assert third["equal"] is True


def test_a_second_run_is_the_same_byte_for_byte_and_quick(report: DemoReport) -> None:
    begin_s = process_time()
    again = run_demo()
    assert process_time() - begin_s < 2.0
    assert again.render() == report.render()
    assert again.as_json() == report.as_json()


def test_with_another_load_another_current_comes_back_and_is_different(example: Path) -> None:
    text = example.read_text("utf-8")
    example.write_text(text.replace("torque: 32.7", "torque: 80.0"), "utf-8")
    report = run_demo()
    assert not report.matches
    assert [item.input_equal for item in report.telegrams][:3] == [True, True, False]
    lines = report.render().splitlines()
    assert [line for line in lines if "DIFFERENT" in line] == [
        f"{'':16}manual, received      DF 00 0B 47 FE 03 10 E8     DIFFERENT"
    ]
    assert any(line.startswith("error[FB8001]: plc.TOS_Plant") for line in lines)
    assert lines[-1].startswith("NOT as in the manual. ")
    assert [item["equal"] for item in json.loads(json.dumps(report.as_json()))["telegrams"]][
        :3
    ] == [True, True, False]


def test_one_byte_that_is_printed_otherwise_is_different(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "sequences"
    folder.mkdir()
    text = (shipped("catalog") / "sequences" / "manual_example.yaml").read_text("utf-8")
    other = text.replace("A0 00 04 0B 50 FA 00 C2 00", "A0 00 04 0B 50 FA 00 C0 00")
    assert other != text
    (folder / "manual_example.yaml").write_text(other, "utf-8")
    monkeypatch.setattr(harness.demo, "load_catalog", lambda: load_catalog([tmp_path]))
    report = run_demo()
    assert not report.matches
    assert [item.output_equal for item in report.telegrams] == [True, True, True, False]
    assert [found.code for found in report.findings] == ["FB8006"]


def test_telegrams_that_are_missing_make_the_demo_fail(example: Path) -> None:
    text = example.read_text("utf-8")
    example.write_text(
        text.replace("- wait: 200 ms\n", "- wait: 200 ms\n  - inject: line_broken\n    on: gw1\n"),
        "utf-8",
    )
    report = run_demo()
    assert not report.matches
    assert report.sent_count < report.expected_count == len(ROWS)
    text = report.render()
    assert f"{report.sent_count} telegrams went out, the manual has 4" in text
    assert "PLC receives          nothing" in text
    assert not report.telegrams[0].input_equal


def test_it_runs_from_any_working_directory(tmp_path: Path, report: DemoReport) -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "NO_COLOR": "1"}
    done = subprocess.run(
        [sys.executable, "-m", "fbgen.cli", "demo"],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == report.render() + "\n"


def test_the_command_ends_with_status_1_when_a_byte_differs(
    example: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = example.read_text("utf-8")
    example.write_text(text.replace("torque: 32.7", "torque: 80.0"), "utf-8")
    for arguments in (["demo"], ["demo", "--json"]):
        assert main(arguments) == 1
    out = capsys.readouterr().out
    assert "DIFFERENT" in out
    assert '"matches": false' in out
