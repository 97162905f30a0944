"""Fragments: how messages longer than a CAN frame are cut, and put together again.

A fragment begins with a byte of its kind and number, in explicit messages behind the header. I/O
data are fragmented if the connection is for more than eight bytes; the fragments are sent one
behind the other. Those of explicit messages are acknowledged one by one.
"""

from collections.abc import Iterator
from enum import IntEnum

from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import FRAME_BYTES, Frame

COUNT = 0x3F
ONLY = 0x3F
"""The number of a first fragment behind which none follows."""
EXPLICIT_BYTES = FRAME_BYTES - 2
IO_BYTES = FRAME_BYTES - 1


class Kind(IntEnum):
    """The upper two bits."""

    FIRST = 0
    MIDDLE = 1
    LAST = 2
    ACKNOWLEDGE = 3


class AckStatus(IntEnum):
    """What the receiver says to a fragment."""

    SUCCESS = 0
    TOO_MUCH_DATA = 1


@dataclass(frozen=True, slots=True)
class Fragment:
    """A fragment, or the acknowledgement of one, whose data are one byte, the status."""

    kind: Kind
    number: int
    data: bytes = b""

    def encode(self) -> bytes:
        """The bytes on the wire, without the header of explicit messages."""
        return bytes([self.kind << 6 | self.number]) + self.data


def parse_fragment(data: bytes) -> Fragment | None:
    """A fragment, None for no byte at all."""
    return Fragment(Kind(data[0] >> 6), data[0] & COUNT, data[1:]) if data else None


def cut(data: bytes, size: int) -> Iterator[Fragment]:
    """Data as fragments of at most `size` bytes. At least one, and numbered round after 63."""
    pieces = [data[at : at + size] for at in range(0, len(data), size)] or [b""]
    if len(pieces) == 1:
        yield Fragment(Kind.FIRST, ONLY, pieces[0])
        return
    for number, piece in enumerate(pieces):
        last = number == len(pieces) - 1
        kind = Kind.FIRST if number == 0 else Kind.LAST if last else Kind.MIDDLE
        yield Fragment(kind, number & COUNT, piece)


def io_frames(identifier: int, data: bytes, size: int) -> Iterator[Frame]:
    """The frames of I/O data on a connection for `size` bytes: one, or fragments."""
    if size <= FRAME_BYTES:
        yield Frame(identifier, data)
        return
    for fragment in cut(data, IO_BYTES):
        yield Frame(identifier, fragment.encode())


class Reassembly:
    """Puts fragments together again; one that does not follow the one before spoils them all."""

    __slots__ = ("_data", "_limit", "_next")

    def __init__(self, limit: int) -> None:
        """`limit`: bytes that a message may have."""
        self._limit = limit
        self._data: bytearray | None = None
        self._next = 0

    @property
    def expecting(self) -> bool:
        """True while a message has begun and not ended."""
        return self._data is not None

    def reset(self) -> None:
        """Forget what has come."""
        self._data = None

    def too_long(self, fragment: Fragment) -> bool:
        """Whether the message would get longer than it may be with this fragment."""
        held = 0 if self._data is None or fragment.kind is Kind.FIRST else len(self._data)
        return held + len(fragment.data) > self._limit

    def add(self, fragment: Fragment) -> bytes | None:
        """The message if it is whole with this fragment; None as long as it is not."""
        if fragment.kind is Kind.ACKNOWLEDGE or self.too_long(fragment):
            self.reset()
            return None
        if fragment.kind is Kind.FIRST:
            if fragment.number == ONLY:
                self.reset()
                return fragment.data
            if fragment.number != 0:
                self.reset()
                return None
            self._data, self._next = bytearray(fragment.data), 1
            return None
        if self._data is None or fragment.number != self._next:
            self.reset()
            return None
        self._data += fragment.data
        self._next = (self._next + 1) & COUNT
        if fragment.kind is Kind.MIDDLE:
            return None
        data, self._data = bytes(self._data), None
        return data
