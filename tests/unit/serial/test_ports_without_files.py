"""Ports for which no system call waits: `loop://`, and a converter in the network (RFC 2217)."""

import socket
from contextlib import closing
from threading import Event, Thread
from time import monotonic

import pytest
import serial
import serial.rfc2217

from harness.line import Parity, SerialFormat
from harness.serial import serial_port

SETTING = SerialFormat(19_200, Parity.EVEN, 1)
PATIENCE_S = 20.0


def test_a_loop_gives_back_what_is_written_and_waits_no_longer_than_asked() -> None:
    with closing(serial_port("loop://", SETTING)) as port:
        assert port.read(0) == b""
        begin_s = monotonic()
        assert port.read(0.02) == b""
        assert monotonic() - begin_s >= 0.02
        port.write(b"\x2f\x0b")
        assert port.read(PATIENCE_S) == b"\x2f\x0b"


class Converter:
    """A serial port in the network, as a converter offers it: pyserial's own server side."""

    def __init__(self, name: str) -> None:
        self._over = Event()
        self._serial = serial.serial_for_url(name, timeout=0, do_not_open=True)
        self._serial.open()
        self._server = socket.create_server(("127.0.0.1", 0))
        self.address = f"rfc2217://127.0.0.1:{self._server.getsockname()[1]}"
        self._thread = Thread(target=self._serve)
        self._thread.start()

    def _serve(self) -> None:
        client, _ = self._server.accept()
        client.settimeout(0.005)
        self.client = client
        manager = serial.rfc2217.PortManager(self._serial, self)
        while not self._over.is_set():
            manager.check_modem_lines()
            try:
                data = client.recv(1024)
            except TimeoutError:
                data = b""
            self._serial.write(b"".join(manager.filter(data)))
            if come := self._serial.read(1024):
                self.write(b"".join(manager.escape(come)))
        client.close()

    def write(self, data: bytes) -> None:
        """As the manager wants it: towards the client."""
        self.client.sendall(data)

    def close(self) -> None:
        self._over.set()
        self._thread.join()
        self._server.close()
        self._serial.close()


@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")
def test_a_converter_in_the_network_is_a_port() -> None:
    """What is sent comes back from a loop behind the converter."""
    with (
        closing(Converter("loop://")) as converter,
        closing(serial_port(converter.address, SETTING)) as port,
    ):
        assert port.read(0) == b""
        port.write(b"\x2f\x0b\xff\x00")
        heard, end_s = b"", monotonic() + PATIENCE_S
        while len(heard) < 4 and monotonic() < end_s:
            heard += port.read(0.1)
        assert heard == b"\x2f\x0b\xff\x00"


def test_a_port_of_windows_is_asked_again_and_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("harness.serial.ports.sys.platform", "win32")
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = serial_port(f"socket://127.0.0.1:{server.getsockname()[1]}", SETTING)
        master, _ = server.accept()
        with closing(port), master:
            assert port.read(0.001) == b""
            master.sendall(b"\x2f")
            assert port.read(PATIENCE_S) == b"\x2f"
