"""A port with bytes in and out, and real serial ports by pyserial: RS-485 adapters, `socket://`.

PROFIBUS characters have eight data bits, even parity and one stop bit (EN 50170 volume 2, part 4).
"""

import errno
from importlib.util import find_spec
from typing import TYPE_CHECKING, Protocol

from fbgen.diagnostics import DiagnosticError, error

if TYPE_CHECKING:
    import serial

BAUD_RATES = (9_600, 19_200, 45_450, 93_750, 187_500, 500_000, 1_500_000)
"""Speeds of PROFIBUS that a serial port may have; beyond them start 3, 6 and 12 Mbit/s."""
TICK_S = 0.01
"""How long a port waits for bytes: so often the server looks what else there is to do."""
_BUSY = (errno.EBUSY, errno.EAGAIN)
_DENIED = (errno.EACCES, errno.EPERM)


class Port(Protocol):
    """Where a master is."""

    @property
    def name(self) -> str:
        """What a person calls it."""
        ...

    def read(self) -> bytes:
        """What has come; waits `TICK_S` for the first byte.

        Raises DiagnosticError FB9031 if the port is not there any more.
        """
        ...

    def write(self, data: bytes) -> None:
        """Send; as `read`."""
        ...

    def close(self) -> None:
        """Give the port back."""
        ...


class SerialPort:
    """A port of pyserial that is open."""

    def __init__(self, name: str, device: "serial.SerialBase") -> None:
        self._device = device
        self._name = name

    @property
    def name(self) -> str:
        """The name or address by which it was opened."""
        return self._name

    def read(self) -> bytes:
        """As `Port.read`."""
        try:
            first = bytes(self._device.read(1))
            waiting = self._device.in_waiting if first else 0
            return first + bytes(self._device.read(waiting)) if waiting else first
        except OSError as problem:
            raise _gone(self._name, problem) from problem

    def write(self, data: bytes) -> None:
        """As `Port.write`."""
        try:
            self._device.write(data)
        except OSError as problem:
            raise _gone(self._name, problem) from problem

    def close(self) -> None:
        """As `Port.close`."""
        self._device.close()


def profibus_port(name: str, baud: int) -> SerialPort:
    """A serial port for PROFIBUS by its name (COM3, /dev/ttyUSB0) or pyserial address.

    Raises DiagnosticError FB9033 without pyserial, FB9031 for a port that cannot be opened.
    """
    if find_spec("serial") is None:
        raise error(
            "FB9033",
            "serial ports are opened with the package pyserial, which is not installed",
            None,
            "pip install 'fbgen[serial]'",
        )
    if baud not in BAUD_RATES:
        raise error(
            "FB9031",
            f"{name} cannot be opened: {baud} bit/s is no speed of PROFIBUS for a serial port",
            None,
            f"take one of {', '.join(map(str, BAUD_RATES))}",
        )
    import serial  # noqa: PLC0415 - an extra: only who opens a port needs it

    try:
        device = serial.serial_for_url(
            name,
            baudrate=baud,
            bytesize=serial.EIGHTBITS,
            parity=serial.PARITY_EVEN,
            stopbits=serial.STOPBITS_ONE,
            timeout=TICK_S,
            exclusive=True,
        )
    except (OSError, ValueError) as problem:
        raise _not_opened(name, problem) from problem
    return SerialPort(name, device)


def _not_opened(name: str, problem: Exception) -> DiagnosticError:
    number, text = getattr(problem, "errno", None), str(problem)
    if number == errno.ENOENT or "FileNotFoundError" in text:
        reason, help_text = "there is no such port", "is the adapter plugged in? " + _list_ports()
    elif number in _DENIED or "PermissionError" in text:
        reason = "it is in use, or you may not use it"
        help_text = "end the other program; on Linux, become a member of the port's group (dialout)"
    elif number in _BUSY:
        reason, help_text = "another program uses it", "end the other program"
    elif number == errno.EINVAL:
        reason = "it cannot have even parity or this speed"
        help_text = "a pseudo terminal keeps no parity: let --pty make one; else try --baud 19200"
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
