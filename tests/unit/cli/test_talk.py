"""`fbgen talk`: questions in words, answers with names and units, errors that say what to do."""

import io
import json
import sys
from collections.abc import Iterator
from time import sleep

import pytest

from fbgen.catalog import load_catalog
from fbgen.cli.ports.talk_requests import Form, Talking, questions
from fbgen.diagnostics import DiagnosticError
from fbgen.wire.toshiba import checksum
from tests.unit.cli.running import Fbgen, Run
from tests.unit.cli.served_drives import Serving, serving

linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")


@pytest.fixture
def line() -> Iterator[Serving]:
    with serving() as served:
        yield served


def talk(fbgen: Fbgen, line: Serving, text: str) -> Run:
    return fbgen("talk", "--port", line.port, *text.split())


def frames(text: str, talking: Talking | None = None) -> list[str]:
    known = talking or Talking(load_catalog().drive("vf-s11"), "toshiba")
    return [item.frame.hex(" ").upper() for item in questions(text.split(), known)]


@pytest.mark.parametrize(
    ("text", "frame"),
    [
        ("read 11 output_current_held", "2F 0B 52 FE 03"),
        ("read 11 FE03", "2F 0B 52 FE 03"),
        ("read 11 fc90", "2F 0B 52 FC 90"),
        ("read 11 trip", "2F 0B 52 FC 90"),
        ("read 11 F803", "2F 0B 52 08 03"),
        ("read 11 ACC", "2F 0B 52 00 09"),
        ("read 11 1234", "2F 0B 52 12 34"),
        ("write 11 frequency 50", "2F 0B 50 FA 01 13 88"),
        ("write 11 FA01 1388h", "2F 0B 50 FA 01 13 88"),
        ("write 11 FA01 16#1388", "2F 0B 50 FA 01 13 88"),
        ("write 11 frequency 50 --eeprom", "2F 0B 57 FA 01 13 88"),
        ("write 11 command run network_command network_frequency", "2F 0B 50 FA 00 C4 00"),
        ("write 11 command run forward", "2F 0B 50 FA 00 04 00"),
        ("write 11 command C400", "2F 0B 50 FA 00 C4 00"),
        ("write 11 command run=1 reverse", "2F 0B 50 FA 00 06 00"),
        ("write all command fault_reset", "2F FF 50 FA 00 20 00"),
        ("write 11 1234 00FF", "2F 0B 50 12 34 00 FF"),
    ],
)
def test_words_are_telegrams(text: str, frame: str) -> None:
    wanted = bytes.fromhex(frame)
    assert frames(text) == [(wanted + bytes((checksum(wanted),))).hex(" ").upper()]


def test_one_line_may_ask_several_for_several() -> None:
    assert len(frames("read 1-3 status trip")) == 6


def test_modbus_and_ascii_have_frames_of_their_own() -> None:
    series = load_catalog().drive("vf-s11")
    assert frames("read 1 FD00", Talking(series, "modbus")) == ["01 03 FD 00 00 01 B5 A6"]
    (frame,) = frames("write all frequency 60", Talking(series, "modbus"))
    assert frame.startswith("00 06 FA 01 17 70")
    (frame,) = frames("read 11 FE03", Talking(series, "toshiba", Form.ASCII))
    assert bytes.fromhex(frame).startswith(b"(11RFE03&")


def test_a_series_that_keeps_what_modbus_writes_wants_that_to_be_said() -> None:
    series = Talking(load_catalog().drive("vf-s15"), "modbus")
    with pytest.raises(DiagnosticError, match=r"FB9050.*in its EEPROM"):
        frames("write 1 frequency 50", series)
    assert len(frames("write 1 frequency 50 --eeprom", series)) == 1
    with pytest.raises(DiagnosticError, match=r"FB9050.*in its RAM"):
        frames("write 1 frequency 50 --eeprom", Talking(load_catalog().drive("vf-s11"), "modbus"))


