"""Slaves at a port in real time.

The virtual clock follows the wall clock: before a telegram is answered, everything has happened
that was due until then. An answer leaves as soon as the operating system lets it: the delays that
PROFIBUS asks for (Tsdr of some ten bit times) are not kept, and no telegram of the slave is early.
"""

from collections.abc import Callable
from time import monotonic_ns

from harness.fieldbus import Segment
from harness.kernel import NS_PER_MS, Kernel
from harness.serial.pace import Pace
from harness.serial.ports import Port

_SILENCE_NS = 30 * NS_PER_MS
"""Longer than USB adapters let the bytes of one telegram wait, shorter than a master's patience."""


class Server:
    """Answers a master until it is told to stop."""

    def __init__(
        self,
        kernel: Kernel,
        segment: Segment,
        port: Port,
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._kernel = kernel
        self._segment = segment
        self._port = port
        self._pace = Pace(kernel, clock_ns)
        self._heard_ns = kernel.now_ns

    def serve(self, goes_on: Callable[[], bool]) -> None:
        """Serve while `goes_on` says so; it is asked every 10 ms at least.

        Raises DiagnosticError FB9031 if the port is not there any more.
        """
        while goes_on():
            self.step()

    def step(self) -> None:
        """Wait for bytes, but not long; let time pass; answer."""
        data = self._port.read()
        self._pace.catch_up()
        now_ns = self._kernel.now_ns
        answer = b""
        if now_ns - self._heard_ns > _SILENCE_NS:
            answer = self._segment.silence()
        if data:
            self._heard_ns = now_ns
            answer += self._segment.receive(data)
        if answer:
            self._port.write(answer)
