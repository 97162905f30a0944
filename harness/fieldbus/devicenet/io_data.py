"""I/O data of a connection from its frames: one, or fragments if it is for more than 8 bytes."""

from fbgen.wire.devicenet import FRAME_BYTES
from fbgen.wire.devicenet_fragments import Reassembly, parse_fragment

_LONGEST = 512
"""Bytes that are put together before their length is looked at."""


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
