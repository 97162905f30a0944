"""MODBUS-RTU replies by function: from message to bytes and back. `modbus_rtu` chooses.

MODBUS Application Protocol Specification V1.1b3, sections 6.3, 6.6, 6.12, 6.17, 6.21 and 7.
"""

from collections.abc import Callable, Mapping
from struct import Struct
from typing import Any

from fbgen.wire.modbus import (
    EXCEPTION_BIT,
    HIGHEST_ADDRESS,
    LONGEST_FRAME,
    MOST_READ,
    MOST_WRITTEN,
    ExceptionReply,
    IdentifyReply,
    ReadReply,
    ReadWriteReply,
    Reply,
    WriteReply,
    WriteSeveralReply,
)
from fbgen.wire.modbus_layout import (
    CRC_BYTES,
    IDENTIFICATION,
    IDENTIFY,
    IDENTIFY_CODES,
    LOWEST_ADDRESS,
    READ,
    READ_WRITE,
    TWO_WORDS,
    WORDS,
    WRITE,
    WRITE_SEVERAL,
    identification,
    quantity,
)
from fbgen.wire.modbus_lengths import identification_length

_HEAD = Struct(">BBB")
_IDENTIFY = Struct(">BBBBBBBB")
_OBJECT = Struct(">BB")


def _from(address: int) -> int:
    if not LOWEST_ADDRESS <= address <= HIGHEST_ADDRESS:
        raise ValueError(f"a reply cannot come from {address}, only from 1 to 247")
    return address


def _words_reply(address: int, function: int, words: tuple[int, ...]) -> bytes:
    count = quantity(len(words), MOST_READ)
    return _HEAD.pack(_from(address), function, 2 * count) + WORDS[count].pack(*words)


def _read_reply(reply: ReadReply) -> bytes:
    return _words_reply(reply.address, READ, reply.words)


def _read_write_reply(reply: ReadWriteReply) -> bytes:
    return _words_reply(reply.address, READ_WRITE, reply.words)


def _write_reply(reply: WriteReply) -> bytes:
    return TWO_WORDS.pack(_from(reply.address), WRITE, reply.start, reply.word)


def _write_several_reply(reply: WriteSeveralReply) -> bytes:
    count = quantity(reply.count, MOST_WRITTEN)
    return TWO_WORDS.pack(_from(reply.address), WRITE_SEVERAL, reply.start, count)


def _identify_reply(reply: IdentifyReply) -> bytes:
    head = _IDENTIFY.pack(
        _from(reply.address),
        IDENTIFY,
        IDENTIFICATION,
        identification(reply.code),
        reply.conformity,
        0xFF if reply.more_follows else 0,
        reply.next_object,
        len(reply.objects),
    )
    objects = [_OBJECT.pack(number, len(text)) + text for number, text in reply.objects]
    payload = b"".join([head, *objects])
    if len(payload) > LONGEST_FRAME - CRC_BYTES:
        raise ValueError(f"an identification of {len(payload)} bytes does not fit into a frame")
    return payload


def _exception_reply(reply: ExceptionReply) -> bytes:
    if reply.function & EXCEPTION_BIT or not reply.code:
        raise ValueError(f"no device refuses {reply.function:02X}H with {reply.code}")
    function = reply.function | EXCEPTION_BIT
    return _HEAD.pack(_from(reply.address), function, reply.code)


ENCODERS: Mapping[type, Callable[[Any], bytes]] = {
    ReadReply: _read_reply,
    WriteReply: _write_reply,
    WriteSeveralReply: _write_several_reply,
    ReadWriteReply: _read_write_reply,
    IdentifyReply: _identify_reply,
    ExceptionReply: _exception_reply,
}
"""What makes the frame of a reply without its CRC, by the type of the message."""


def _words_in_reply(frame: bytes, size: int) -> tuple[int, ...] | None:
    length = frame[2]
    if size != 5 + length or length & 1 or not 2 <= length <= 2 * MOST_READ:
        return None
    return WORDS[length >> 1].unpack_from(frame, 3)


def _parse_read_reply(frame: bytes, size: int) -> Reply | None:
    words = _words_in_reply(frame, size)
    return None if words is None else ReadReply(frame[0], words)


def _parse_read_write_reply(frame: bytes, size: int) -> Reply | None:
    words = _words_in_reply(frame, size)
    return None if words is None else ReadWriteReply(frame[0], words)


def _parse_write_reply(frame: bytes, size: int) -> Reply | None:
    if size != 8:
        return None
    address, _, start, word = TWO_WORDS.unpack_from(frame)
    return WriteReply(address, start, word)


def _parse_write_several_reply(frame: bytes, size: int) -> Reply | None:
    if size != 8:
        return None
    address, _, start, count = TWO_WORDS.unpack_from(frame)
    return WriteSeveralReply(address, start, count) if 1 <= count <= MOST_WRITTEN else None


def _parse_identify_reply(frame: bytes, size: int) -> Reply | None:
    if size < 10 or frame[2] != IDENTIFICATION or identification_length(frame) != size:
        return None
    if frame[3] not in IDENTIFY_CODES or frame[5] not in (0, 0xFF):
        return None
    objects, at = [], 8
    for _ in range(frame[7]):
        begin = at + 2
        at = begin + frame[begin - 1]
        objects.append((frame[begin - 2], frame[begin:at]))
    more = frame[5] != 0
    return IdentifyReply(frame[0], frame[3], frame[4], tuple(objects), more, frame[6])


PARSERS: Mapping[int, Callable[[bytes, int], Reply | None]] = {
    READ: _parse_read_reply,
    WRITE: _parse_write_reply,
    WRITE_SEVERAL: _parse_write_several_reply,
    READ_WRITE: _parse_read_write_reply,
    IDENTIFY: _parse_identify_reply,
}
"""What reads a frame with a right CRC, given its length, by its function."""
