"""`fbgen sim drive`: what it asks for, where it serves, what it shows, how it ends."""

import json
import signal
import socket
import subprocess
import sys
from pathlib import Path
from time import perf_counter

import pytest
import serial

from fbgen.catalog import load_catalog
from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_lines import FrameLines
from fbgen.cli.ports.drive_display import LineDisplay, TableDisplay
from fbgen.cli.ports.drive_keys import DRIVE_FAULTS, KEYS, LINE_FAULTS, DriveKeys
from harness.faults import FIELD_FAULTS
from harness.serial import FaultSwitches, drive_states
from tests.unit.cli.running import Fbgen
from tests.unit.serial.virtual_port import ServedLine

ROOT = Path(__file__).parents[3]
COMMAND = [sys.executable, "-m", "fbgen.cli", "sim", "drive", "--pty"]
PATIENCE_S = 20.0
SPECIFIED_S = 0.012 + (8 * 11 + 8 * 12) / 9_600
"""Eight bytes there, the reply time, eight bytes back."""
linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")


@pytest.mark.parametrize(
    ("arguments", "code", "says"),
    [
        ("", "FB9030", "it is not said where the drives shall be"),
        ("--pty --port COM3", "FB9030", "at once"),
        ("--port /dev/ttyNONE9", "FB9031", "there is no such port"),
        ("--pty --series vf-s12", "FB1205", "vf-s12"),
        ("--pty --drive vf-s11", "FB9035", "says no drive"),
        ("--pty --drive vf-s11:1-3=pump", "FB9035", "one name to several"),
        ("--pty --drive vf-s11:1 --drive vf-s11:1", "FB9035", "INV-NO 1 is given twice"),
        ("--pty --drive vf-s11:1=a --drive vf-s11:2=a", "FB9035", "the name 'a' is given twice"),
        ("--pty --inv-no 5-1", "FB9035", "is no INV-NO"),
        ("--pty --inv-no 1-999", "FB9035", "is no INV-NO"),
        ("--pty --set frequency", "FB9035", "gives no ComNo a value"),
        ("--pty --set vf2.frequency=5", "FB9035", "there is no drive 'vf2'"),
        ("--pty --set max_frequenc=60", "FB1105", "max_frequenc"),
        ("--pty --set max_frequency=6000", "FB7101", "does not take 6000"),
        ("--pty --baud 1234", "FB9035", "does not have the speed 1234"),
        ("--pty --wired rs232", "FB9035", "'vf-s11' has no port 'rs232'"),
        ("--pty --reply-time 12", "FB9035", "--reply-time"),
        ("--pty --control /nowhere/control", "FB9036", "/nowhere/control"),
    ],
)
def test_what_cannot_be_served_is_a_diagnostic(
    fbgen: Fbgen, arguments: str, code: str, says: str
) -> None:
    run = fbgen("sim", "drive", *arguments.split())
    assert (run.status, run.out) == (1, "")
    assert f"error[{code}]" in run.err
    assert says in run.err


@linux
@pytest.mark.usefixtures("usual_ctrl_c")
def test_a_process_serves_drives_tells_what_they_do_and_ends_with_ctrl_c(tmp_path: Path) -> None:
    control = tmp_path / "control"
    process = subprocess.Popen(
        [
            *(*COMMAND, "--inv-no", "11,12", "--reply-time", "12 ms"),
            *("--set", "vf12.FH=60", "--control", str(control), "-v"),
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=ROOT,
    )
    assert process.stdout is not None
    name = process.stdout.readline().strip()
    forward = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")
    with serial.Serial(name, timeout=PATIENCE_S) as master:
        took_s = []
        for _ in range(10):
            begin_s = perf_counter()
            master.write(forward)
            assert master.read(8) == forward
            took_s.append(perf_counter() - begin_s)
    assert SPECIFIED_S <= min(took_s) < SPECIFIED_S + 0.1
    with socket.socket(socket.AF_UNIX) as client:
        client.settimeout(PATIENCE_S)
        client.connect(str(control))
        client.sendall(b"get 12 max_frequency\ntrip 11 OC1\nquit\n")
        answers = [json.loads(line) for line in client.makefile()]
    out, err = process.communicate(timeout=30)
    assert [item["ok"] for item in answers] == [True] * len(answers)
    assert answers[0]["value"] == 60.0
    assert (process.returncode, out) == (0, "")
    assert "vf11 (vf-s11, INV-NO 11), vf12 (vf-s11, INV-NO 12); toshiba, 9600 8E2" in err
    assert "2F 0B 50 FA 00 C4 00 48  inverter 11: write FA00 command_word C400" in err
    assert "vf11 (INV-NO 11) running forward, set-point 0.00 Hz, commanded by network" in err
    assert "vf11 (INV-NO 11) tripped OC1" in err
    assert "10 requests, 10 replies, 0 unknown frames" in err
    assert not control.exists()


@linux
@pytest.mark.usefixtures("usual_ctrl_c")
def test_ctrl_c_is_a_good_end() -> None:
    process = subprocess.Popen(
        COMMAND, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT
    )
    assert process.stdout is not None
    process.stdout.readline()
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=30)
    assert process.returncode == 0
    assert err.endswith("late\n")


