"""MODBUS-RTU frames: address, function, data, CRC with its low byte first.

Facts: MODBUS Application Protocol Specification V1.1b3, sections 4.1 and 7; MODBUS over Serial Line
V1.02, section 2.5.1; VF-S15 RS485 manual E6581913, pp. 25-39.

What a device meets with silence is None here: a wrong CRC, a frame shorter or longer than its
function has it, an address that no device has (VF-S11 manual E6581222, p. 31). What it refuses, if
it is addressed, is a `BadRequest`: an unknown function with 01 (section 7); with 03 quantities that
the specification rules out and a number of bytes that does not fit the number of words (VF-S15
manual, p. 34: 3 words announced, 4 bytes carried). Reading frames never raises.
"""

import struct

from fbgen.wire import modbus_replies, modbus_requests
from fbgen.wire.modbus import (
    EXCEPTION_BIT,
    HIGHEST_ADDRESS,
    LONGEST_FRAME,
    BadRequest,
    ExceptionCode,
    ExceptionReply,
    Reply,
    Request,
    crc,
    seal,
)
from fbgen.wire.modbus_layout import LOWEST_ADDRESS

_SHORTEST = 4


def encode_request(request: Request) -> bytes:
    """The frame of a request.

    ValueError for an address, number, word or quantity that no frame can have; `seal` makes those.
    """
    try:
        return seal(modbus_requests.ENCODERS[type(request)](request))
    except struct.error as problem:
        raise ValueError(f"no frame can say {request}: {problem}") from None


def encode_reply(reply: Reply) -> bytes:
    """The frame of a reply. ValueError as in `encode_request`."""
    try:
        return seal(modbus_replies.ENCODERS[type(reply)](reply))
    except struct.error as problem:
        raise ValueError(f"no frame can say {reply}: {problem}") from None


def parse_request(frame: bytes) -> Request | BadRequest | None:
    """What a request says; None if these bytes are not exactly one request frame."""
    size = len(frame)
    if not _SHORTEST <= size <= LONGEST_FRAME or crc(frame):
        return None
    address, function = frame[0], frame[1]
    if address > HIGHEST_ADDRESS or function & EXCEPTION_BIT:
        return None
    parse = modbus_requests.PARSERS.get(function)
    if parse is None:
        return BadRequest(address, function, ExceptionCode.FUNCTION)
    return parse(frame, size)


def parse_reply(frame: bytes) -> Reply | None:
    """What a reply says; None if these bytes are not exactly one reply frame."""
    size = len(frame)
    if not _SHORTEST <= size <= LONGEST_FRAME or crc(frame):
        return None
    if not LOWEST_ADDRESS <= frame[0] <= HIGHEST_ADDRESS:
        return None
    function = frame[1]
    if function & EXCEPTION_BIT:
        if size != 5 or not frame[2]:
            return None
        return ExceptionReply(frame[0], function & ~EXCEPTION_BIT, frame[2])
    parse = modbus_replies.PARSERS.get(function)
    return None if parse is None else parse(frame, size)
