"""The port towards one drive: one request at a time, and what became of it.

The PBDP-110 speaks to the common serial port of a drive (its manual, section 2), each at the speed
and parity of that drive. Inferred, because no document shows the telegrams: they are those of the
Toshiba binary protocol without INV-NO, which one drive alone on its line understands whatever its
number is (VF-S11 communications manual E6581222, page 11).
"""

from collections.abc import Callable
from typing import TypeAlias

from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import Command, ErrorReply, Reply, Request
from harness.kernel import Event, Kernel
from harness.line import Line, Reception, Role, SerialFormat

_REPLY_BYTES = 7
_REPLY_BITS = 12
"""The longest character of a drive: parity and two stop bits."""
_GAP_CHARACTERS = 3.5
"""Silence between two frames, as the VF-AS1 and VF-S15 want it (E6581315, page 5)."""

Answer: TypeAlias = Reply | ErrorReply | None
"""What came of a request: the drive's value, its refusal, or nothing within the time."""


class DriveLink:
    """The interface's end of the cable to one drive."""

    __slots__ = (
        "_done", "_event", "_kernel", "_processing_ns", "_request", "_timeout_ns", "port",
    )  # fmt: skip

    def __init__(
        self,
        kernel: Kernel,
        line: Line,
        format: SerialFormat,  # noqa: A002 - the field's term
        processing_ns: int,
        timeout_ns: int,
    ) -> None:
        self._kernel = kernel
        self._processing_ns = processing_ns
        self._timeout_ns = timeout_ns
        self._request: Request | None = None
        self._done: Callable[[Answer], None] | None = None
        self._event: Event | None = None
        self.port = line.attach(self, Role.MASTER, format)

    def ask(self, command: Command, number: int, data: int, done: Callable[[Answer], None]) -> None:
        """Send a request; `done` is called once, when it has been answered or the time is over."""
        assert self._request is None, "one request at a time"
        self._request = Request(None, command, number, data)
        self._done = done
        sent = self.port.transmit(toshiba_binary.encode_request(self._request))
        reply_ns = _REPLY_BYTES * _REPLY_BITS * 1_000_000_000 // self.port.format.baud
        due_ns = sent.end_ns + self._timeout_ns + reply_ns
        self._event = self._kernel.at(due_ns, lambda: self._finish(None))

    def stop(self) -> None:
        """Fall silent, in the middle of a telegram if need be; nobody is called any more."""
        self.port.abort()
        self._request = self._done = None
        if self._event is not None:
            self._kernel.cancel(self._event)
            self._event = None

    def receive(self, reception: Reception) -> None:
        """Something came from the drive. What is damaged or no answer to the request is dropped."""
        request = self._request
        if request is None or reception.marks is not None:
            return
        reply = toshiba_binary.parse_reply(reception.data)
        asked = (request.command, request.com_no)
        if isinstance(reply, ErrorReply) or (
            reply is not None and (reply.command, reply.com_no) == asked
        ):
            self._answered(reply)

    def _answered(self, reply: Reply | ErrorReply) -> None:
        if self._event is not None:
            self._kernel.cancel(self._event)
        self._request = None
        gap_ns = round(_GAP_CHARACTERS * self.port.format.duration_ns(1))
        delay_ns = max(self._processing_ns, gap_ns)
        self._event = self._kernel.after(delay_ns, lambda: self._finish(reply))

    def _finish(self, answer: Answer) -> None:
        done = self._done
        self._request = self._done = self._event = None
        if done is not None:
            done(answer)