@pytest.mark.parametrize(
    ("text", "code", "says"),
    [
        ("turn 11", "FB9050", "nothing that can be asked"),
        ("scann", "FB9050", "did you mean 'scan'"),
        ("scan", "FB9050", "on the command line: fbgen talk --port P scan"),
        ("names of all", "FB9050", "'names' takes no words"),
        ("read 99 status", "FB9050", "0 to 63; in ASCII (--ascii) to 99"),
        ("read 11 frequncy", "FB1105", "'frequency'"),
        ("read", "FB9050", "not said which inverter"),
        ("read 11", "FB9050", "not all of 'read'"),
        ("write 11 frequency", "FB9050", "not all of 'write'"),
        ("read all status", "FB9050", "nobody answers"),
        ("read 64 status", "FB9050", "'64' is no INV-NO"),
        ("read 5-3 status", "FB9050", "'5-3' is no INV-NO"),
        ("read 11 status --eeprom", "FB9050", "leaves the EEPROM alone"),
        ("read 11 statuss", "FB1105", "did you mean 'status'"),
        ("write 11 frequency 50 60", "FB9050", "2 values"),
        ("write 11 frequency fast", "FB9050", "'fast' is no value"),
        ("write 11 frequency 5000", "FB9050", "use 0 to 655.35 Hz"),
        ("write 11 frequency 12345h", "FB1204", "no 16-bit number"),
        ("write 11 command runn", "FB1202", "runn"),
        ("write 11 command run=x", "FB9050", "no number for 'run'"),
        ("write 11 command forward reverse", "FB9050", "at once"),
    ],
)
def test_what_is_no_question_is_told_before_anything_is_sent(
    text: str, code: str, says: str
) -> None:
    with pytest.raises(DiagnosticError) as caught:
        frames(text)
    assert code in str(caught.value)
    assert says in str(caught.value)


@linux
def test_values_are_read_and_written_with_names_and_units(fbgen: Fbgen, line: Serving) -> None:
    run = talk(fbgen, line, "write 2 frequency 50 -v")
    assert (run.status, run.out) == (0, "2  FA01 frequency_setpoint 1388 = 50.00 Hz\n")
    assert "> 2F 02 50 FA 01 13 88 17" in run.err
    assert "< 2F 02 50 FA 01 13 88 17" in run.err
    run = talk(fbgen, line, "--inv-no 2 read frequency status")
    assert run.out.splitlines() == [
        "2  FA01 frequency_setpoint 1388 = 50.00 Hz",
        "2  FD01 status 6000 = standby, standby_st_on",
    ]
    run = talk(fbgen, line, "read 2 frequency status --json")
    value, bits = json.loads(run.out)["answers"]
    assert (value["value"], value["unit"], value["received"]) == (
        *(50.0, "Hz"),
        "2F 02 52 FA 01 13 88 19",
    )
    assert bits["bits"] == ["standby", "standby_st_on"]


@linux
def test_a_motor_starts_only_if_it_is_said_twice(fbgen: Fbgen, line: Serving) -> None:
    start = "write 2 command run forward network_command"
    run = talk(fbgen, line, start)
    assert (run.status, run.out) == (1, "")
    assert "FB9053" in run.err
    assert line.served.log.requests == 0
    run = talk(fbgen, line, f"{start} --yes")
    assert run.status == 0
    assert line.drives["vf2"].running
    run = talk(fbgen, line, "write 3 command run --yes")
    assert "note: without network_command nothing comes of run" in run.err
    assert not line.drives["vf3"].running


@linux
def test_eeprom_has_to_be_said(fbgen: Fbgen, line: Serving) -> None:
    talk(fbgen, line, "write 2 F803 2")
    registers = line.drives["vf2"].registers
    assert (registers.ram[0x803], registers.eeprom[0x803]) == (2, 0)
    talk(fbgen, line, "write 2 F803 3 --eeprom")
    assert (registers.ram[0x803], registers.eeprom[0x803]) == (3, 3)


@linux
def test_what_an_inverter_says_no_to_is_fb9052(fbgen: Fbgen, line: Serving) -> None:
    run = talk(fbgen, line, "read 2 1234")
    assert (run.status, run.out) == (1, "")
    assert "FB9052]: inverter 2 refuses 1234 to be read: there is no such ComNo (0002)" in run.err
    run = talk(fbgen, line, "write 2 frequency 600")
    assert "FB9052]: inverter 2 refuses FA01 EA60" in run.err
    assert "takes 0 to 500 Hz, and not more than maximum_frequency" in run.err
    run = talk(fbgen, line, "write 2 status 0")
    assert "status can only be read" in run.err
    run = talk(fbgen, line, "write 2 frequency 600 --ascii")
    assert "the data are outside of the range (0001)" in run.err
    line.drives["vf2"].trip("OC1")
    run = talk(fbgen, line, "read 2 trip")
    assert run.out.endswith("0001 = OC1, Over-current during acceleration  (tripped)\n")


@linux
def test_of_several_inverters_all_are_asked_and_the_silent_one_is_told(
    fbgen: Fbgen, line: Serving
) -> None:
    line.drives["vf2"].power_off()
    run = talk(fbgen, line, "read 1-3 status --timeout 1s")
    assert run.status == 1
    assert [row[0] for row in run.out.splitlines()] == ["1", "3"]
    assert "FB9051]: inverter 2 does not answer" in run.err
    assert "scan finds them" in run.err


