"""Inverters at a port: the manuals' own frames, several on a line, and what a series has not."""

import sys
from contextlib import closing
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from harness.faults import FIELD_FAULTS, Target
from harness.line import Parity, Topology
from harness.serial import (
    DriveServer,
    DriveToServe,
    FaultSwitches,
    PseudoTerminal,
    line_setting,
    serial_port,
    serve_drives,
)
from tests.unit.serial.virtual_port import SETTING, ServedLine, VirtualPort, drives
from tests.vectors.reading import entries

FRAMES = entries("toshiba_frames")
PRINTED = [
    (FRAMES[entry["reply_to"]]["bytes"], entry["bytes"])
    for entry in FRAMES.values()
    if entry["id"].startswith("rs485.g.row") and "reply_to" in entry
]
"""Requests of the gateway's manual and what they are answered with."""
linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")


def test_each_drive_answers_to_its_number_alone() -> None:
    line = ServedLine(1, 2)
    assert line.ask("2F 01 52 FD 01 80", "2F 02 52 FD 01 81", "2F 03 52 FD 01 82") == [
        "2F 01 52 FD 01 60 00 E0",
        "2F 02 52 FD 01 60 00 E1",
        "",
    ]
    assert (line.served.log.requests, line.served.log.replies) == (3, 2)
    assert line.served.log.answered == {"vf1": 1, "vf2": 1}


@linux
def test_the_manuals_own_frames_byte_by_byte_over_a_pseudo_terminal() -> None:
    assert len(PRINTED) == 4
    with closing(PseudoTerminal()) as port:
        served = serve_drives(drives(11), SETTING, port, byte_times=True)
        server = DriveServer(served, port)
        with closing(serial_port(port.name, SETTING.from_master)) as master:
            for request, reply in PRINTED:
                data = FRAMES["rs485.g.row3.request_zero"]["bytes"] if "xx" in request else request
                wanted, heard = bytes.fromhex(reply), b""
                for byte in bytes.fromhex(data):
                    master.write(bytes((byte,)))
                    server.step()
                for _ in range(1000):
                    server.step()
                    heard += master.read(0)
                    if len(heard) >= len(wanted):
                        break
                told = 5 if "FE 03" in reply else len(wanted)
                assert heard[:told] == wanted[:told]
                assert len(heard) == len(wanted)
        assert served.drives["vf11"].set_point_hz == 50.0


def test_a_reset_is_not_answered_and_a_trip_shows_in_the_case_of_the_command() -> None:
    line = ServedLine()
    line.served.drives["vf11"].trip("OC1")
    (answer,) = line.ask("2F 0B 52 FC 90 18")
    assert answer.startswith("2F 0B 72 FC 90 00 01")
    assert line.ask("2F 0B 50 FA 00 20 00 A4") == [""]
    assert not line.served.drives["vf11"].tripped


def test_ascii_frames_are_answered_in_ascii() -> None:
    line = ServedLine()
    (answer,) = line.ask(b"(11RFD01)\r".hex())
    assert bytes.fromhex(answer) == b"(11RFD016000)\r"


def test_a_line_is_set_as_a_new_inverter_unless_something_else_is_said() -> None:
    known = line_setting([load_catalog().drive("vf-s11")], None, None, None)
    assert (known.protocol, known.baud, known.parity) == ("toshiba", 9_600, Parity.EVEN)
    asked = line_setting([load_catalog().drive("vf-s11")], "toshiba", 19_200, Parity.NONE)
    assert str(asked.from_drives) == "19200 8N2"


def test_a_setting_that_a_series_does_not_have_is_refused_with_those_that_it_has() -> None:
    with pytest.raises(DiagnosticError) as caught:
        line_setting([load_catalog().drive("vf-s11")], "profinet", 57_600, Parity.EVEN)
    assert [item.code for item in caught.value.diagnostics] == ["FB9035", "FB9035"]
    assert "toshiba, modbus" in caught.value.diagnostics[0].help
    assert "9600, 19200" in caught.value.diagnostics[1].help


def test_a_series_of_which_no_port_is_known_is_refused() -> None:
    known = load_catalog().drive("vf-s11").model_copy(update={"communication": None})
    with pytest.raises(DiagnosticError, match="FB9035"):
        line_setting([known], None, None, None)


