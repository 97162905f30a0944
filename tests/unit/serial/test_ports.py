"""Ports: those of pyserial, a pseudo terminal of our own, and what goes wrong with them."""

import errno
import os
import socket
import sys

import pytest
import serial

from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.line import Parity, SerialFormat
from harness.serial import PseudoTerminal, profibus_port, serial_port

linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")


def refused(name: str, baud: int = 19_200) -> Diagnostic:
    with pytest.raises(DiagnosticError) as caught:
        profibus_port(name, baud)
    return caught.value.diagnostics[0]


def test_a_network_socket_is_a_port() -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = profibus_port(f"socket://127.0.0.1:{server.getsockname()[1]}", 19_200)
        master, _ = server.accept()
        master.sendall(b"\x10\x02")
        data = port.read() + port.read()
        assert data == b"\x10\x02"
        port.write(b"\xe5")
        assert master.recv(10) == b"\xe5"
        master.close()
        with pytest.raises(DiagnosticError, match="FB9031"):
            list(iter(port.read, None))
        port.close()


def test_a_port_is_opened_with_even_parity_and_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: dict[str, object] = {}
    monkeypatch.setattr("serial.serial_for_url", lambda name, **options: asked.update(options))
    profibus_port("COM3", 93_750)
    assert (asked["parity"], asked["bytesize"], asked["stopbits"]) == ("E", 8, 1)
    assert (asked["baudrate"], asked["exclusive"]) == (93_750, True)


@pytest.mark.parametrize(
    ("problem", "says"),
    [
        (serial.SerialException(errno.ENOENT, "No such file"), "there is no such port"),
        (serial.SerialException("could not open 'COM9': FileNotFoundError(2, '')"), "no such port"),
        (serial.SerialException(errno.EACCES, "denied"), "you may not use it"),
        (serial.SerialException("could not open 'COM9': PermissionError(13, '')"), "in use, or"),
        (serial.SerialException(errno.EAGAIN, "lock"), "another program uses it"),
        (serial.SerialException(errno.EINVAL, "invalid"), "even parity"),
        (ValueError("invalid URL"), "invalid URL"),
    ],
    ids=["missing", "missing on Windows", "denied", "busy on Windows", "busy", "parity", "name"],
)
def test_a_port_that_cannot_be_opened_says_why(
    monkeypatch: pytest.MonkeyPatch, problem: Exception, says: str
) -> None:
    def fail(name: str, **options: object) -> None:
        raise problem

    monkeypatch.setattr("serial.serial_for_url", fail)
    found = refused("COM9")
    assert found.code == "FB9031"
    assert says in found.message
    assert found.help


@pytest.mark.parametrize("scheme", ["socket", "rfc2217"])
def test_an_address_where_nobody_listens_is_not_looked_for_among_ports(scheme: str) -> None:
    with socket.create_server(("127.0.0.1", 0)) as server:
        place = f"{scheme}://127.0.0.1:{server.getsockname()[1]}"
    found = refused(place)
    assert "refused" in found.message
    assert found.help == (
        "is the other end listening there? write socket://HOST:PORT or rfc2217://HOST:PORT"
    )


@linux
def test_a_port_goes_on_with_other_characters() -> None:
    import termios  # noqa: PLC0415 - there is none on Windows

    terminal = PseudoTerminal()
    port = serial_port(terminal.name, SerialFormat(19_200, Parity.EVEN, 1))
    port.set_characters(SerialFormat(9_600, Parity.ODD, 2))
    end = os.open(terminal.name, os.O_RDWR | os.O_NOCTTY)
    assert termios.tcgetattr(end)[4] == termios.B9600
    os.close(end)
    port.write(b"\x2f")
    assert terminal.read() == b"\x2f"
    with pytest.raises(DiagnosticError, match="FB9031"):
        port.set_characters(SerialFormat(-1, Parity.EVEN, 1))
    port.close()
    terminal.close()


def test_without_pyserial_there_is_a_hint(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("harness.serial.ports.find_spec", lambda name: None)
    found = refused("COM3")
    assert (found.code, found.help) == ("FB9033", "pip install 'fbgen[serial]'")


def test_pseudo_terminals_are_refused_elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.platform", "win32")
    with pytest.raises(DiagnosticError, match="FB9032"):
        PseudoTerminal()


@linux
def test_a_pseudo_terminal_passes_every_byte_on_and_masters_may_come_and_go() -> None:
    port = PseudoTerminal()
    every = bytes(range(256))
    for _ in range(2):
        master = os.open(port.name, os.O_RDWR | os.O_NOCTTY)
        os.write(master, every)
        assert port.read() == every
        port.write(every)
        assert os.read(master, 300) == every
        os.close(master)
        assert port.read() == b""
    port.close()


@linux
def test_what_no_master_reads_does_not_stop_the_server() -> None:
    port = PseudoTerminal()
    for _ in range(200):
        port.write(bytes(250))
    port.close()