@linux
def test_what_is_for_all_is_not_answered(fbgen: Fbgen, line: Serving) -> None:
    run = talk(fbgen, line, "write all frequency 10")
    assert run.out == "all  FA01 frequency_setpoint 03E8 = 10.00 Hz  sent, not answered\n"
    assert talk(fbgen, line, "read 3 frequency").out.endswith("03E8 = 10.00 Hz\n")


@linux
def test_a_damaged_reply_and_one_of_another_are_told_apart(fbgen: Fbgen, line: Serving) -> None:
    line.drives["vf2"].communication.reply_number = 3
    run = talk(fbgen, line, "read 2 status --timeout 500ms")
    assert "inverter 2 does not answer, something else does" in run.err
    line.drives["vf2"].communication.reply_number = None
    line.served.line.slave_pair.interference.bit_errors.probability = 0.2
    run = talk(fbgen, line, "read 2 status --timeout 500ms")
    assert run.status == 1
    assert "FB9051" in run.err


@linux
def test_a_scan_finds_the_inverters(
    fbgen: Fbgen, line: Serving, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fbgen.cli.ports.talk_scan._TIMEOUT_NS", 500_000_000)
    run = talk(fbgen, line, "scan --numbers 1-2,5")
    assert run.status == 0
    assert run.out.splitlines() == [f"INV-NO {number}: {line.port}" for number in (1, 2)]
    run = talk(fbgen, line, "scan --numbers 3 --json")
    (found,) = json.loads(run.out)["found"]
    assert (found["inv_no"], found["reply"]) == (3, "2F 03 52 FD 01 60 00 E2")
    run = talk(fbgen, line, "scan --numbers 9")
    assert (run.status, run.out) == (1, "")
    assert "FB9051]: no inverter has answered" in run.err
    assert "FB9050" in talk(fbgen, line, "scan --numbers 300").err
    assert "FB9050" in talk(fbgen, line, "scan all").err


def test_a_scan_tries_every_speed_and_parity_of_the_series(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    tried: list[str] = []

    class Silent:
        name = "COM3"

        def read(self, wait_s: float = 0.01) -> bytes:
            sleep(wait_s)
            return b""

        def write(self, data: bytes) -> None:
            pass

        def close(self) -> None:
            pass

    def opened(name: str, characters: object) -> Silent:
        tried.append(str(characters))
        return Silent()

    monkeypatch.setattr("harness.serial.serial_port", opened)
    monkeypatch.setattr("harness.serial.asking._PROBE_NS", 0)
    monkeypatch.setattr("fbgen.cli.ports.talk_scan._TIMEOUT_NS", 0)
    run = fbgen("talk", "--port", "COM3", "scan", "--numbers", "1")
    assert run.status == 1
    assert tried[0] == "9600 8E1"
    assert len(tried) == len(set(tried)) == 15
    tried.clear()
    fbgen("talk", "--port", "COM3", "--baud", "19200", "--parity", "odd", "scan", "--numbers", "1")
    assert tried == ["19200 8O1"]


@linux
def test_lines_from_a_file_are_carried_out_up_to_quit(
    fbgen: Fbgen, line: Serving, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = "# FH\nread 1 FH\nnames\nhelp\nturn 1\nwrite 1 command run\nquit\nread 1 FH\n"
    monkeypatch.setattr("sys.stdin", io.StringIO(text))
    run = talk(fbgen, line, "")
    assert run.status == 1
    rows = run.out.splitlines()
    assert rows[0] == "1  0011 maximum_frequency 1F40 = 80.00 Hz"
    assert "FA01  frequency_setpoint [Hz]: Frequency set-point" in rows
    assert "--eeprom writes for good" in run.err
    assert run.err.count("FB9050") == run.err.count("FB9053") == 1
    assert sum("maximum_frequency 1F40" in row for row in rows) == 1


@linux
def test_a_person_is_asked_before_a_motor_starts(
    fbgen: Fbgen, line: Serving, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdin.isatty", lambda: True, raising=False)
    asked: list[str] = []
    monkeypatch.setattr("typer.confirm", lambda text, err: asked.append(text) or True)
    run = talk(fbgen, line, "write 1 command run network_command")
    assert run.status == 0
    assert asked == ["This starts the motor of inverter 1. Go on?"]
    assert line.drives["vf1"].running


def test_a_wrong_timeout_is_told(fbgen: Fbgen) -> None:
    run = fbgen("talk", "--port", "COM3", "read", "1", "status", "--timeout", "5")
    assert "FB9050]: --timeout" in run.err
