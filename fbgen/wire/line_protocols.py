"""What a listener needs to know of a protocol: where a frame ends, what answers what.

Sources: as in `toshiba`, `toshiba_block`, `modbus` and `modbus_lengths`.
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Literal

from fbgen.dataclass import dataclass
from fbgen.wire import (
    modbus,
    modbus_lengths,
    modbus_rtu,
    toshiba_ascii,
    toshiba_block,
    toshiba_stream,
)
from fbgen.wire.toshiba import (
    ASCII_START,
    BINARY_START,
    BROADCAST,
    Address,
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Group,
    Reply,
    Request,
)
from fbgen.wire.toshiba_block import BlockReply, BlockRequest

Way = Literal["request", "reply"]


@dataclass(frozen=True, slots=True)
class LineProtocol:
    """A protocol of the inverters' line.

    `length` of the frame that begins so: None while that is open, 0 if none does. `is_right`: these
    bytes are a frame with its right check sum. `is_answered`: a request gets a reply from somebody.
    `answers`: a reply answers a request.
    """

    name: str
    length: Callable[[Way, bytes], int | None]
    is_right: Callable[[Way, bytes], bool]
    is_answered: Callable[[bytes], bool]
    answers: Callable[[bytes, bytes], bool]


def _toshiba_length(way: Way, begin: bytes) -> int | None:
    if begin[0] == ASCII_START:
        return _ascii_length(begin)
    if begin[0] != BINARY_START:
        return 0
    if way == "request":
        return toshiba_block.request_length(begin)
    return toshiba_block.reply_length(begin)


def _ascii_length(begin: bytes) -> int | None:
    for index, byte in enumerate(begin[1 : toshiba_ascii.LONGEST_FRAME], start=1):
        if byte == toshiba_ascii.CARRIAGE_RETURN:
            return index + 1
        if byte not in toshiba_ascii.INNER_BYTES:
            return 0
    return None if len(begin) < toshiba_ascii.LONGEST_FRAME else 0


def _toshiba_right(way: Way, frame: bytes) -> bool:
    if way == "reply":
        return toshiba_stream.parse_reply(frame) is not None
    request = toshiba_stream.parse_request(frame)
    wrong_sum = isinstance(request, BadRequest) and request.error is ErrorCode.CHECKSUM
    return request is not None and not wrong_sum


def _toshiba_answered(frame: bytes) -> bool:
    request = toshiba_stream.parse_request(frame)
    if isinstance(request, Request):
        return request.command not in (Command.S, Command.S_TRIPPED)
    return request is not None


def _toshiba_answers(asked: bytes, replied: bytes) -> bool:
    request, reply = toshiba_stream.parse_request(asked), toshiba_stream.parse_reply(replied)
    if request is None or reply is None or not _may_come_from(request.address, reply.address):
        return False
    match reply:
        case ErrorReply():
            return True
        case BlockReply():
            return isinstance(request, BlockRequest)
        case Reply(_, command, com_no):
            same = isinstance(request, Request) and request.command is command
            return same and isinstance(request, Request) and request.com_no == com_no


def _may_come_from(asked: Address, replied: Address) -> bool:
    """For several the smallest number answers, with the address of the request or its own."""
    return asked in (BROADCAST, replied) or isinstance(asked, Group)


def _modbus_length(way: Way, begin: bytes) -> int | None:
    if way == "request":
        return modbus_lengths.request_length(begin)
    return modbus_lengths.reply_length(begin)


def _modbus_right(way: Way, frame: bytes) -> bool:
    if way == "request":
        return modbus_rtu.parse_request(frame) is not None
    return modbus_rtu.parse_reply(frame) is not None


def _modbus_answered(frame: bytes) -> bool:
    return frame[0] != modbus.BROADCAST


def _modbus_answers(asked: bytes, replied: bytes) -> bool:
    function = replied[1] & ~modbus.EXCEPTION_BIT
    if replied[0] != asked[0] or function != asked[1]:
        return False
    request = modbus_rtu.parse_request(asked)
    if replied[1] & modbus.EXCEPTION_BIT or request is None:
        return True
    if isinstance(request, modbus.BadRequest):
        return False
    wanted = modbus_lengths.expected_reply_length(request)
    same = wanted is None or wanted == len(replied)
    if isinstance(request, modbus.WriteRequest):
        return replied == asked
    return same


LINE_PROTOCOLS: Mapping[str, LineProtocol] = MappingProxyType(
    {
        item.name: item
        for item in (
            LineProtocol(
                *("toshiba", _toshiba_length, _toshiba_right, _toshiba_answered, _toshiba_answers)
            ),
            LineProtocol(
                *("modbus", _modbus_length, _modbus_right, _modbus_answered, _modbus_answers)
            ),
        )
    }
)
"""By the id of the protocol in the catalogue."""
