"""Frames out of what is heard on a line by somebody who does not take part.

Both directions may come mixed, as on two wires. What a frame is, is found out by its length, its
check sum and by what was asked before: a read request of the Toshiba protocol has two bytes fewer
than its reply, and a write request is the same as its reply. What answers the request before, and
comes soon enough, is its reply. What is no frame is kept as unknown bytes: up to the next silence,
or up to where a frame begins.
"""

from typing import Literal, NamedTuple

from fbgen.wire.line_protocols import LineProtocol, Way

Direction = Literal["request", "reply", "unknown"]

NS_PER_MS = 1_000_000
SILENCE_NS = 50 * NS_PER_MS
"""Longer than adapters hold the bytes of a frame back; no frame goes on after so long."""
REPLY_NS = 300 * NS_PER_MS
"""What could be both request and reply is a request after so long: the master asks again."""


class LineFrame(NamedTuple):
    """Bytes that belong together, and when the first and the last of them were heard."""

    direction: Direction
    data: bytes
    start_ns: int
    end_ns: int


class FrameSplitter:
    """Takes bytes with the time at which they were heard, and gives frames.

    `only` is the direction if only one of them can be heard.
    """

    __slots__ = ("_asked", "_asked_ns", "_junk", "_only", "_pending", "_protocol")

    def __init__(self, protocol: LineProtocol, only: Way | None = None) -> None:
        self._protocol = protocol
        self._only = only
        self._pending: list[tuple[int, int]] = []
        self._junk: list[tuple[int, int]] = []
        self._asked = b""
        self._asked_ns = 0

    @property
    def idle(self) -> bool:
        """True if nothing is waiting to become a frame."""
        return not self._pending and not self._junk

    def feed(self, data: bytes, now_ns: int) -> list[LineFrame]:
        """The frames that are complete with these bytes."""
        found: list[LineFrame] = []
        if self._pending and now_ns - self._pending[-1][1] > SILENCE_NS:
            found += self.flush()
        elif self._junk and now_ns - self._junk[-1][1] > SILENCE_NS:
            found += self._unknown()
        self._pending += [(byte, now_ns) for byte in data]
        return found + self._frames(over=False)

    def flush(self) -> list[LineFrame]:
        """What is left when nothing more comes: frames if there are some, unknown bytes."""
        return self._frames(over=True) + self._unknown()

    def end(self, now_ns: int) -> list[LineFrame]:
        """The same, if it has been silent for long enough."""
        last = (self._pending or self._junk)[-1:]
        return self.flush() if last and now_ns - last[0][1] > SILENCE_NS else []

    def _frames(self, *, over: bool) -> list[LineFrame]:
        found: list[LineFrame] = []
        while self._pending:
            begin = bytes(byte for byte, _ in self._pending)
            way, length = self._fitting(begin, over)
            if way is not None:
                found += self._unknown()
                found.append(self._taken(way, begin[:length]))
            elif length:
                break
            else:
                self._junk.append(self._pending.pop(0))
        return found

    def _fitting(self, begin: bytes, over: bool) -> tuple[Way | None, int]:
        """The direction and length of the frame that is there; None and 1 if one may come yet."""
        may_come = 0
        for way in self._ways():
            length = self._protocol.length(way, begin)
            if length == 0:
                continue
            if length is None or length > len(begin):
                if not over:
                    may_come = 1
                    if way == "reply" and self._asked:
                        break
                continue
            frame = begin[:length]
            if self._protocol.is_right(way, frame) and self._fits(way, frame):
                return way, length
        return None, may_come

    def _ways(self) -> tuple[Way, ...]:
        if self._only is not None:
            return (self._only,)
        if self._asked and self._pending[0][1] - self._asked_ns > REPLY_NS:
            self._asked = b""
        return ("reply", "request") if self._asked else ("request", "reply")

    def _fits(self, way: Way, frame: bytes) -> bool:
        if way == "request" or self._only is not None or not self._asked:
            return True
        return self._protocol.answers(self._asked, frame)

    def _taken(self, way: Way, frame: bytes) -> LineFrame:
        times = [time_ns for _, time_ns in self._pending[: len(frame)]]
        del self._pending[: len(frame)]
        is_open = way == "request" and self._protocol.is_answered(frame)
        self._asked, self._asked_ns = (frame if is_open else b""), times[-1]
        return LineFrame(way, frame, times[0], times[-1])

    def _unknown(self) -> list[LineFrame]:
        if not self._junk:
            return []
        data = bytes(byte for byte, _ in self._junk)
        frame = LineFrame("unknown", data, self._junk[0][1], self._junk[-1][1])
        self._junk.clear()
        return [frame]
