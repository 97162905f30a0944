"""Finding Toshiba frames in what comes over a line, by the rules of the VF-S11.

Rules (VF-S11 communications manual E6581222, pp. 6-7; VF-AS1 RS485 manual E6581315, pp. 6, 20):
the start code decides frame by frame between ASCII and binary; bytes before it are dropped; a
binary frame ends by the number of bytes that its CMD has, an ASCII frame with CR; a frame that is
not complete within 0.5 s, has a byte with a parity or framing error, or a wrong form leads back to
waiting for a start code, in silence.

Inferred: where what was taken for a frame turns out to be none at its CMD, or at a byte that cannot
stand in ASCII, the search goes on with the bytes behind its start code. So of several 2FH the last
is valid, as the manual says, and yet a drive with number 2FH can be reached, and a 2FH among the
data of a frame in progress means nothing.
"""

from collections.abc import Callable, Mapping
from typing import Generic, TypeVar

from fbgen.wire import toshiba_ascii, toshiba_binary
from fbgen.wire.toshiba import (
    ASCII_START,
    BINARY_START,
    BadRequest,
    ErrorReply,
    Reply,
    Request,
)

Message = TypeVar("Message")

_START_CODES = (BINARY_START, ASCII_START)
FRAME_TIMEOUT_NS = 500_000_000


class FrameStream(Generic[Message]):
    """Takes bytes with their times and gives the messages in them. Its state is two plain fields.

    `pending` holds the bytes of a frame in progress, `started_ns` the time of its start code.
    """

    __slots__ = ("_parse_ascii", "_parse_binary", "_tails", "_timeout_ns", "pending", "started_ns")

    def __init__(
        self,
        tails: Mapping[int, int],
        parse_binary: Callable[[bytes], Message | None],
        parse_ascii: Callable[[bytes], Message | None],
        timeout_ns: int = FRAME_TIMEOUT_NS,
    ) -> None:
        self._tails = tails
        self._parse_binary = parse_binary
        self._parse_ascii = parse_ascii
        self._timeout_ns = timeout_ns
        self.pending = bytearray()
        self.started_ns = 0

    def whole(self, data: bytes) -> Message | None:
        """The message, if no frame is in progress and these clean bytes are exactly one frame.

        The short way for what comes nearly always: whoever gets None calls `feed`.
        """
        if self.pending:
            return None
        return self._parse_binary(data) or self._parse_ascii(data)

    def feed(
        self, data: bytes, start_ns: int, byte_ns: int, marks: bytes | None = None
    ) -> tuple[Message, ...]:
        """The messages that are complete with these bytes.

        Byte i arrives at `start_ns` + (i + 1) x `byte_ns`. A byte whose mark is not 0 came with a
        parity, framing or overrun error.
        """
        if marks is None and (whole := self.whole(data)) is not None:
            return (whole,)
        found: list[Message] = []
        for index, byte in enumerate(data):
            now_ns = start_ns + (index + 1) * byte_ns
            if self.pending and now_ns - self.started_ns > self._timeout_ns:
                self.pending.clear()
            if marks is not None and marks[index]:
                self.pending.clear()
                continue
            if not self.pending:
                if byte not in _START_CODES:
                    continue
                self.started_ns = now_ns
            self.pending.append(byte)
            message = self._advance(now_ns)
            if message is not None:
                found.append(message)
        return tuple(found)

    def reset(self) -> None:
        """Back to waiting for a start code, as after power-on."""
        self.pending.clear()

    def _advance(self, now_ns: int) -> Message | None:
        pending = self.pending
        while pending:
            if pending[0] == ASCII_START:
                if pending[-1] == toshiba_ascii.CARRIAGE_RETURN:
                    return self._take(self._parse_ascii)
                if len(pending) == 1 or self._may_go_on():
                    return None
            else:
                length = toshiba_binary.frame_length(pending, self._tails)
                if length is None or length > len(pending):
                    return None
                if length:
                    return self._take(self._parse_binary)
            self._search_again(now_ns)
        return None

    def _may_go_on(self) -> bool:
        return (
            self.pending[-1] in toshiba_ascii.INNER_BYTES
            and len(self.pending) < toshiba_ascii.LONGEST_FRAME
        )

    def _take(self, parse: Callable[[bytes], Message | None]) -> Message | None:
        frame = bytes(self.pending)
        self.pending.clear()
        return parse(frame)

    def _search_again(self, now_ns: int) -> None:
        """Drop the start code that led nowhere and all bytes up to the next one."""
        starts = (at for at in range(1, len(self.pending)) if self.pending[at] in _START_CODES)
        del self.pending[: next(starts, len(self.pending))]
        self.started_ns = now_ns


def request_stream() -> FrameStream[Request | BadRequest]:
    """What a drive listens with."""
    return FrameStream[Request | BadRequest](
        toshiba_binary.REQUEST_TAILS, toshiba_binary.parse_request, toshiba_ascii.parse_request
    )


def reply_stream() -> FrameStream[Reply | ErrorReply]:
    """What a master listens with that talks to drives directly."""
    return FrameStream[Reply | ErrorReply](
        toshiba_binary.REPLY_TAILS, toshiba_binary.parse_reply, toshiba_ascii.parse_reply
    )
