"""Finding frames by the silence around them, with the times of the simulation or of a port.

Both protocols of the inverters use it: MODBUS-RTU everywhere, and the Toshiba protocol of VF-AS1
and VF-S15, where 3.5 characters of silence stand before and behind each frame (VF-AS1 RS485 manual
E6581315, pp. 5-11; VF-S15 RS485 manual E6581913, pp. 5-8). The VF-S11 goes by start code and number
of bytes instead: `toshiba_stream.FrameStream`.
"""

from collections.abc import Callable
from typing import Generic, NamedTuple, TypeVar

Message = TypeVar("Message")

CHARACTER_BITS = 11
"""Start bit, eight data bits, parity and stop bit, or two stop bits without parity."""

_NS_PER_S = 1_000_000_000
_NEVER = -(1 << 62)


class SilentIntervals(NamedTuple):
    """`frame_ns` of silence and more end a frame; more than `inside_ns` in a frame spoil it.

    Where a protocol has no rule for silence inside a frame, both are the same.
    """

    frame_ns: int
    inside_ns: int


def characters_ns(count: float, baud: int, bits: int = CHARACTER_BITS) -> int:
    """Time of so many characters of `bits` bits, to the nearest nanosecond."""
    return round(count * bits * _NS_PER_S / baud)


class SilenceStream(Generic[Message]):
    """Takes bytes with their times; what stands between two silences is a frame or nothing.

    A frame is known to be over only when the silence behind it is. So its message comes from `end`,
    which wants to be called at `ends_ns`, or else from the next `feed`. Who sees in `pending` that
    a frame is for somebody else calls `skip` and need not wait for its end.

    `heard_ns` is the end of the last byte. A byte with an error, a silence inside that is too long,
    and more bytes than `longest` spoil a frame: everything up to the next silence is dropped.
    """

    __slots__ = ("_intervals", "_longest", "_parse", "_spoiled", "heard_ns", "pending")

    def __init__(
        self, parse: Callable[[bytes], Message | None], intervals: SilentIntervals, longest: int
    ) -> None:
        self._parse = parse
        self._intervals = intervals
        self._longest = longest
        self.heard_ns = _NEVER
        self._spoiled = False
        self.pending = b""

    @property
    def ends_ns(self) -> int | None:
        """When the frame in progress is over, if nothing follows; None if there is none."""
        return self.heard_ns + self._intervals.frame_ns if self.pending else None

    def feed(
        self, data: bytes, start_ns: int, byte_ns: int, marks: bytes | None = None
    ) -> tuple[Message, ...]:
        """The message that the silence before these bytes has ended, if there is one.

        Byte i is on the line from `start_ns` + i x `byte_ns` on. A byte whose mark is not 0 came
        with a parity, framing or overrun error.
        """
        if not data:
            return ()
        silence_ns = start_ns - self.heard_ns
        done: tuple[Message, ...] = ()
        if silence_ns >= self._intervals.frame_ns:
            done = self._take()
        elif silence_ns > self._intervals.inside_ns and self.pending:
            self._spoil()
        self.heard_ns = start_ns + len(data) * byte_ns
        if marks is not None and any(marks):
            self._spoil()
        elif not self._spoiled:
            self.pending += data
            if len(self.pending) > self._longest:
                self._spoil()
        return done

    def end(self, now_ns: int) -> tuple[Message, ...]:
        """The message whose frame is over at this instant, if there is one."""
        return self._take() if now_ns - self.heard_ns >= self._intervals.frame_ns else ()

    def reset(self, now_ns: int) -> None:
        """Begin anew, as after power-on: a frame that is on its way now is not understood.

        MODBUS over Serial Line V1.02, section 2.5.1.1: from its initial state a receiver gets to
        idle by a whole silent interval.
        """
        self._spoil()
        self.heard_ns = now_ns

    def skip(self) -> None:
        """The frame in progress is for somebody else: nobody wants to know what it says."""
        self._spoil()

    def _spoil(self) -> None:
        self.pending, self._spoiled = b"", True

    def _take(self) -> tuple[Message, ...]:
        frame, self.pending, self._spoiled = self.pending, b"", False
        message = self._parse(frame) if frame else None
        return () if message is None else (message,)
