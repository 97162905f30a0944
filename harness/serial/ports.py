"""A port with bytes in and out, and real serial ports by pyserial: RS-485 adapters, `socket://`.

PROFIBUS characters have eight data bits, even parity and one stop bit (EN 50170 volume 2, part 4);
the lines of inverters have what their parameters say.
"""

import errno
import io
import select
import sys
from importlib.util import find_spec
from pathlib import Path
from time import monotonic, sleep
from typing import TYPE_CHECKING, Protocol

from fbgen.diagnostics import DiagnosticError, error
from harness.line import Parity, SerialFormat

if TYPE_CHECKING:
    import serial

BAUD_RATES = (9_600, 19_200, 45_450, 93_750, 187_500, 500_000, 1_500_000)
"""Speeds of PROFIBUS that a serial port may have; beyond them start 3, 6 and 12 Mbit/s."""
TICK_S = 0.01
"""How long a port waits for bytes: so often the server looks what else there is to do."""
_MOST = 4096
_LOOK_S = 0.0005
"""How often a port is asked that cannot tell when bytes come: those of Windows, `rfc2217://`."""
_BUSY = (errno.EBUSY, errno.EAGAIN)
_DENIED = (errno.EACCES, errno.EPERM)


class Port(Protocol):
    """Where the other side is."""

    @property
    def name(self) -> str:
        """What a person calls it."""
        ...

    def read(self, wait_s: float = TICK_S) -> bytes:
        """What has come; waits `wait_s` at most for the first byte.

        Raises DiagnosticError FB9031 if the port is not there any more.
        """
        ...

    def write(self, data: bytes) -> None:
        """Send; as `read`."""
        ...

    def close(self) -> None:
        """Give the port back."""
        ...


class SettablePort(Port, Protocol):
    """A port that goes on with other characters when it is told to."""

    def set_characters(self, characters: SerialFormat) -> None:
        """Take another speed and parity.

        Raises DiagnosticError FB9031 for some that the port cannot have.
        """
        ...


class SerialPort:
    """A port of pyserial that is open and never waits by itself."""

    def __init__(self, name: str, device: "serial.SerialBase") -> None:
        self._device = device
        self._name = name
        self._file = _file_of(device)

    @property
    def name(self) -> str:
        """The name or address by which it was opened."""
        return self._name

    def read(self, wait_s: float = TICK_S) -> bytes:
        """As `Port.read`."""
        try:
            if self._file is None:
                return self._waited(wait_s)
            ready, _, _ = select.select([self._file], [], [], wait_s)
            return bytes(self._device.read(_MOST)) if ready else b""
        except OSError as problem:
            raise _gone(self._name, problem) from problem

    def _waited(self, wait_s: float) -> bytes:
        end_s = monotonic() + wait_s
        while not (data := bytes(self._device.read(_MOST))) and monotonic() < end_s:
            sleep(_LOOK_S)
        return data

    def write(self, data: bytes) -> None:
        """As `Port.write`."""
        try:
            self._device.write(data)
        except OSError as problem:
            raise _gone(self._name, problem) from problem

    def set_characters(self, characters: SerialFormat) -> None:
        """As `SettablePort.set_characters`."""
        parity = Parity.NONE if _is_pseudo_terminal(self._name) else characters.parity
        try:
            self._device.baudrate = characters.baud
            self._device.parity = parity.value
            self._device.stopbits = characters.stop_bits
        except (OSError, ValueError, OverflowError) as problem:
            raise _not_opened(self._name, characters, problem) from problem

    def close(self) -> None:
        """As `Port.close`."""
        self._device.close()


def profibus_port(name: str, baud: int) -> SerialPort:
    """A serial port for PROFIBUS by its name (COM3, /dev/ttyUSB0) or pyserial address.

    Raises DiagnosticError as `serial_port`, FB9031 for a speed that PROFIBUS does not have too.
    """
    if baud not in BAUD_RATES:
        raise error(
            "FB9031",
            f"{name} cannot be opened: {baud} bit/s is no speed of PROFIBUS for a serial port",
            None,
            f"take one of {', '.join(map(str, BAUD_RATES))}",
        )
    return serial_port(name, SerialFormat(baud, Parity.EVEN, 1))


def serial_port(name: str, characters: SerialFormat) -> SerialPort:
    """A serial port with these characters, by its name or pyserial address.

    A pseudo terminal has no parity, so none is asked of one. Raises DiagnosticError FB9033 without
    pyserial, FB9031 for a port that cannot be opened.
    """
    if find_spec("serial") is None:
        raise error(
            "FB9033",
            "serial ports are opened with the package pyserial, which is not installed",
            None,
            "pip install 'fbgen[serial]'",
        )
    import serial  # noqa: PLC0415 - an extra: only who opens a port needs it

    parity = Parity.NONE if _is_pseudo_terminal(name) else characters.parity
    try:
        device = serial.serial_for_url(
            name,
            baudrate=characters.baud,
            bytesize=serial.EIGHTBITS,
            parity=parity.value,
            stopbits=characters.stop_bits,
            timeout=0,
            exclusive=True,
        )
    except (OSError, ValueError, OverflowError) as problem:
        raise _not_opened(name, characters, problem) from problem
    return SerialPort(name, device)


def has_speed(name: str) -> bool:
    """Whether speed and parity mean something at a port: not at a pseudo terminal or a socket."""
    return not (_is_pseudo_terminal(name) or name.startswith(("socket://", "loop://")))


def _is_pseudo_terminal(name: str) -> bool:
    return name.startswith("/") and Path(name).resolve().is_relative_to("/dev/pts")


def _file_of(device: "serial.SerialBase") -> int | None:
    """What `select` waits for; None where there is no such thing."""
    if sys.platform == "win32":
        return None
    try:
        return int(device.fileno())
    except (AttributeError, io.UnsupportedOperation):
        return None


def _not_opened(name: str, characters: SerialFormat, problem: Exception) -> DiagnosticError:
    number, text = getattr(problem, "errno", None), str(problem)
    if number == errno.ENOENT or "FileNotFoundError" in text:
        reason, help_text = "there is no such port", "is the adapter plugged in? " + _list_ports()
    elif number in _DENIED or "PermissionError" in text:
        reason = "it is in use, or you may not use it"
        help_text = "end the other program; on Linux, become a member of the port's group (dialout)"
    elif number in _BUSY:
        reason, help_text = "another program uses it", "end the other program"
    elif number == errno.EINVAL:
        reason = (
            f"it cannot have {characters.parity.name.lower()} parity or {characters.baud} bit/s"
        )
        help_text = "a pseudo terminal keeps no parity: let --pty make one; else try --baud 19200"
    elif "://" in name:
        reason = text
        help_text = (
            "is the other end listening there? write socket://HOST:PORT or rfc2217://HOST:PORT"
        )
    else:
        reason, help_text = text, _list_ports()
    return error("FB9031", f"{name} cannot be opened: {reason}", None, help_text)


def _list_ports() -> str:
    from serial.tools.list_ports import comports  # noqa: PLC0415 - as above

    names = sorted(port.device for port in comports())
    return f"ports of this machine: {', '.join(names)}" if names else "this machine has no ports"


def _gone(name: str, problem: OSError) -> DiagnosticError:
    return error(
        "FB9031",
        f"{name} is not there any more: {problem}",
        None,
        "plug the adapter in, or start the other end, and begin again",
    )
