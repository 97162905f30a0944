"""How long MODBUS-RTU frames are: by their first bytes, and a reply by its request.

A master that knows when a reply is whole need not wait for the silence behind it.
"""

from collections.abc import Callable, Mapping

from fbgen.wire.modbus import (
    BROADCAST,
    EXCEPTION_BIT,
    IdentifyRequest,
    ReadRequest,
    ReadWriteRequest,
    Request,
    WriteRequest,
    WriteSeveralRequest,
)
from fbgen.wire.modbus_layout import CRC_BYTES, IDENTIFY, READ, READ_WRITE, WRITE, WRITE_SEVERAL


def request_length(begin: bytes | bytearray) -> int | None:
    """Length of the request that begins so: None while that is open, 0 if its function is none."""
    return _length(begin, _REQUEST_LENGTHS)


def reply_length(begin: bytes | bytearray) -> int | None:
    """Length of the reply that begins so: None while that is open, 0 if its function is none."""
    if len(begin) > 1 and begin[1] & EXCEPTION_BIT:
        return 5
    return _length(begin, _REPLY_LENGTHS)


def expected_reply_length(request: Request) -> int | None:
    """How long the reply to a request is, unless it is a refusal, which has five bytes.

    None where nobody can say: of an identification, and of what nobody answers.
    """
    if request.address == BROADCAST:
        return None
    match request:
        case ReadRequest():
            return 5 + 2 * request.count
        case ReadWriteRequest():
            return 5 + 2 * request.read_count
        case WriteRequest() | WriteSeveralRequest():
            return 8
        case IdentifyRequest():
            return None


def _length(
    begin: bytes | bytearray, lengths: Mapping[int, Callable[[bytes | bytearray], int | None]]
) -> int | None:
    if len(begin) < 2:
        return None
    length = lengths.get(begin[1])
    return 0 if length is None else length(begin)


def _fixed(count: int) -> Callable[[bytes | bytearray], int | None]:
    return lambda _: count


def _counted(at: int) -> Callable[[bytes | bytearray], int | None]:
    """The byte at this index says how many follow before the CRC."""
    return lambda begin: at + 1 + begin[at] + CRC_BYTES if len(begin) > at else None


def identification_length(begin: bytes | bytearray) -> int | None:
    """Length of the reply to an identification that begins so: None while that is open."""
    at = 8
    for _ in range(begin[7] if len(begin) > 7 else 0):
        if len(begin) < at + 2:
            return None
        at += 2 + begin[at + 1]
    return at + CRC_BYTES if len(begin) > 7 else None


_REQUEST_LENGTHS = {
    READ: _fixed(8),
    WRITE: _fixed(8),
    WRITE_SEVERAL: _counted(6),
    READ_WRITE: _counted(10),
    IDENTIFY: _fixed(7),
}
_REPLY_LENGTHS = {
    READ: _counted(2),
    WRITE: _fixed(8),
    WRITE_SEVERAL: _fixed(8),
    READ_WRITE: _counted(2),
    IDENTIFY: identification_length,
}
