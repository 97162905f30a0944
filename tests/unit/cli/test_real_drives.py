"""`fbgen test --port`: simulated PLC and gateway, and inverters at a port in their own time.

The inverters behind the port are simulated, too, on a clock of their own, which is the wall clock
of the plant here: nothing waits. Against another process the marked test runs in real time.
"""

import signal
import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

from harness.scenario import real_drives
from tests.unit.cli.running import Fbgen, Run
from tests.unit.serial.master_port import MasterPort
from tests.unit.serial.virtual_port import ServedLine

ROOT = Path(__file__).parents[3]
PLANT = (ROOT / "examples" / "manual_example" / "plant.yaml").as_posix()
FIVE = (ROOT / "examples" / "five_drives" / "plant.yaml").as_posix()
HEAD = f"version: 1\ntitle: With a real inverter\nplant: {PLANT}\n"
RUN = """\
steps:
  - wait: 200 ms
  - set:
      plc.TOS_Plant.gw1.drive11.manual_example.pause: T#500ms
      plc.TOS_Plant.gw1.drive11.manual_example.execute: true
  - expect: {plc.TOS_Plant.gw1.drive11.manual_example.done: true}
    within: 60 s
  - expect: {plc.TOS_Plant.gw1.drive11.manual_example.error: false}
"""


