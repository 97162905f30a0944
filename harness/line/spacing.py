"""Whether the telegrams of a gateway to different drives lie far enough apart.

The gateway's manual asks for at least the reply time between telegrams to different drives of a
line, but for S and s, which nobody answers: otherwise two drives may send at once. Nor does anybody
answer the zeros that go out when the master is in CLEAR. Source: TOSPBDP001 manual v1.1, 9. A
broadcast counts as a telegram to drive 00, which answers it; one that follows a telegram to a drive
is not asked to wait: only the emergency stop is one.
"""

from collections.abc import Mapping
from typing import NamedTuple

from fbgen.wire.toshiba import BROADCAST, Command
from harness.line.medium import Line, Port
from harness.line.transmission import Transmission

_START = 0x2F
_SHORTEST = 5
_ANSWERED = (Command.R, Command.G, Command.W, Command.P)


class TooClose(NamedTuple):
    """Two telegrams: when the second one began, to whom they went, and what lay between them."""

    time_ns: int
    before: int
    inv_no: int
    distance_ns: int


class Spacing:
    """Listens to what one port sends. `reply_ns` are the reply times by INV-NO."""

    __slots__ = ("_before", "_port", "_reply_ns", "_start_ns", "too_close")

    def __init__(self, line: Line, port: Port, reply_ns: Mapping[int, int]) -> None:
        self._port = port
        self._reply_ns = reply_ns
        self._before: int | None = None
        self._start_ns = 0
        self.too_close: list[TooClose] = []
        line.taps.append(self._listen)

    def _listen(self, transmission: Transmission) -> None:
        data = transmission.data
        if transmission.sender is not self._port or len(data) < _SHORTEST or data[0] != _START:
            return
        inv_no, command, start_ns = data[1], data[2], transmission.start_ns
        if command not in _ANSWERED or not (inv_no == BROADCAST or inv_no in self._reply_ns):
            return
        before, self._before = self._before, 0 if inv_no == BROADCAST else inv_no
        distance_ns, self._start_ns = start_ns - self._start_ns, start_ns
        if before is None or inv_no in (before, BROADCAST):
            return
        if distance_ns < self._reply_ns.get(before, 0):
            self.too_close.append(TooClose(start_ns, before, inv_no, distance_ns))
