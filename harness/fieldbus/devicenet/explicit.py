"""Explicit messages at one end: single frames, or fragments that are acknowledged one by one.

Both ends do the same: a message goes out whole or piece by piece, waiting for the acknowledgement
of each; what comes is put together and acknowledged. A fragment that nobody acknowledges is sent
once more.
"""

from collections.abc import Callable

from fbgen.wire.devicenet import FRAME_BYTES, Frame
from fbgen.wire.devicenet_fragments import (
    EXPLICIT_BYTES,
    AckStatus,
    Fragment,
    Kind,
    Reassembly,
    cut,
    parse_fragment,
)
from fbgen.wire.devicenet_messages import Header, parse_header
from harness.kernel import Event, Kernel

_TRIES = 2


class ExplicitEnd:
    """Sends and takes the bodies of explicit messages.

    `identifier` is that of its own frames. `take` gets the header of a whole message, and its body.
    `send` puts a frame on the bus.
    """

    __slots__ = (
        "_acknowledged",
        "_header",
        "_identifier",
        "_kernel",
        "_pieces",
        "_reassembly",
        "_send",
        "_take",
        "_timeout_ns",
        "_timer",
        "_tries",
    )

    def __init__(
        self,
        kernel: Kernel,
        identifier: int,
        send: Callable[[Frame], None],
        take: Callable[[Header, bytes], None],
        *,
        limit: int,
        timeout_ns: int,
    ) -> None:
        self._kernel = kernel
        self._identifier = identifier
        self._timeout_ns = timeout_ns
        self._send = send
        self._take = take
        self._reassembly = Reassembly(limit)
        self._pieces: list[Fragment] = []
        self._header = Header(0)
        self._tries = 0
        self._timer: Event | None = None
        self._acknowledged: Fragment | None = None

    def reset(self) -> None:
        """Forget what was under way."""
        self._reassembly.reset()
        self._abandon()
        self._acknowledged = None

    def send(self, header: Header, body: bytes) -> None:
        """Send a message; one that is under way is given up."""
        self._abandon()
        if len(body) < FRAME_BYTES:
            self._put(Header(header.mac, header.xid), body)
            return
        self._header = Header(header.mac, header.xid, fragment=True)
        self._pieces = list(cut(body, EXPLICIT_BYTES))
        self._tries = 0
        self._put_piece()

    def receive(self, data: bytes) -> None:
        """Take a frame of the other end. One without a byte says nothing."""
        if not data:
            return
        header = parse_header(data[0])
        if not header.fragment:
            self._reassembly.reset()
            self._acknowledged = None
            self._take(header, data[1:])
            return
        fragment = parse_fragment(data[1:])
        if fragment is None:
            return
        if fragment.kind is Kind.ACKNOWLEDGE:
            self._acknowledge(fragment)
        else:
            self._fragment(header, fragment)

    def _fragment(self, header: Header, fragment: Fragment) -> None:
        if self._acknowledged == fragment:
            self._answer(header, fragment, AckStatus.SUCCESS)  # its acknowledgement was lost
            return
        if self._reassembly.too_long(fragment):
            self._reassembly.reset()
            self._answer(header, fragment, AckStatus.TOO_MUCH_DATA)
            return
        whole = self._reassembly.add(fragment)
        if whole is None and not self._reassembly.expecting:
            self._acknowledged = None
            return  # out of its row: nobody acknowledges that
        self._acknowledged = fragment
        self._answer(header, fragment, AckStatus.SUCCESS)
        if whole is not None:
            self._take(Header(header.mac, header.xid), whole)

    def _answer(self, header: Header, fragment: Fragment, status: AckStatus) -> None:
        answer = Fragment(Kind.ACKNOWLEDGE, fragment.number, bytes([status]))
        self._put(header, answer.encode())

    def _acknowledge(self, fragment: Fragment) -> None:
        if not self._pieces or fragment.number != self._pieces[0].number:
            return
        if fragment.data[:1] != bytes([AckStatus.SUCCESS]):
            self._abandon()
            return
        self._stop()
        del self._pieces[0]
        self._tries = 0
        if self._pieces:
            self._put_piece()

    def _put_piece(self) -> None:
        self._tries += 1
        self._put(self._header, self._pieces[0].encode())
        self._timer = self._kernel.after(self._timeout_ns, self._late)

    def _late(self) -> None:
        self._timer = None
        if self._tries < _TRIES:
            self._put_piece()
        else:
            self._pieces = []

    def _abandon(self) -> None:
        self._pieces = []
        self._stop()

    def _stop(self) -> None:
        if self._timer is not None:
            self._kernel.cancel(self._timer)
            self._timer = None

    def _put(self, header: Header, rest: bytes) -> None:
        self._send(Frame(self._identifier, bytes([header.byte]) + rest))
