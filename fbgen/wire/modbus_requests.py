"""MODBUS-RTU requests by function: from message to bytes and back. `modbus_rtu` chooses.

MODBUS Application Protocol Specification V1.1b3, sections 6.3, 6.6, 6.12, 6.17 and 6.21.
"""

from collections.abc import Callable, Mapping
from struct import Struct
from typing import Any

from fbgen.wire.modbus import (
    BROADCAST,
    HIGHEST_ADDRESS,
    MOST_READ,
    MOST_WRITTEN,
    MOST_WRITTEN_BEFORE_READING,
    BadRequest,
    ExceptionCode,
    IdentifyRequest,
    ReadRequest,
    ReadWriteRequest,
    Request,
    WriteRequest,
    WriteSeveralRequest,
)
from fbgen.wire.modbus_layout import (
    IDENTIFICATION,
    IDENTIFY,
    IDENTIFY_CODES,
    READ,
    READ_WRITE,
    TWO_WORDS,
    WORDS,
    WRITE,
    WRITE_SEVERAL,
    identification,
    quantity,
)

_WORDS_FOLLOW = Struct(">BBHHB")
_READ_WORDS_FOLLOW = Struct(">BBHHHHB")
_IDENTIFY = Struct(">BBBBB")


def _to(address: int) -> int:
    """The address of a request. ValueError if no device can have it."""
    if not BROADCAST <= address <= HIGHEST_ADDRESS:
        raise ValueError(f"a request cannot be addressed to {address}, only to 0 to 247")
    return address


def _read_request(request: ReadRequest) -> bytes:
    count = quantity(request.count, MOST_READ)
    return TWO_WORDS.pack(_to(request.address), READ, request.start, count)


def _write_request(request: WriteRequest) -> bytes:
    return TWO_WORDS.pack(_to(request.address), WRITE, request.start, request.word)


def _write_several_request(request: WriteSeveralRequest) -> bytes:
    words = request.words
    count = quantity(len(words), MOST_WRITTEN)
    head = _WORDS_FOLLOW.pack(_to(request.address), WRITE_SEVERAL, request.start, count, 2 * count)
    return head + WORDS[count].pack(*words)


def _read_write_request(request: ReadWriteRequest) -> bytes:
    words = request.words
    count = quantity(len(words), MOST_WRITTEN_BEFORE_READING)
    head = _READ_WORDS_FOLLOW.pack(
        _to(request.address),
        READ_WRITE,
        request.read_start,
        quantity(request.read_count, MOST_READ),
        request.write_start,
        count,
        2 * count,
    )
    return head + WORDS[count].pack(*words)


def _identify_request(request: IdentifyRequest) -> bytes:
    address, code = _to(request.address), identification(request.code)
    return _IDENTIFY.pack(address, IDENTIFY, IDENTIFICATION, code, request.object_id)


ENCODERS: Mapping[type, Callable[[Any], bytes]] = {
    ReadRequest: _read_request,
    WriteRequest: _write_request,
    WriteSeveralRequest: _write_several_request,
    ReadWriteRequest: _read_write_request,
    IdentifyRequest: _identify_request,
}
"""What makes the frame of a request without its CRC, by the type of the message."""


def _parse_read_request(frame: bytes, size: int) -> Request | BadRequest | None:
    if size != 8:
        return None
    address, function, start, count = TWO_WORDS.unpack_from(frame)
    if not 1 <= count <= MOST_READ:
        return BadRequest(address, function, ExceptionCode.VALUE)
    return ReadRequest(address, start, count)


def _parse_write_request(frame: bytes, size: int) -> Request | BadRequest | None:
    if size != 8:
        return None
    address, _, start, word = TWO_WORDS.unpack_from(frame)
    return WriteRequest(address, start, word)


def _parse_write_several_request(frame: bytes, size: int) -> Request | BadRequest | None:
    if size < 7 or size != 9 + frame[6]:
        return None
    address, function, start, count, length = _WORDS_FOLLOW.unpack_from(frame)
    if not 1 <= count <= MOST_WRITTEN or length != 2 * count:
        return BadRequest(address, function, ExceptionCode.VALUE)
    return WriteSeveralRequest(address, start, WORDS[count].unpack_from(frame, 7))


def _parse_read_write_request(frame: bytes, size: int) -> Request | BadRequest | None:
    if size < 11 or size != 13 + frame[10]:
        return None
    address, function, read_start, read_count, start, count, length = (
        _READ_WORDS_FOLLOW.unpack_from(frame)
    )
    if (
        not (1 <= read_count <= MOST_READ and 1 <= count <= MOST_WRITTEN_BEFORE_READING)
        or length != 2 * count
    ):
        return BadRequest(address, function, ExceptionCode.VALUE)
    words = WORDS[count].unpack_from(frame, 11)
    return ReadWriteRequest(address, read_start, read_count, start, words)


def _parse_identify_request(frame: bytes, size: int) -> Request | BadRequest | None:
    if size > 4 and frame[2] != IDENTIFICATION:
        return BadRequest(frame[0], frame[1], ExceptionCode.FUNCTION)
    if size != 7:
        return None
    if frame[3] not in IDENTIFY_CODES:
        return BadRequest(frame[0], frame[1], ExceptionCode.VALUE)
    return IdentifyRequest(frame[0], frame[3], frame[4])


PARSERS: Mapping[int, Callable[[bytes, int], Request | BadRequest | None]] = {
    READ: _parse_read_request,
    WRITE: _parse_write_request,
    WRITE_SEVERAL: _parse_write_several_request,
    READ_WRITE: _parse_read_write_request,
    IDENTIFY: _parse_identify_request,
}
"""What reads a frame with a right CRC, given its length, by its function."""
