"""`fbgen record` and `fbgen replay`: traffic kept with its times, shown in words, played again."""

import json
import sys
from pathlib import Path
from time import monotonic_ns

import pytest

from tests.unit.cli.running import Fbgen
from tests.unit.cli.served_drives import serving

linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")

READ, STOPPED = "2F 01 52 FD 01 80", "2F 01 52 FD 01 60 00 E0"
WRITE = "2F 01 50 FA 01 13 88 16"
RUN = "2F 01 50 FA 00 C4 00 3E"


class ScriptedPort:
    """Gives these bytes, then Ctrl-C; `sent` is what was written, with its time."""

    name = "COM3"

    def __init__(self, *script: str) -> None:
        self._script = [bytes.fromhex(text) for text in script]
        self.sent: list[tuple[int, bytes]] = []
        self.closed = False

    def read(self, wait_s: float = 0.01) -> bytes:
        if self._script:
            return self._script.pop(0)
        end_ns = monotonic_ns() + int(wait_s * 1e9)
        if wait_s == 0.01:
            raise KeyboardInterrupt
        while monotonic_ns() < end_ns:
            pass
        return b""

    def write(self, data: bytes) -> None:
        self.sent.append((monotonic_ns(), data))

    def close(self) -> None:
        self.closed = True


def traffic(path: Path, *frames: tuple[int, str, str], series: str = "vf-s11") -> Path:
    """A file with frames at these milliseconds, each 5 ms long."""
    head = {"format": "fbgen line traffic", "version": 1, "protocol": "toshiba"}
    rows = [head | {"baud": 19_200, "parity": "even", "series": series}]
    rows += [
        {"t_us": 1000 * at, "end_us": 1000 * at + 5000, "direction": way, "bytes": data}
        for at, way, data in frames
    ]
    path.write_text("".join(json.dumps(row) + "\n" for row in rows), "utf-8")
    return path


def test_frames_are_shown_and_kept(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    port = ScriptedPort(READ + STOPPED[:8], STOPPED[8:], "00 00", WRITE[:6])
    monkeypatch.setattr("harness.serial.serial_port", lambda name, characters: port)
    file = tmp_path / "line.jsonl"
    run = fbgen("record", "--port", "COM3", "--baud", "19200", "-o", str(file))
    assert run.status == 0
    assert [row.partition(" s ")[2] for row in run.out.splitlines()] == [
        f"> {READ}  inverter 1: read FD01 status",
        f"< {STOPPED}  inverter 1: FD01 status 6000 = standby, standby_st_on",
        "? 00 00 2F 01  no frame",
    ]
    assert run.err.endswith("1 requests, 1 replies, 1 unknown\n")
    head, *rows = [json.loads(line) for line in file.read_text("utf-8").splitlines()]
    assert (head["format"], head["version"], head["baud"]) == ("fbgen line traffic", 1, 19_200)
    assert [(row["direction"], row["bytes"]) for row in rows] == [
        *(("request", READ), ("reply", STOPPED), ("unknown", "00 00 2F 01"))
    ]
    assert all(0 <= row["t_us"] <= row["end_us"] for row in rows)
    assert port.closed
    shown = fbgen("replay", str(file))
    assert shown.out == run.out


def test_a_recording_ends_by_itself_and_overwrites_nothing(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ports = []

    def opened(name: str, characters: object) -> ScriptedPort:
        ports.append(ScriptedPort(*[READ] * 1000))
        return ports[-1]

    monkeypatch.setattr("harness.serial.serial_port", opened)
    file = tmp_path / "line.jsonl"
    assert fbgen("record", "--port", "COM3", "-o", str(file), "--for", "5ms").status == 0
    run = fbgen("record", "--port", "COM3", "-o", str(file), "--for", "5ms")
    assert (run.status, run.out) == (1, "")
    assert "FB9001" in run.err
    assert ports[-1].closed
    assert fbgen("record", "--port", "COM3", "-o", str(file), "--for", "5ms", "--force").status == 0
    assert "FB9050" in fbgen("record", "--port", "COM3", "--for", "5").err
    assert "FB9002" in fbgen("record", "--port", "COM3", "-o", str(tmp_path / "no" / "a")).err


def test_traffic_as_json(fbgen: Fbgen, tmp_path: Path) -> None:
    file = traffic(tmp_path / "a", (0, "request", READ), (20, "reply", STOPPED))
    first, second = json.loads(fbgen("replay", str(file), "--json").out)["frames"]
    assert (first["time_s"], first["direction"]) == (0.0, "request")
    assert second["meaning"] == "inverter 1: FD01 status 6000 = standby, standby_st_on"


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("", "no head"),
        ("{", "no JSON object"),
        ("[]", "no JSON object"),
        ('{"format": "other"}', "no head"),
        ('{"format": "fbgen line traffic", "version": 1}', "does not say"),
        (
            '{"format": "fbgen line traffic", "version": 1, "protocol": "x", "baud": 9600, '
            '"parity": "even"}',
            "that there is not",
        ),
    ],
)
def test_a_file_without_a_head_is_refused(
    fbgen: Fbgen, tmp_path: Path, line: str, says: str
) -> None:
    file = tmp_path / "line.jsonl"
    file.write_text(line, "utf-8")
    run = fbgen("replay", str(file))
    assert (run.status, run.out) == (1, "")
    assert "FB9054" in run.err
    assert says in run.err


