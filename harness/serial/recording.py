"""Listens at a port and gives the frames with their times; it never sends."""

from collections.abc import Callable
from time import monotonic_ns

from fbgen.wire.line_frames import FrameSplitter, LineFrame
from fbgen.wire.line_protocols import LineProtocol
from harness.serial.ports import Port


class Recording:
    """Frames as they are heard; `told` gets each, with times from the begin."""

    def __init__(
        self,
        port: Port,
        protocol: LineProtocol,
        told: Callable[[LineFrame], None],
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._port = port
        self._told = told
        self._clock_ns = clock_ns
        self._splitter = FrameSplitter(protocol)
        self._begin_ns = clock_ns()

    @property
    def elapsed_ns(self) -> int:
        """Time since the begin."""
        return self._clock_ns() - self._begin_ns

    def step(self) -> None:
        """Listen for a moment. Raises DiagnosticError FB9031 if the port is gone."""
        data = self._port.read()
        now_ns = self.elapsed_ns
        found = self._splitter.feed(data, now_ns) if data else self._splitter.end(now_ns)
        for frame in found:
            self._told(frame)

    def end(self) -> None:
        """What has been heard and is no whole frame yet is told, too."""
        for frame in self._splitter.flush():
            self._told(frame)
