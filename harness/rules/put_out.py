"""Which telegram on the line belongs to what the PLC has put out.

A gateway sends when it sees another trigger than before. It sends something once more if it has
forgotten the trigger meanwhile: its supply was away, or zeros came while the master was in CLEAR.
"""

from collections import deque
from enum import Enum

from fbgen.dataclass import dataclass

_KEPT = 16


class Sending(Enum):
    """Whether the PLC wanted a telegram on the line.

    NEW: the first one for its trigger. RESENT: once more, as the gateway has forgotten that it had
    sent it. REPEATED: once more for no reason. FOREIGN: the PLC has never put it out like that.
    """

    NEW = "new"
    RESENT = "resent"
    REPEATED = "repeated"
    FOREIGN = "foreign"


@dataclass(slots=True)
class PutOut:
    """The telegrams that stood in the PLC's frame with one trigger, the first one first.

    `is_first` tells that the PLC did not take the gateway as there when it put it out. `forgets` is
    how often the gateway may have forgotten since then what it had sent.
    """

    put_ns: int
    telegrams: list[bytes]
    is_first: bool
    forgets: int
    is_sent: bool = False


class PutOuts:
    """What a PLC has put out to one gateway lately. `processing_ns` is the least time from the
    trigger to the line."""

    def __init__(self, processing_ns: int) -> None:
        self._processing_ns = processing_ns
        self._kept: deque[PutOut] = deque(maxlen=_KEPT)
        self._forgotten = 0

    def new_trigger(self, now_ns: int, telegram: bytes, *, is_first: bool) -> None:
        """The frame has another trigger."""
        self._kept.append(PutOut(now_ns, [telegram], is_first, self._forgotten))

    def stands(self, telegram: bytes) -> None:
        """This stands in the frame now, with the trigger as it was."""
        if self._kept and self._kept[-1].telegrams[-1] != telegram:
            self._kept[-1].telegrams.append(telegram)

    def forgets(self) -> None:
        """The gateway may have forgotten what it had sent."""
        self._forgotten += 1
        for put in self._kept:
            put.forgets += 1

    def on_line(self, telegram: bytes, start_ns: int) -> tuple[Sending, PutOut | None]:
        """A telegram goes over the line: what it is, and what it belongs to."""
        found = self._found(telegram, start_ns)
        self._forgotten = 0
        return found

    def _found(self, telegram: bytes, start_ns: int) -> tuple[Sending, PutOut | None]:
        fitting = [put for put in self._kept if telegram in put.telegrams]
        before = next((put for put in fitting if put.is_sent), None)
        new = next((put for put in fitting if not put.is_sent and start_ns >= put.put_ns), None)
        too_early = new is None or start_ns < new.put_ns + self._processing_ns
        if before is not None and before.forgets and too_early:
            before.forgets -= 1
            return Sending.RESENT, before
        if new is None:
            return Sending.FOREIGN if before is None else Sending.REPEATED, before
        new.is_sent = True
        while self._kept[0] is not new:
            self._kept.popleft()
        return Sending.NEW, new
