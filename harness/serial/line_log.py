"""What was said on a line that is served: the last frames, and how many there were."""

from collections import deque
from collections.abc import Callable
from typing import NamedTuple

from fbgen.wire.line_frames import Direction, FrameSplitter, LineFrame
from fbgen.wire.line_protocols import LineProtocol
from harness.kernel import Kernel
from harness.line import Line, Port, Transmission

KEPT = 100
"""How many frames are remembered."""


class HeardFrame(NamedTuple):
    """A frame with the time of its end on the virtual clock; `drive` is who sent a reply."""

    time_ns: int
    direction: Direction
    data: bytes
    drive: str


class LineLog:
    """Listens to a line. `requests`, `replies` and `unknown` count frames since the beginning.

    `answered` counts the replies of each drive by its name. `told` gets each frame.
    """

    def __init__(self, kernel: Kernel, line: Line, protocol: LineProtocol, master: Port) -> None:
        self._kernel = kernel
        self._master = master
        self._asking = FrameSplitter(protocol, "request")
        self._answering = FrameSplitter(protocol, "reply")
        self._senders: dict[int, str] = {}
        self.frames: deque[HeardFrame] = deque(maxlen=KEPT)
        self.requests = self.replies = self.unknown = 0
        self.answered: dict[str, int] = {}
        self.told: list[Callable[[HeardFrame], None]] = []
        line.taps.append(self._listen)

    def add(self, drive: str, port: Port) -> None:
        """What this port sends are replies of this drive."""
        self._senders[id(port)] = drive
        self.answered[drive] = 0

    def look(self) -> None:
        """Give up what has not become a frame for long."""
        now_ns = self._kernel.now_ns
        self._note(self._asking.end(now_ns), "")
        self._note(self._answering.end(now_ns), "")

    def _listen(self, transmission: Transmission) -> None:
        heard = transmission.heard
        if heard is None or not heard.data:
            return
        if transmission.sender is self._master:
            self._note(self._asking.feed(heard.data, heard.end_ns), "")
            return
        drive = self._senders.get(id(transmission.sender), "")
        self._note(self._answering.feed(heard.data, heard.end_ns), drive)

    def _note(self, found: list[LineFrame], drive: str) -> None:
        for frame in found:
            kept = HeardFrame(frame.end_ns, frame.direction, frame.data, drive)
            self.frames.append(kept)
            if frame.direction == "request":
                self.requests += 1
            elif frame.direction == "reply":
                self.replies += 1
                self.answered[drive] = self.answered.get(drive, 0) + bool(drive)
            else:
                self.unknown += 1
            for told in self.told:
                told(kept)
