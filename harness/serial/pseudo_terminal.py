"""A pseudo terminal of our own: a serial port without wires, for masters on the same machine.

It passes bytes on unchanged and at once. It has no speed, no parity and no modem lines, whatever a
program sets on it.
"""

import os
import select
import sys

from fbgen.diagnostics import error
from harness.serial.ports import TICK_S

_MOST = 4096


class PseudoTerminal:
    """The end of a pseudo terminal at which the devices are. `name` is the other end's path."""

    def __init__(self) -> None:
        """Raises DiagnosticError FB9032 on systems other than Linux."""
        if sys.platform != "linux":
            raise error(
                "FB9032",
                "pseudo terminals are made on Linux only",
                None,
                "take a pair of virtual COM ports and give one of them as --port",
            )
        import tty  # noqa: PLC0415 - there is none on Windows

        self._end, self._other_end = os.openpty()
        # Kept open here, so that masters may come and go.
        tty.setraw(self._other_end)
        os.set_blocking(self._end, False)
        self._name = os.ttyname(self._other_end)

    @property
    def name(self) -> str:
        """The path that a master opens."""
        return self._name

    def read(self, wait_s: float = TICK_S) -> bytes:
        """As `Port.read`."""
        ready, _, _ = select.select([self._end], [], [], wait_s)
        return os.read(self._end, _MOST) if ready else b""

    def write(self, data: bytes) -> None:
        """As `Port.write`; what nobody reads is lost when the buffer is full, as on a cable."""
        try:
            os.write(self._end, data)
        except BlockingIOError:
            return

    def close(self) -> None:
        """As `Port.close`."""
        os.close(self._end)
        os.close(self._other_end)
