"""`fbgen sim gateway`: what it asks for, where it serves, how it ends."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from fbgen.wire.fdl import decode
from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
EXAMPLE = ROOT / "examples" / "manual_example" / "plant.yaml"
linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")


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


@pytest.mark.parametrize(("option", "value"), [("--address", "126"), ("--layout", "gsd11")])
def test_what_the_gateway_cannot_have_is_refused_as_in_a_plant_file(
    fbgen: Fbgen, option: str, value: str
) -> None:
    run = fbgen("sim", "gateway", "--pty", option, value)
    assert run.status == 1
    assert "error[FB2" in run.err


def test_a_port_that_is_not_there(fbgen: Fbgen) -> None:
    run = fbgen("sim", "gateway", "--port", "/dev/ttyNONE9")
    assert run.status == 1
    assert "FB9031" in run.err
    assert run.out == ""


def test_a_speed_that_profibus_does_not_have(fbgen: Fbgen) -> None:
    run = fbgen("sim", "gateway", "--port", "/dev/ttyNONE9", "--baud", "115200")
    assert run.status == 1
    assert "no speed of PROFIBUS" in run.err


@linux
def test_a_process_names_its_pseudo_terminal_answers_there_and_ends_with_ctrl_c() -> None:
    command = [sys.executable, "-m", "fbgen.cli", "sim", "gateway", "--pty", "--address", "9"]
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=ROOT
    )
    assert process.stdout is not None
    port = os.open(process.stdout.readline().strip(), os.O_RDWR | os.O_NOCTTY)
    os.write(port, bytes.fromhex("10 09 01 49 53 16"))
    assert decode(os.read(port, 100)) == decode(bytes.fromhex("10 01 09 00 0A 16"))
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=30)
    os.close(port)
    assert (process.returncode, out) == (0, "")
    assert "gw1 at address 9, gsd10" in err
    assert "1 telegrams, 1 answers, 0 bytes skipped" in err
