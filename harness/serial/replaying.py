"""One side of recorded traffic played again at a port, in the times of the recording."""

from collections.abc import Callable
from time import monotonic_ns
from typing import NamedTuple

from fbgen.wire.line_frames import FrameSplitter, LineFrame
from fbgen.wire.line_protocols import LINE_PROTOCOLS
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.serial.ports import TICK_S, Port
from harness.serial.traffic import Traffic

_LAST_WAIT_NS = 500 * NS_PER_MS
"""How long a reply to the last request is waited for."""


class Exchange(NamedTuple):
    """A request, the reply that was recorded and the one that came; None where there was none."""

    time_ns: int
    request: bytes
    recorded: bytes | None
    came: bytes | None

    @property
    def is_same(self) -> bool:
        """True if the same came back, or nothing both times."""
        return self.recorded == self.came


def exchanges(traffic: Traffic) -> list[tuple[LineFrame, LineFrame | None]]:
    """Each request with its reply: the first frame behind it that answers it."""
    found: list[tuple[LineFrame, LineFrame | None]] = []
    answers = LINE_PROTOCOLS[traffic.setting.protocol].answers
    for frame in traffic.frames:
        if frame.direction == "request":
            found.append((frame, None))
        elif frame.direction == "reply" and found and found[-1][1] is None:
            request = found[-1][0]
            if answers(request.data, frame.data):
                found[-1] = request, frame
    return found


class MasterReplay:
    """Sends the requests at their times and compares what comes back. `told` gets each exchange."""

    def __init__(
        self,
        traffic: Traffic,
        port: Port,
        told: Callable[[Exchange], None],
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._traffic = traffic
        self._port = port
        self._told = told
        self._clock_ns = clock_ns

    def run(self) -> None:
        """All of it. Raises DiagnosticError FB9031 if the port is gone."""
        protocol = LINE_PROTOCOLS[self._traffic.setting.protocol]
        known = exchanges(self._traffic)
        if not known:
            return
        offset_ns = self._clock_ns() - known[0][0].start_ns
        for index, (request, recorded) in enumerate(known):
            self._wait(offset_ns + request.start_ns)
            self._port.write(request.data)
            last = index == len(known) - 1
            end_ns = offset_ns + (
                request.end_ns + _LAST_WAIT_NS if last else known[index + 1][0].start_ns
            )
            splitter = FrameSplitter(protocol, "reply")
            came = None
            while (left_ns := end_ns - self._clock_ns()) > 0 and came is None:
                data = self._port.read(min(left_ns / NS_PER_S, TICK_S))
                for frame in splitter.feed(data, self._clock_ns()) if data else ():
                    if frame.direction == "reply" and protocol.answers(request.data, frame.data):
                        came = frame.data
            reply = None if recorded is None else recorded.data
            self._told(Exchange(request.start_ns, request.data, reply, came))

    def _wait(self, until_ns: int) -> None:
        """Until an instant; what comes meanwhile is nobody's reply any more."""
        while (left_ns := until_ns - self._clock_ns()) > 0:
            self._port.read(min(left_ns / NS_PER_S, TICK_S))


class DriveReplay:
    """Answers a master with what was answered to the same request, one after the other.

    When the recording has no more answers to a request, the last one is given again. `told` gets
    each request with what it was answered.
    """

    def __init__(
        self,
        traffic: Traffic,
        port: Port,
        told: Callable[[Exchange], None],
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._port = port
        self._told = told
        self._clock_ns = clock_ns
        self._begin_ns = clock_ns()
        self._splitter = FrameSplitter(LINE_PROTOCOLS[traffic.setting.protocol], "request")
        self._replies: dict[bytes, list[tuple[bytes | None, int]]] = {}
        for request, reply in exchanges(traffic):
            delay_ns = 0 if reply is None else max(0, reply.end_ns - request.end_ns)
            data = None if reply is None else reply.data
            self._replies.setdefault(request.data, []).append((data, delay_ns))

    def step(self) -> None:
        """Listen for a moment and answer. Raises DiagnosticError FB9031 if the port is gone."""
        data = self._port.read()
        now_ns = self._clock_ns()
        found = self._splitter.feed(data, now_ns) if data else self._splitter.end(now_ns)
        for frame in found:
            if frame.direction == "request":
                self._answer(frame)

    def _answer(self, frame: LineFrame) -> None:
        known = self._replies.get(frame.data, [])
        reply, delay_ns = (known.pop(0) if len(known) > 1 else known[0]) if known else (None, 0)
        rest = b""
        while (left_ns := frame.end_ns + delay_ns - self._clock_ns()) > 0 and reply is not None:
            rest += self._port.read(left_ns / NS_PER_S)
        if reply is not None:
            self._port.write(reply)
        self._told(Exchange(frame.end_ns - self._begin_ns, frame.data, reply, reply))
        for later in self._splitter.feed(rest, self._clock_ns()) if rest else ():
            if later.direction == "request":
                self._answer(later)