class Bench:
    """Inverter 11 behind the port COM3."""

    def __init__(self, fbgen: Fbgen, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self._fbgen = fbgen
        self._file = folder / "a.scenario.yaml"
        self.line = ServedLine(11)
        self.port = MasterPort(self.line)
        self.said: list[bytes] = []
        clock = self.port.clock
        for name in ("RealDrives", "stop_drives"):
            patched = partial(getattr(real_drives, name), clock_ns=clock)
            monkeypatch.setattr(real_drives, name, patched)
        monkeypatch.setattr("harness.serial.serial_port", lambda name, characters: self.port)

    def test(self, text: str, *options: str, head: str = HEAD) -> Run:
        self._file.write_text(head + text, "utf-8")
        port = ("--port", "COM3", "--real", "drive11", "--yes")
        return self._fbgen("test", str(self._file), *(options or port))


@pytest.fixture
def bench(fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Bench:
    return Bench(fbgen, tmp_path, monkeypatch)


def test_the_generated_blocks_run_an_inverter_at_a_port(bench: Bench) -> None:
    run = bench.test(RUN)
    assert run.status == 0, run.err
    assert "With a real inverter: at most" in run.err
    drive = bench.line.served.drives["vf11"]
    assert drive.set_point_hz == 50.0 or drive.read_parameter("frequency_setpoint") == 50.0
    sent = [data for data in bench.port.sent if data != b"\x00"]
    assert bytes.fromhex("2F 0B 50 FA 00 C4 00 48") in sent
    assert bytes.fromhex("2F 0B 50 FA 01 13 88 20") in sent


def test_behind_a_run_the_inverter_is_told_to_stop(bench: Bench) -> None:
    start = "steps:\n  - set: {plc.TOS_Plant.gw1.drive11.manual_example.execute: true}\n"
    run = bench.test(start + "  - wait: 1 s\n  - expect: {cpu.mode: RUN}\n")
    assert run.status == 0, run.err
    assert bench.port.sent[-1] == bytes.fromhex("2F 0B 50 FA 00 80 00 04")
    bench.line.run_ms(100)
    drive = bench.line.served.drives["vf11"]
    assert drive.operation.mode.name != "RUN"


def test_an_inverter_that_does_not_answer_when_told_to_stop_is_fb8082(bench: Bench) -> None:
    bench.line.served.drives["vf11"].power_off()
    run = bench.test("steps:\n  - wait: 10 ms\n  - expect: {cpu.mode: RUN}\n")
    assert run.status == 1
    assert "FB8082]: drive11 did not answer when told to stop" in run.err


def test_a_plant_that_falls_behind_is_fb8081(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    slow = bench.port.read

    def read(wait_s: float = 0.01) -> bytes:
        if wait_s:
            bench.line.port.now_ns += 40_000_000
        return slow(wait_s)

    monkeypatch.setattr(bench.port, "read", read)
    run = bench.test("steps:\n  - wait: 100 ms\n  - expect: {cpu.mode: RUN}\n")
    assert run.status == 1
    assert "FB8081]: 'With a real inverter' was up to" in run.err


def test_an_adapter_that_echoes_does_no_harm(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench.port, "_echo", True)
    run = bench.test(RUN)
    assert run.status == 0, run.err


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("steps:\n  - expect: {drive.drive11.frequency: 0}\n", "look into it"),
        (
            "steps:\n  - wait_until: {drive.drive11.running: true}\n    within: 1 s\n"
            "  - expect: {cpu.mode: RUN}\n",
            "look into it",
        ),
        (
            "steps:\n  - set: {drive.drive11.comno.communication_timeout: 1}\n"
            "  - expect: {cpu.mode: RUN}\n",
            "'drive.drive11.comno.communication_timeout'",
        ),
        (
            "steps:\n  - {inject: drive_tripped, on: drive11}\n  - expect: {cpu.mode: RUN}\n",
            "the fault 'drive_tripped' cannot be injected",
        ),
        (
            "drives: {drive11: {load: {torque: 5}}}\nsteps:\n  - expect: {cpu.mode: RUN}\n",
            "cannot be set before the start",
        ),
        ("rules: [all]\nsteps:\n  - wait: 1 s\n", "rules look into every drive"),
        (
            "properties:\n  - never: {drive.drive11.tripped: true}\nsteps:\n  - wait: 1 s\n",
            "look into it",
        ),
        (
            "faults:\n  - {random: 3, before: 5 s, lasts: 1 s}\nsteps:\n"
            "  - expect: {cpu.mode: RUN}\n",
            "faults by chance",
        ),
        (
            "faults:\n  - {at: 1 s, inject: drive_local, on: drive11}\nsteps:\n"
            "  - expect: {cpu.mode: RUN}\n",
            "the fault 'drive_local' cannot be injected",
        ),
    ],
)
def test_what_cannot_be_done_with_a_real_inverter_is_refused_before_it_hears_anything(
    bench: Bench, text: str, says: str
) -> None:
    run = bench.test(text)
    assert run.status == 1
    assert "error[FB8080]" in run.err
    assert says in run.err
    assert bench.port.sent == []


def test_drives_that_are_not_on_one_line_are_refused(bench: Bench) -> None:
    options = ("--port", "COM3", "--yes", "--real")
    steps = "steps:\n  - expect: {cpu.mode: RUN}\n"
    assert "there is no drive 'drive12'" in bench.test(steps, *options, "drive12").err
    pbdp = (ROOT / "examples" / "pbdp110" / "plant.yaml").as_posix()
    head = f"version: 1\ntitle: T\nplant: {pbdp}\n"
    assert "have a cable of their own" in bench.test(steps, *options, "pump", head=head).err
    head = f"version: 1\ntitle: T\nplant: {PLANT}\nblock: TOS_HzToWord\n"
    steps = "steps:\n  - set: {hz: 50.0}\n  - call: 1\n  - expect: {word: 5000}\n"
    run = bench.test(steps, *options, "drive11", head=head)
    assert run.status == 1
    assert bench.port.sent == []


@pytest.mark.parametrize(
    ("options", "code", "says"),
    [
        (("--port", "COM3", "--yes"), "FB8080", "which drives are real"),
        (("--real", "drive11"), "FB8080", "at no port"),
        (("--port", "COM3", "--real", "drive11", "-j", "2"), "FB8080", "one scenario at a time"),
        (("--port", "COM3", "--real", "drive11"), "FB9053", "the motors of drive11"),
    ],
)
def test_options_that_are_missing(
    bench: Bench, options: tuple[str, ...], code: str, says: str
) -> None:
    run = bench.test(RUN, *options)
    assert (run.status, run.out) == (1, "")
    assert f"error[{code}]" in run.err
    assert says in run.err
    assert bench.port.sent == []


def test_ctrl_c_stops_the_inverter(bench: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    slow = bench.port.read
    reads = [0]

    def read(wait_s: float = 0.01) -> bytes:
        reads[0] += 1
        if reads[0] == 500:
            raise KeyboardInterrupt
        return slow(wait_s)

    monkeypatch.setattr(bench.port, "read", read)
    run = bench.test(RUN)
    assert run.status == 130
    assert bench.port.sent[-1] == bytes.fromhex("2F 0B 50 FA 00 80 00 04")


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")
def test_in_real_time_against_inverters_of_another_process(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(real_drives, "LATE_NS", 10**12)
    serve = [sys.executable, "-m", "fbgen.cli", "sim", "drive", "--pty", "--inv-no", "11"]
    process = subprocess.Popen(
        [*serve, "--baud", "19200"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=ROOT,
    )
    assert process.stdout is not None
    name = process.stdout.readline().strip()
    file = tmp_path / "a.scenario.yaml"
    file.write_text(HEAD + RUN, "utf-8")
    run = fbgen("test", str(file), "--port", name, "--real", "drive11", "--yes")
    process.send_signal(signal.SIGINT)
    _, err = process.communicate(timeout=30)
    assert run.status == 0, run.err
    assert "vf11 (INV-NO 11) running forward, set-point 50.00 Hz" in err
