"""`fbgen sim gateway`: what it asks for, where it serves, how it ends."""

import signal
import subprocess
import sys
from pathlib import Path
from time import monotonic

import pytest

from tests.unit.cli.running import Fbgen
from tests.unit.serial.foreign_master import IDENT, PATIENCE_S, ForeignMaster

ROOT = Path(__file__).parents[3]
EXAMPLE = ROOT / "examples" / "manual_example" / "plant.yaml"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "it is not said where"),
        (["--pty", "--port", "COM3"], "at once"),
        (["--pty", "--type", "tospbdp001", "plant.yaml"], "for the example plant"),
    ],
)
def test_options_that_do_not_go_together(fbgen: Fbgen, arguments: list[str], message: str) -> None:
    run = fbgen("sim", "gateway", *arguments)
    assert run.status == 1
    assert "FB9030" in run.err
    assert message in run.err


def test_address_and_layout_are_for_one_gateway(fbgen: Fbgen, tmp_path: Path) -> None:
    head, gateway = EXAMPLE.read_text("utf-8").split("gateways:\n")
    other = gateway.replace("gw1", "gw2").replace("drive11", "drive12").replace("256", "512")
    other = other.replace("profibus_address: 2", "profibus_address: 3")
    plant = tmp_path / "plant.yaml"
    plant.write_text(f"{head}gateways:\n{gateway}{other}", "utf-8")
    run = fbgen("sim", "gateway", "--pty", plant.as_posix(), "--address", "7")
    assert (run.status, run.err.count("FB9030")) == (1, 1)


def test_a_type_that_is_not_there_names_the_nearest_one(fbgen: Fbgen) -> None:
    run = fbgen("sim", "gateway", "--pty", "--type", "tospbdp01")
    assert run.status == 1
    assert "FB9034" in run.err
    assert "tospbdp001" in run.err


def test_a_plant_without_gateways_has_none_to_serve(fbgen: Fbgen) -> None:
    plant = EXAMPLE.parents[1] / "serial" / "plant.yaml"
    run = fbgen("sim", "gateway", "--pty", plant.as_posix())
    assert (run.status, run.err.count("FB9034")) == (1, 1)


@pytest.mark.parametrize(("option", "value"), [("--address", "126"), ("--layout", "gsd11")])
def test_what_the_gateway_cannot_have_is_refused_as_in_a_plant_file(
    fbgen: Fbgen, option: str, value: str
) -> None:
    run = fbgen("sim", "gateway", "--pty", option, value)
    assert run.status == 1
    assert "error[FB2" in run.err
    assert f": {option}: " in run.err
    assert "plant.yaml" not in run.err


def test_a_port_that_is_not_there(fbgen: Fbgen) -> None:
    run = fbgen("sim", "gateway", "--port", "/dev/ttyNONE9")
    assert run.status == 1
    assert "FB9031" in run.err
    assert run.out == ""


def test_a_speed_that_profibus_does_not_have(fbgen: Fbgen) -> None:
    run = fbgen("sim", "gateway", "--port", "/dev/ttyNONE9", "--baud", "115200")
    assert run.status == 1
    assert "no speed of PROFIBUS" in run.err


class OneRequest:
    """A port at which one request comes, and then Ctrl-C."""

    name = "COM3"

    def __init__(self, request: str = "10 02 01 49 4C 16") -> None:
        self.sent = b""
        self.closed = False
        self._come = [bytes.fromhex(request), b"\x99"]

    def read(self) -> bytes:
        if not self._come:
            raise KeyboardInterrupt
        return self._come.pop(0)

    def write(self, data: bytes) -> None:
        self.sent += data

    def close(self) -> None:
        self.closed = True


