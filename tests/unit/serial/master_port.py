"""The master's end of a virtual line: what it reads is what simulated inverters answer."""

from collections.abc import Callable

from harness.kernel import NS_PER_S
from harness.line import SerialFormat
from tests.unit.serial.virtual_port import ServedLine


class MasterPort:
    """Time passes while it waits. `echo` gives back what is sent, `change` alters what comes."""

    name = "virtual"

    def __init__(
        self,
        line: ServedLine,
        *,
        echo: bool = False,
        change: Callable[[bytes], bytes] = lambda data: data,
    ) -> None:
        self._line = line
        self._echo = echo
        self._change = change
        self._waiting = b""
        self.sent: list[bytes] = []
        self.characters: SerialFormat | None = None

    def clock(self) -> int:
        return self._line.port.now_ns

    def write(self, data: bytes) -> None:
        self.sent.append(data)
        self._line.port.script.append((self.clock(), data))
        if self._echo:
            self._waiting += data

    def read(self, wait_s: float = 0.01) -> bytes:
        port = self._line.port
        end_ns = port.limit_ns = port.now_ns + round(wait_s * NS_PER_S)
        while True:
            self._line.server.step()
            self._waiting += b"".join(self._change(data) for _, data in port.written)
            port.written.clear()
            if port.now_ns >= end_ns or self._waiting:
                break
        port.limit_ns = None
        found, self._waiting = self._waiting, b""
        return found

    def set_characters(self, characters: SerialFormat) -> None:
        self.characters = characters

    def close(self) -> None:
        pass