def frame_lines() -> FrameLines:
    series = load_catalog().drive("vf-s11")
    return FrameLines("toshiba", lambda address: CellTexts(series))


def test_without_a_terminal_each_change_is_a_line(capsys: pytest.CaptureFixture[str]) -> None:
    line = ServedLine()
    display = LineDisplay(
        line.served, lambda: drive_states(line.served), frame_lines(), frames=True
    )
    display.look(1.0)
    line.ask("2F 0B 52 FD 01 8A")
    display.look(1.0)
    line.served.drives["vf11"].power_off()
    display.look(1.0)
    display.end()
    said = [line.partition(" s  ")[2] for line in capsys.readouterr().err.splitlines()]
    assert said == [
        "vf11 (INV-NO 11) stopped, set-point 0.00 Hz, commanded by panel or terminals",
        "2F 0B 52 FD 01 8A  inverter 11: read FD01 status",
        "2F 0B 52 FD 01 60 00 EA  inverter 11: FD01 status 6000 = standby, standby_st_on",
        "vf11 (INV-NO 11) off",
    ]


def test_the_table_shows_drives_frames_faults_and_keys(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "120")
    monkeypatch.setenv("FORCE_COLOR", "1")
    line = ServedLine(1, 2)
    faults = FaultSwitches(line.served)
    keys = DriveKeys(line.served, faults)
    states = lambda: drive_states(line.served)  # noqa: E731
    table = TableDisplay(line.served, states, frame_lines(), faults, keys)
    line.ask("2F 01 52 FD 01 80")
    keys.press("2dn")
    table.look(1.0)
    table.end()
    shown = capsys.readouterr().err
    assert "vf-s11" in shown
    assert "inverter 1: read FD01 status" in shown
    assert "1 requests, 1 replies, 0 unknown frames" in shown
    assert "faults: drive_disconnected on vf2, line_noise on line" in shown
    assert "q end" in shown


def test_drawing_waits_while_something_is_about_to_happen(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    line = ServedLine()
    faults = FaultSwitches(line.served)
    keys = DriveKeys(line.served, faults)
    states = lambda: drive_states(line.served)  # noqa: E731
    table = TableDisplay(line.served, states, frame_lines(), faults, keys)
    drawn: list[float] = []
    now = [100.0]
    monkeypatch.setattr("fbgen.cli.ports.drive_display.monotonic", lambda: now[0])
    monkeypatch.setattr(table, "_content", lambda: drawn.append(now[0]) or "")
    for at_s, idle_s in ((100, 0), (100.3, 0), (100.4, 1), (100.5, 1), (100.7, 1), (101.8, 0)):
        now[0] = at_s
        table.look(idle_s)
    table.end()
    assert drawn == [100, 100.4, 100.7, 101.8]


def test_every_key_of_a_fault_is_shown_and_switches_it() -> None:
    line = ServedLine(1, 2)
    faults = FaultSwitches(line.served)
    keys = DriveKeys(line.served, faults)
    for key, name in (DRIVE_FAULTS | LINE_FAULTS).items():
        assert name in FIELD_FAULTS
        assert f"{key} " in KEYS
        keys.press(key)
        assert name in {kind for kind, _ in faults.on}
        keys.press(key)
        assert faults.on == ()
    assert "off" in keys.told


def test_keys_choose_a_drive_trip_it_reset_it_and_end() -> None:
    line = ServedLine(1, 2, 3)
    keys = DriveKeys(line.served, FaultSwitches(line.served))
    keys.press("3")
    assert keys.chosen == "vf3"
    keys.press("+-+t9?")
    assert keys.chosen == "vf1"
    assert line.served.drives["vf1"].trip_display == "OC1"
    keys.press("r")
    assert not line.served.drives["vf1"].tripped
    keys.press("q")
    assert keys.wants_end


def test_what_a_key_cannot_do_is_told() -> None:
    line = ServedLine(1)
    keys = DriveKeys(line.served, FaultSwitches(line.served))
    keys.press("w")
    assert keys.told == "there is no other drive on the line of 'vf1'"
