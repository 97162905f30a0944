"""I/O data of a connection as frames: one, or fragments where the connection is for more than 8."""

from collections.abc import Iterator

from fbgen.wire.devicenet import FRAME_BYTES, Frame
from fbgen.wire.devicenet_fragments import IO_BYTES, Reassembly, cut, parse_fragment

_LONGEST = 512
"""Bytes that are put together before their length is looked at."""


def io_frames(identifier: int, data: bytes, size: int) -> Iterator[Frame]:
    """The frames of a message on a connection for `size` bytes."""
    if size <= FRAME_BYTES:
        yield Frame(identifier, data)
        return
    for fragment in cut(data, IO_BYTES):
        yield Frame(identifier, fragment.encode())


class IoReader:
    """Gives the data of whole messages that come on a connection for `size` bytes."""

    __slots__ = ("_reassembly", "_size")

    def __init__(self, size: int) -> None:
        self._size = size
        self._reassembly = Reassembly(_LONGEST)

    def feed(self, data: bytes) -> bytes | None:
        """The message if it is whole with this frame."""
        if self._size <= FRAME_BYTES:
            return data
        fragment = parse_fragment(data)
        return b"" if fragment is None else self._reassembly.add(fragment)
