"""How a port finds telegrams in what comes over the line: by their length, or by silence.

Facts: `fbgen.wire.toshiba_stream` and `fbgen.wire.silence`. Inferred: as the line is half duplex,
what begins while the inverter still owes a reply or sends one is not heard; where silence counts,
the rest of it is not understood either.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Generic, TypeVar

from fbgen.wire.silence import SilenceStream
from fbgen.wire.toshiba import BadRequest, Request
from fbgen.wire.toshiba_block import BlockRequest
from fbgen.wire.toshiba_stream import FrameStream
from harness.kernel import Event
from harness.line import Reception

if TYPE_CHECKING:
    from harness.drives.communication import Communication

Message = TypeVar("Message")
Telegram = Request | BadRequest | BlockRequest

_SINGLE = range(100)
"""Numbers that mean one inverter."""
_BEHIND_RECEPTIONS = 1


class LengthEar:
    """Toshiba telegrams that end with the bytes that their command wants, or with CR."""

    __slots__ = ("_port", "_stream", "_take")

    def __init__(
        self,
        port: "Communication",
        stream: FrameStream[Request | BadRequest] | FrameStream[Telegram],
        take: Callable[[Telegram, int], None],
    ) -> None:
        self._port = port
        self._stream = stream
        self._take = take

    def receive(self, reception: Reception) -> None:
        """Hear what has ended on the line."""
        port = self._port
        if reception.start_ns < port.deaf_until_ns:
            return
        data, marks = reception.data, reception.marks
        if marks is None and (whole := self._stream.whole(data)) is not None:
            if whole.address == port.inv_no or whole.address not in _SINGLE:
                self._take(whole, reception.end_ns)
            return
        for message in self._stream.feed(data, reception.start_ns, reception.byte_ns, marks):
            self._take(message, reception.end_ns)
            if reception.end_ns < port.deaf_until_ns:
                self._stream.reset()
                return

    def reset(self) -> None:
        """Forget what was heard of a telegram."""
        self._stream.reset()


class SilenceEar(Generic[Message]):
    """Telegrams that stand between two silences.

    A telegram is over only when the silence behind it is, unless somebody is sending again by then.
    `concerns` says by the first bytes whether it can be for this inverter: for others, which are
    most on a line with many, no instant is waited for.
    """

    __slots__ = ("_concerns", "_kernel", "_pair", "_port", "_stream", "_take", "_timer")

    def __init__(
        self,
        port: "Communication",
        stream: SilenceStream[Message],
        concerns: Callable[[bytes], bool],
        take: Callable[[Message, int], None],
    ) -> None:
        self._kernel = port.kernel
        self._pair = port.hears
        self._port = port
        self._stream = stream
        self._concerns = concerns
        self._take = take
        self._timer: Event | None = None

    def receive(self, reception: Reception) -> None:
        """Hear what has ended on the line."""
        stream, port = self._stream, self._port
        if reception.start_ns < port.deaf_until_ns:
            stream.reset(reception.end_ns)
            return
        if self._timer is not None:
            self._kernel.cancel(self._timer)
            self._timer = None
        if reception.positions is None:
            self._feed(reception.data, reception.start_ns, reception.byte_ns, reception.marks)
        else:
            self._feed_with_gaps(reception)
        if reception.end_ns < port.deaf_until_ns:
            stream.reset(reception.end_ns)
        elif stream.pending:
            if not self._concerns(stream.pending):
                stream.skip()
                return
            ends_ns = stream.ends_ns
            assert ends_ns is not None, "there are bytes pending"
            self._timer = self._kernel.at(ends_ns, self._end, _BEHIND_RECEPTIONS)

    def reset(self) -> None:
        """Forget what was heard of a telegram; what is on its way is not understood."""
        if self._timer is not None:
            self._kernel.cancel(self._timer)
            self._timer = None
        self._stream.reset(self._kernel.now_ns)

    def _feed_with_gaps(self, reception: Reception) -> None:
        """Byte by byte: where some were lost there was silence."""
        byte_ns, marks = reception.byte_ns, reception.marks
        for index, byte in enumerate(reception.data):
            start_ns = reception.byte_end_ns(index) - byte_ns
            mark = None if marks is None else marks[index : index + 1]
            self._feed(bytes((byte,)), start_ns, byte_ns, mark)

    def _feed(self, data: bytes, start_ns: int, byte_ns: int, marks: bytes | None) -> None:
        stream = self._stream
        heard_ns = stream.heard_ns
        for message in stream.feed(data, start_ns, byte_ns, marks):
            self._take(message, heard_ns)

    def _end(self) -> None:
        """The silence is over, unless a character has begun before that."""
        stream = self._stream
        ends_ns = stream.ends_ns
        sending_until_ns = None if ends_ns is None else self._pair.sending_until_ns(ends_ns)
        if sending_until_ns is not None:
            self._timer = self._kernel.at(sending_until_ns, self._end, _BEHIND_RECEPTIONS)
            return
        self._timer = None
        for message in stream.end(self._kernel.now_ns):
            self._take(message, stream.heard_ns)
