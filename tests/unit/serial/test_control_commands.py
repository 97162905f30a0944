"""The commands of the control socket, and the socket itself."""

import json
import socket
import sys
from contextlib import closing
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.serial import Commands, ControlSocket, FaultSwitches
from tests.unit.serial.virtual_port import ServedLine

paths = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no sockets at a path")


class Controlled(ServedLine):
    """Inverters with commands for them."""

    def __init__(self, *numbers: int) -> None:
        super().__init__(*numbers)
        self.commands = Commands(self.served, FaultSwitches(self.served))

    def tell(self, line: str) -> dict[str, object]:
        told = self.commands.answer(line)
        assert told.pop("ok") is True, told
        return json.loads(json.dumps(told))

    def refused(self, line: str) -> dict[str, str]:
        told = self.commands.answer(line)
        assert told["ok"] is False
        (wrong,) = told["errors"]
        return wrong


def test_the_state_tells_what_each_drive_does() -> None:
    line = Controlled(1, 2)
    line.ask("2F 02 50 FA 00 C4 00 3F", "2F 02 50 FA 01 13 88 17", for_ms=1000)
    (state,) = line.tell("state 2")["drives"]
    assert state["state"] == "running"
    assert (state["direction"], state["set_point_hz"], state["replies"]) == ("forward", 50.0, 2)
    assert 0 < state["frequency_hz"] < 50
    told = line.tell("state")
    assert [item["name"] for item in told["drives"]] == ["vf1", "vf2"]
    assert told["line"]["requests"] == told["line"]["replies"] == 2
    assert told["line"]["bytes_received"] == told["line"]["bytes_sent"] == 16


def test_a_drive_trips_is_reset_and_loses_its_supply() -> None:
    line = Controlled(1)
    (state,) = line.tell("trip vf1 OC1")["drives"]
    assert (state["state"], state["trip"]) == ("tripped", "OC1")
    (state,) = line.tell("reset")["drives"]
    assert state["state"] == "stopped"
    assert line.tell("power vf1 off")["drives"][0]["state"] == "off"
    assert line.tell("power on")["drives"][0]["state"] == "stopped"


def test_parameters_are_set_and_read_by_any_of_their_names() -> None:
    line = Controlled(1)
    line.tell("set vf1 max_frequency=60 F803=3")
    assert line.tell("get 1 FH")["value"] == 60.0
    assert line.tell("get 1 0803") == {
        "com_no": "0803",
        "name": "communication_timeout",
        "word": "0003",
        "value": 3,
        "unit": "s",
    }
    assert line.refused("set vf1 max_frequency=600")["code"] == "FB7101"
    assert line.refused("get vf1 F80")["code"] == "FB1105"


def test_a_load_draws_current() -> None:
    line = Controlled(11)
    line.ask("2F 0B 50 FA 00 C4 00 48", "2F 0B 50 FA 01 13 88 20", for_ms=20_000)
    (before,) = line.tell("state")["drives"]
    (after,) = line.tell("load 11 90")["drives"]
    assert after["current_percent"] > before["current_percent"] + 20


def test_faults_are_switched_with_settings() -> None:
    line = Controlled(1)
    told = line.tell('fault drive_answers_late vf1 on delay="200 ms" probability=1')
    assert told == {"on": [{"fault": "drive_answers_late", "place": "vf1"}]}
    assert line.ask("2F 01 52 FD 01 80") == [""]
    assert line.tell("faults")["on"] == told["on"]
    assert "drive_slow" in line.tell("faults")["known"]
    assert line.tell("fault drive_answers_late off") == {"on": []}
    assert line.refused("fault drive_answers_late vf1 on delay=long")["code"] == "FB8004"
    assert line.tell("fault line_noise on bit_error_rate=0.5")["on"] == [
        {"fault": "line_noise", "place": "line"}
    ]