@pytest.mark.parametrize(
    "row",
    [
        '{"t_us": 1, "end_us": 2, "direction": "request", "bytes": ""}',
        '{"t_us": 1, "end_us": 2, "direction": "sideways", "bytes": "2F"}',
        '{"t_us": 3, "end_us": 2, "direction": "request", "bytes": "2F"}',
        '{"t_us": 1, "end_us": 2, "direction": "request", "bytes": "2"}',
        '{"t_us": 1, "direction": "request", "bytes": "2F"}',
    ],
)
def test_a_line_that_says_no_frame_is_shown_with_its_place(
    fbgen: Fbgen, tmp_path: Path, row: str
) -> None:
    file = traffic(tmp_path / "a")
    file.write_text(file.read_text("utf-8") + row + "\n", "utf-8")
    run = fbgen("replay", str(file))
    assert "FB9054]: this line says no frame" in run.err
    assert f"--> {file.as_posix()}:2:1" in run.err


def test_what_is_no_text_or_not_there_cannot_be_replayed(fbgen: Fbgen, tmp_path: Path) -> None:
    file = tmp_path / "a"
    assert "FB9002" in fbgen("replay", str(file)).err
    file.write_bytes(b"\xff\xfe")
    assert "FB9002" in fbgen("replay", str(file)).err


@linux
def test_the_masters_side_is_played_with_its_times_and_compared(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    frames = [(0, "request", READ), (30, "reply", STOPPED), (500, "request", WRITE)]
    file = traffic(tmp_path / "a", *frames, (530, "reply", WRITE))
    with serving() as line:
        begin_ns = monotonic_ns()
        run = fbgen("replay", str(file), "--port", line.port, "--as", "master")
        assert monotonic_ns() - begin_ns > 500_000_000
        assert (run.status, run.err) == (0, "2 requests\n")
        assert line.drives["vf1"].read_parameter("frequency_setpoint") == 50.0
        assert "write FA01 frequency_setpoint 1388 = 50.00 Hz  ->  inverter 1: FA01" in run.out
        line.drives["vf1"].trip("OC1")
        run = fbgen("replay", str(file), "--port", line.port, "--as", "master", "--json")
        assert run.status == 1
        assert "FB9056]: 2 of 2 replies" in run.err
        first, second = json.loads(run.out)["exchanges"]
        assert first["came"].startswith("2F 01 72 FD 01")
        assert (first["recorded"], first["same"], second["same"]) == (STOPPED, False, False)
        line.drives["vf1"].power_off()
        run = fbgen("replay", str(file), "--port", line.port, "--as", "master")
        assert f"no reply  recorded: {STOPPED}" in run.out


@linux
def test_a_recording_that_starts_a_motor_is_played_only_with_yes(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    file = traffic(tmp_path / "a", (0, "request", RUN), (20, "reply", RUN))
    with serving() as line:
        run = fbgen("replay", str(file), "--port", line.port, "--as", "master")
        assert (run.status, run.out) == (1, "")
        assert "FB9053" in run.err
        assert not line.drives["vf1"].running
        run = fbgen("replay", str(file), "--port", line.port, "--as", "master", "--yes")
        assert run.status == 0
        assert line.drives["vf1"].running


def test_the_drives_side_answers_as_it_did_one_after_the_other(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = "2F 01 52 FD 01 64 00 E4"
    frames = [(0, "request", READ), (20, "reply", STOPPED), (50, "request", READ)]
    file = traffic(tmp_path / "a", *frames, (60, "reply", other), (100, "request", WRITE))
    port = ScriptedPort(READ, READ, READ, WRITE, "2F 02 52 FD 01 81")
    monkeypatch.setattr("harness.serial.serial_port", lambda name, characters: port)
    begin_ns = monotonic_ns()
    run = fbgen("replay", str(file), "--port", "COM3", "--as", "drives")
    assert run.status == 0
    assert [data.hex(" ").upper() for _, data in port.sent] == [STOPPED, other, other]
    assert port.sent[0][0] - begin_ns >= 20_000_000
    assert run.out.count("no reply") == 2
    assert run.err.endswith("5 requests\n")


def test_a_side_needs_a_port_and_a_port_a_side(fbgen: Fbgen, tmp_path: Path) -> None:
    file = traffic(tmp_path / "a")
    assert "FB9055" in fbgen("replay", str(file), "--port", "COM3").err
    assert "FB9055" in fbgen("replay", str(file), "--as", "master").err
