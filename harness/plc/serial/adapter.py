"""What stands for a serial block of the user's on a PLC by IEC 61131-3 or TwinCAT.

The generated program and the user's own meet in `TIP_Adapters.<line>`; here is what the user's part
does there, after each scan: send what `sendCount` announces, hand over one message after the other.
"""

from collections.abc import Callable

from harness.engine.interface import Engine, Value
from harness.kernel import Kernel
from harness.plc.serial.module import SendJob, SerialModule

LONGEST = 32
_MOST = 32_000
_UNUSABLE = 0xFFFF


class SerialAdapter:
    """One line. `path` is that of its structure, `engine` gives the program that runs."""

    __slots__ = ("_engine", "_epoch", "_job", "_kernel", "_module", "_path", "_seen")

    def __init__(
        self, kernel: Kernel, module: SerialModule, engine: Callable[[], Engine], path: str
    ) -> None:
        self._kernel = kernel
        self._module = module
        self._engine = engine
        self._path = path
        self._epoch = -1
        self._job: SendJob | None = None
        self._seen = 0

    def exchange(self) -> None:
        """Behind a scan of the program."""
        if self._epoch != self._module.epoch:
            self._epoch = self._module.epoch
            self._job, self._seen = None, self._number("sendCount")
        self._set("failed", not self._module.available)
        if not self._module.available:
            self._set("status", _UNUSABLE)
            return
        self._send()
        self._receive()

    def _send(self) -> None:
        count = self._number("sendCount")
        if self._job is not None and self._job.over(self._kernel.now_ns):
            self._set("sentCount", self._seen)
            self._job = None
        if count != self._seen:
            self._seen = count
            length = self._number("sendLength")
            self._job = self._module.send(bytes(self._octets("outBytes")[:length]))

    def _receive(self) -> None:
        count = self._number("receiveCount")
        if count != self._number("takenCount"):
            return
        message = self._module.take()
        if message is None:
            return
        data = message.data[:LONGEST]
        self._set("damaged", message.failed or len(message.data) > LONGEST)
        self._set("receiveLength", len(data))
        self._set("inBytes", list(data.ljust(LONGEST, b"\0")))
        self._set("receiveCount", count % _MOST + 1)

    def _number(self, name: str) -> int:
        value = self._engine().global_value(f"{self._path}.{name}")
        assert isinstance(value, int)
        return value

    def _octets(self, name: str) -> list[int]:
        value = self._engine().global_value(f"{self._path}.{name}")
        return [int(str(one)) for one in value] if isinstance(value, list | tuple) else []

    def _set(self, name: str, value: Value) -> None:
        self._engine().set_global(f"{self._path}.{name}", value)