def test_the_last_frames_are_told_with_their_times() -> None:
    line = Controlled(1)
    line.ask("2F 01 52 FD 01 80", "00 2F 01 52 FD 01 80")
    frames = line.tell("frames")["frames"]
    assert [item["direction"] for item in frames] == [
        *("request", "reply", "unknown", "request", "reply")
    ]
    assert frames[1]["bytes"] == "2F 01 52 FD 01 60 00 E0"
    assert frames[1]["drive"] == "vf1"
    assert frames[0]["time_s"] < frames[1]["time_s"] < frames[3]["time_s"]
    assert len(line.tell("frames 2")["frames"]) == 2
    assert line.tell("frames 0")["frames"] == []


@pytest.mark.parametrize(
    "line",
    [
        *("", "stat", "fault", "fault on", "fault a b c on", "fault drive_slow vf1 on 30ms"),
        *("trip vf1", "power vf1", "get vf1", "set vf1", "set vf1 F803=x", "load vf1 nan"),
        *("frames x", "state vf9", 'trip "vf1', "reset a b"),
    ],
)
def test_what_cannot_be_carried_out_is_fb9037_with_help(line: str) -> None:
    wrong = Controlled(1).refused(line)
    assert wrong["code"] == "FB9037"
    assert wrong["help"]


def test_help_names_every_command_and_quit_ends() -> None:
    line = Controlled(1)
    known = line.tell("help")["commands"]
    assert {"state", "fault", "trip", "quit"} <= set(known)
    assert not line.commands.wants_end
    line.tell("quit")
    assert line.commands.wants_end


def answers(place: str) -> ControlSocket:
    return ControlSocket(place, lambda line: {"line": line})


def asked(control: ControlSocket, client: socket.socket, data: bytes) -> list[object]:
    client.sendall(data)
    client.settimeout(5)
    heard = b""
    while heard.count(b"\n") < data.count(b"\n"):
        control.look()
        try:
            client.settimeout(0.01)
            heard += client.recv(1000)
        except TimeoutError:
            continue
    return [json.loads(line) for line in heard.splitlines()]


def test_each_line_of_a_client_is_answered_with_a_line_of_json() -> None:
    with closing(answers("127.0.0.1:0")) as control:
        host, port = control.address.rsplit(":", 1)
        with socket.create_connection((host, int(port))) as client:
            assert asked(control, client, b"a\nb b\n") == [{"line": "a"}, {"line": "b b"}]
            with socket.create_connection((host, int(port))) as other:
                assert asked(control, other, b"c\n") == [{"line": "c"}]
            control.look()
            assert asked(control, client, b"\xff\n") == [{"line": "\ufffd"}]


def test_a_client_that_sends_no_end_of_a_line_is_left_alone() -> None:
    with closing(answers("127.0.0.1:0")) as control:
        host, port = control.address.rsplit(":", 1)
        with socket.create_connection((host, int(port))) as client:
            client.sendall(b"x" * 9000)
            for _ in range(10):
                control.look()
            client.settimeout(5)
            try:
                left = client.recv(100)
            except ConnectionError:
                left = b""
            assert left == b""


@paths
def test_a_socket_at_a_path_is_there_while_it_is_served(tmp_path: Path) -> None:
    path = tmp_path / "control"
    for _ in range(2):
        with closing(answers(str(path))) as control:
            assert control.address == str(path)
            with socket.socket(socket.AF_UNIX) as client:
                client.connect(str(path))
                assert asked(control, client, b"a\n") == [{"line": "a"}]
        assert not path.exists()


@paths
def test_a_socket_that_a_process_has_left_is_taken_over_one_in_use_is_not(tmp_path: Path) -> None:
    path = tmp_path / "control"
    with socket.socket(socket.AF_UNIX) as left:
        left.bind(str(path))
    with closing(answers(str(path))), pytest.raises(DiagnosticError, match="FB9036"):
        answers(str(path))


@pytest.mark.parametrize("place", ["127.0.0.1:99999", "/nowhere/at/all/control"])
def test_a_place_where_nobody_can_listen(place: str) -> None:
    with pytest.raises(DiagnosticError, match="FB9036"):
        answers(place)