def test_two_wires_are_one_pair_if_the_port_of_a_series_has_two() -> None:
    assert ServedLine(1).served.line.topology is Topology.FOUR_WIRE
    series = load_catalog().drive("vf-s11")
    assert series.communication is not None
    ports = [item.model_copy(update={"wires": 2}) for item in series.communication.ports]
    two = series.communication.model_copy(update={"ports": tuple(ports)})
    known = series.model_copy(update={"communication": two})
    served = serve_drives([DriveToServe("a", known, 1)], SETTING, VirtualPort(), byte_times=True)
    assert served.line.topology is Topology.TWO_WIRE


@pytest.mark.parametrize("name", FIELD_FAULTS)
def test_every_fault_of_drives_and_lines_comes_and_goes_while_they_are_served(name: str) -> None:
    line = ServedLine(1, 2)
    read = "2F 01 52 FD 01 80"
    healthy = line.ask(read)
    faults = FaultSwitches(line.served)
    place = "1" if FIELD_FAULTS[name].target is Target.DRIVE else ""
    assert faults.toggle(name, place)
    assert len(faults.on) == 1
    line.ask(read)
    assert not faults.toggle(name, place)
    assert faults.on == ()
    line.served.drives["vf1"].reset()
    line.run_ms(2500)
    assert line.ask(read) == healthy


def test_a_fault_that_is_switched_on_twice_with_other_settings_is_another() -> None:
    line = ServedLine()
    faults = FaultSwitches(line.served)
    communication = line.served.drives["vf11"].communication
    for delay in ("30 ms", "50 ms"):
        faults.switch("drive_slow", "", True, {"reply_time": delay})
        assert communication.reply_time.maximum_ns == int(delay[:2]) * 1_000_000
    faults.switch("drive_slow", "vf11", True, {})
    assert communication.reply_time.maximum_ns == 50_000_000
    faults.switch("drive_slow", "11", False, {})
    faults.switch("drive_slow", "11", False, {})
    assert communication.reply_time.maximum_ns == 12_000_000


@pytest.mark.parametrize(
    ("name", "place", "says"),
    [
        ("drive_slwo", "vf11", "there is no fault 'drive_slwo'"),
        ("drive_slow", "vf12", "there is no drive 'vf12'"),
        ("line_noise", "vf11", "happens to the line"),
    ],
)
def test_faults_and_places_that_are_not_there(name: str, place: str, says: str) -> None:
    with pytest.raises(DiagnosticError, match=f"FB9037.*{says}"):
        FaultSwitches(ServedLine().served).switch(name, place, True, {})


def test_with_several_drives_a_fault_needs_to_say_which() -> None:
    with pytest.raises(DiagnosticError, match="it is not said which drive"):
        FaultSwitches(ServedLine(1, 2).served).switch("drive_slow", "", True, {})


def test_a_port_that_goes_ends_the_server() -> None:
    line = ServedLine()
    line.port.gone = DiagnosticError([])
    with pytest.raises(DiagnosticError):
        line.server.serve(lambda idle_s: True)


def test_folders_of_terminals_are_known(tmp_path: Path) -> None:
    """A link to a pseudo terminal is one, too: no parity is asked of it."""
    if sys.platform != "linux":
        pytest.skip("only Linux makes pseudo terminals")
    with closing(PseudoTerminal()) as port:
        link = tmp_path / "line"
        link.symlink_to(port.name)
        with closing(serial_port(str(link), SETTING.from_master)) as opened:
            opened.write(b"\x2f")
            assert port.read(1.0) == b"\x2f"


@pytest.mark.parametrize(
    ("wired", "topology"),
    [(None, Topology.TWO_WIRE), ("two_wire", Topology.TWO_WIRE), ("four_wire", Topology.FOUR_WIRE)],
)
def test_of_a_series_with_two_ports_one_is_wired(wired: str | None, topology: Topology) -> None:
    series = load_catalog().drive("vf-as1")
    port = VirtualPort()
    setting = line_setting([series], None, 9_600, Parity.EVEN, wired)
    drive = DriveToServe("a", series, 3, port=wired)
    served = serve_drives([drive], setting, port, byte_times=True)
    assert served.line.topology is topology
    server = DriveServer(served, port, port.clock)
    port.script.append((port.now_ns + 50_000_000, bytes.fromhex("2F 03 52 FD 01 82")))
    for _ in range(40):
        server.step()
    assert [data.hex(" ").upper() for _, data in port.written] == ["2F 03 52 FD 01 60 00 E2"]
    assert served.log.answered == {"a": 1}