def test_ctrl_c_ends_with_a_summary_and_gives_the_port_back(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    port = OneRequest()
    monkeypatch.setattr("fbgen.cli.sim._open", lambda name, baud: port)
    run = fbgen("sim", "gateway", "--port", "COM3")
    assert (run.status, run.out) == (0, "")
    assert run.err.splitlines() == [
        "COM3: gw1 at address 2, gsd10; Ctrl-C ends",
        "1 telegrams, 1 answers, 1 bytes skipped",
    ]
    assert port.sent == bytes.fromhex("10 01 02 00 03 16")
    assert port.closed


def test_a_pbdp110_is_served_with_its_drives(fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch) -> None:
    port = OneRequest("10 03 01 49 4D 16")
    monkeypatch.setattr("fbgen.cli.sim._open", lambda name, baud: port)
    monkeypatch.setattr("fbgen.cli.ports.state_line.on_error_terminal", lambda: True)
    run = fbgen("sim", "gateway", "--port", "COM3", "--type", "pbdp110", "--layout", "module4")
    assert port.sent == bytes.fromhex("10 01 03 00 04 16")
    assert "gw1 (address 3) waiting for parameters, no master; pump stopped; fan stopped" in run.err
    assert "gw1 at address 3, module4" in run.err


def test_a_terminal_shows_what_the_devices_do(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fbgen.cli.sim._open", lambda name, baud: OneRequest())
    monkeypatch.setattr("fbgen.cli.ports.state_line.on_error_terminal", lambda: True)
    run = fbgen("sim", "gateway", "--port", "COM3")
    assert "gw1 (address 2) waiting for parameters, no master; drive11 stopped" in run.err


@pytest.mark.usefixtures("usual_ctrl_c")
@pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")
def test_a_foreign_master_runs_the_gateway_of_a_process_that_ends_with_ctrl_c() -> None:
    options = ["--pty", "--layout", "whole10", "--address", "2"]
    process = subprocess.Popen(
        [sys.executable, "-m", "fbgen.cli", "sim", "gateway", *options],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=ROOT,
    )
    assert process.stdout is not None
    port = process.stdout.readline().strip()
    master = ForeignMaster(port, bytes.fromhex("C08987"), (10, 8), IDENT)
    forward = bytes.fromhex("E0 00 01 0B 50 FA 00 00 C4 00")
    inputs, end_s = b"", monotonic() + PATIENCE_S
    while inputs != bytes.fromhex("DF 00 0B 50 FA 00 C4 00") and monotonic() < end_s:
        inputs = master.run(forward) or inputs
    master.dpm.destroy()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    assert inputs.hex(" ") == "df 00 0b 50 fa 00 c4 00"
    assert (process.returncode, out) == (0, "")
    assert f"{port}: gw1 at address 2, whole10; Ctrl-C ends" in err
    assert "0 bytes skipped" in err


class QuietNetwork:
    """A CAN interface at which nothing comes, and then Ctrl-C."""

    name = "virtual:desk"

    def __init__(self) -> None:
        self.closed = False
        self.turns = 0

    def read(self, wait_s: float = 0.0) -> None:
        self.turns += 1
        if self.turns > 2:
            raise KeyboardInterrupt

    def write(self, frame: object) -> None:
        raise AssertionError("nothing is sent in the self test")

    def close(self) -> None:
        self.closed = True


@pytest.mark.parametrize("layout", ["toshiba_parameter", "101/151"])
def test_a_dev003z_is_served_at_a_can_interface(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, layout: str
) -> None:
    network = QuietNetwork()
    monkeypatch.setattr("fbgen.cli.ports.sim_can._open", lambda name, rate: network)
    monkeypatch.setattr("fbgen.cli.ports.state_line.on_error_terminal", lambda: True)
    options = ["--address", "5", "--layout", layout, "--series", "vf-mb1"]
    log = tmp_path / "desk.asc"
    run = fbgen("sim", "gateway", "--can", "virtual:desk", *options, "--log", str(log))
    assert (run.status, run.out) == (0, "")
    assert "virtual:desk: dev003z with MAC ID 5, 500000 bit/s; Ctrl-C ends" in run.err
    assert "MAC ID 5: MS self test, NS not online; startup; vf-mb1 stopped" in run.err
    assert run.err.endswith("0 frames heard, 0 sent\n")
    assert network.closed
    assert log.exists()


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--can", "virtual:desk", "--port", "COM3"], "FB9030"),
        (["--can", "virtual:desk", "--pty"], "FB9030"),
        (["--can", "virtual:desk", "plant.yaml"], "FB9030"),
        (["--can", "virtual:desk", "--type", "pbdp110"], "FB9034"),
        (["--can", "virtual:desk", "--layout", "gsd10"], "FB1105"),
        (["--can", "virtual:desk", "--address", "64"], "FB7106"),
        (["--can", "virtual:desk", "--series", "vf-s11"], "FB7106"),
        (["--can", "virtual:desk", "--series", "vf-s99"], "FB1205"),
        (["--can", "virtual:desk", "--baud", "19200"], "FB9030"),
        (["--can", "virtual:desk", "--layout", "100/151"], "known: 20/70, 21/71, 100/150"),
        (["--can", "udp_multicast:9.9.9.9"], "the channel is an address of a group"),
        (["--can", "serial:/dev/ttyNONE9"], "udp_multicast:239.74.163.2 needs none"),
        (["--pty", "--series", "vf-s15"], "FB9030"),
        (["--pty", "--log", "x.asc"], "FB9030"),
        (["--pty", "--type", "dev003z"], "FB9034"),
        (["--type", "dev003z"], "give --can INTERFACE:CHANNEL"),
    ],
)
def test_what_does_not_go_together_on_can(fbgen: Fbgen, options: list[str], told: str) -> None:
    run = fbgen("sim", "gateway", *options)
    assert run.status in (1, 2)
    assert told in run.err
    assert run.out == ""


def test_a_plant_with_devicenet_alone_is_told_how_it_is_served(fbgen: Fbgen) -> None:
    plant = Path(__file__).parents[3] / "examples" / "devicenet" / "plant.yaml"
    run = fbgen("sim", "gateway", str(plant), "--pty")
    assert run.status in (1, 2)
    assert "FB9034" in run.err
    assert "served by --can INTERFACE:CHANNEL" in run.err
