"""Finding Toshiba frames in what comes over a line.

`FrameStream` goes by the rules of the VF-S11 (VF-S11 communications manual E6581222, pp. 6-7;
VF-AS1 RS485 manual E6581315, pp. 6, 20): the start code decides frame by frame between ASCII and
binary; bytes before it are dropped; a binary frame ends by the number of bytes that its CMD has, an
ASCII frame with CR; a frame that is not complete within 0.5 s (block X 1 s, pp. 7, 17), has a byte
with a parity or framing error, or a wrong form leads back to waiting for a start code, in silence.

Inferred: where what was taken for a frame turns out to be none at its CMD, or at a byte that cannot
stand in ASCII, the search goes on with the bytes behind its start code. So of several 2FH the last
is valid, as the manual says, and yet a drive with number 2FH can be reached, and a 2FH among the
data of a frame in progress means nothing.

VF-AS1 and VF-S15 take what stands between two silences of 3.5 characters for a frame, in ASCII too
(VF-AS1 RS485 manual E6581315, pp. 5-11; VF-S15 RS485 manual E6581913, pp. 5-8): `SilenceStream`.
Their manuals say nothing of silence inside a frame, so a shorter one changes nothing (inferred).
"""

from collections.abc import Callable
from functools import partial
from typing import Generic, TypeVar

from fbgen.wire import toshiba_ascii, toshiba_binary, toshiba_block
from fbgen.wire.silence import SilenceStream, SilentIntervals, characters_ns
from fbgen.wire.toshiba import (
    ASCII_START,
    BINARY_START,
    BadRequest,
    ErrorReply,
    Reply,
    Request,
)
from fbgen.wire.toshiba_block import BlockReply, BlockRequest

Message = TypeVar("Message")

_START_CODES = (BINARY_START, ASCII_START)
FRAME_TIMEOUT_NS = 500_000_000
BLOCK_TIMEOUT_NS = 1_000_000_000
"""Time for a block request X (VF-S11 communications manual E6581222, p. 17)."""

SILENT_CHARACTERS = 3.5
_Length = Callable[[bytes | bytearray], int | None]


class FrameStream(Generic[Message]):
    """Takes bytes with their times and gives the messages in them. Its state is two plain fields.

    `pending` holds the bytes of a frame in progress, `started_ns` the time of its start code.
    """

    __slots__ = ("_length", "_parse_ascii", "_parse_binary", "_timeout_ns", "pending", "started_ns")

    def __init__(
        self,
        length: _Length,
        parse_binary: Callable[[bytes], Message | None],
        parse_ascii: Callable[[bytes], Message | None],
        timeout_ns: int = FRAME_TIMEOUT_NS,
    ) -> None:
        self._length = length
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
                self._give_up(now_ns)
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
                length = self._length(pending)
                if length is None or length > len(pending):
                    return None
                if length:
                    return self._take(self._parse_binary)
            self._search_again(now_ns)
        return None

    def _give_up(self, now_ns: int) -> None:
        longer = toshiba_block.is_request(self.pending)
        if not longer or now_ns - self.started_ns > BLOCK_TIMEOUT_NS:
            self.pending.clear()

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


_REQUEST_LENGTH = partial(toshiba_binary.frame_length, tails=toshiba_binary.REQUEST_TAILS)
_REPLY_LENGTH = partial(toshiba_binary.frame_length, tails=toshiba_binary.REPLY_TAILS)


def request_stream(timeout_ns: int = FRAME_TIMEOUT_NS) -> FrameStream[Request | BadRequest]:
    """What a drive listens with that knows no blocks: to it X is an unknown command."""
    return FrameStream[Request | BadRequest](
        _REQUEST_LENGTH, toshiba_binary.parse_request, toshiba_ascii.parse_request, timeout_ns
    )


def reply_stream() -> FrameStream[Reply | ErrorReply]:
    """What a master listens with that talks to drives directly and asks for no blocks."""
    return FrameStream[Reply | ErrorReply](
        _REPLY_LENGTH, toshiba_binary.parse_reply, toshiba_ascii.parse_reply
    )


def block_request_stream(
    timeout_ns: int = FRAME_TIMEOUT_NS,
) -> FrameStream[Request | BadRequest | BlockRequest]:
    """What a drive listens with that knows blocks."""
    return FrameStream[Request | BadRequest | BlockRequest](
        toshiba_block.request_length,
        toshiba_block.parse_request,
        toshiba_ascii.parse_request,
        timeout_ns,
    )


def block_reply_stream() -> FrameStream[Reply | ErrorReply | BlockReply]:
    """What a master listens with that asks for blocks."""
    return FrameStream[Reply | ErrorReply | BlockReply](
        toshiba_block.reply_length, toshiba_block.parse_reply, toshiba_ascii.parse_reply
    )


def silent_intervals(baud: int, characters: float = SILENT_CHARACTERS) -> SilentIntervals:
    """3.5 characters at any speed: about 4, 2 and 1 ms at 9600, 19200 and 38400 bit/s."""
    silence_ns = characters_ns(characters, baud)
    return SilentIntervals(silence_ns, silence_ns)


def silence_request_stream(
    intervals: SilentIntervals,
) -> SilenceStream[Request | BadRequest | BlockRequest]:
    """What a VF-AS1 or VF-S15 listens with."""
    return SilenceStream[Request | BadRequest | BlockRequest](
        parse_request, intervals, toshiba_ascii.LONGEST_FRAME
    )


def silence_reply_stream(
    intervals: SilentIntervals,
) -> SilenceStream[Reply | ErrorReply | BlockReply]:
    """What a master of VF-AS1 and VF-S15 listens with."""
    return SilenceStream[Reply | ErrorReply | BlockReply](
        parse_reply, intervals, toshiba_ascii.LONGEST_FRAME
    )


def parse_request(frame: bytes) -> Request | BadRequest | BlockRequest | None:
    """What a request in either form says, blocks too; None if these bytes are not exactly one."""
    return toshiba_block.parse_request(frame) or toshiba_ascii.parse_request(frame)


def parse_reply(frame: bytes) -> Reply | ErrorReply | BlockReply | None:
    """What a reply in either form says, blocks too; None if these bytes are not exactly one."""
    return toshiba_block.parse_reply(frame) or toshiba_ascii.parse_reply(frame)
