"""Toshiba binary frames: 2FH, INV-NO, CMD, ComNo, DATA, SUM.

INV-NO may be left out where there is one drive only. The second byte of a frame is an INV-NO if it
is 00H to 3FH or FFH, else it is the CMD: all CMD codes are 47H or higher (VF-S11 communications
manual E6581222, pp. 11-13; the rule is inferred from the two ranges).
"""

from collections.abc import Mapping
from functools import lru_cache
from struct import Struct

from fbgen.wire.toshiba import (
    BINARY_START,
    BROADCAST,
    HIGHEST_BINARY_INV_NO,
    TRIPPED_BIT,
    Address,
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Reply,
    Request,
    seal,
)

_ERROR_CMD = 0x4E
_READ_WITHOUT_DATA = Struct(">BH").pack
_TELEGRAM = Struct(">BHH").pack
_ERROR = Struct(">BH").pack

_COMMANDS: dict[int, Command] = {int(command): command for command in Command}
_ERROR_CODES: dict[int, ErrorCode] = {int(code): code for code in ErrorCode}
_ANSWERED = (Command.R, Command.G, Command.W, Command.P)

REQUEST_TAILS: Mapping[int, int] = {
    command: 3 if command is Command.R else 5 for command in Command
}
"""Bytes behind the CMD of a request, the checksum included."""

REPLY_TAILS: Mapping[int, int] = {
    **dict.fromkeys(_ANSWERED, 5),
    **{command | TRIPPED_BIT: 5 for command in _ANSWERED},
    _ERROR_CMD: 3,
    _ERROR_CMD | TRIPPED_BIT: 3,
}
"""Bytes behind the CMD of a reply, the checksum included."""


def encode_request(request: Request) -> bytes:
    """The frame of a request. Binary has no groups and no number over 3FH: a ValueError."""
    number = number_bytes(request.address)
    if request.command is Command.R:
        return seal(number + _READ_WITHOUT_DATA(request.command, request.com_no))
    return seal(number + _TELEGRAM(request.command, request.com_no, request.data))


def encode_reply(reply: Reply | ErrorReply) -> bytes:
    """The frame of a reply or refusal, with lower-case CMD if the drive is tripped."""
    case = TRIPPED_BIT if reply.tripped else 0
    if isinstance(reply, ErrorReply):
        return seal(number_bytes(reply.address) + _ERROR(_ERROR_CMD | case, reply.error))
    return reply_frame(reply.address, reply.command | case, reply.com_no, reply.data)


@lru_cache(maxsize=4096)
def reply_frame(address: Address, cmd: int, com_no: int, data: int) -> bytes:
    """The frame of a reply by its parts. Drives say the same over and over, so frames are kept."""
    return seal(number_bytes(address) + _TELEGRAM(cmd, com_no, data))


def frame_length(begin: bytes | bytearray, tails: Mapping[int, int]) -> int | None:
    """Length of the frame that begins so: None while that is open, 0 if it is no frame.

    `tails` is `REQUEST_TAILS` or `REPLY_TAILS`.
    """
    if len(begin) < 2:
        return None
    command_at = 2 if is_number(begin[1]) else 1
    if len(begin) <= command_at:
        return None
    tail = tails.get(begin[command_at])
    return 0 if tail is None else command_at + 1 + tail


@lru_cache(maxsize=4096)
def parse_request(frame: bytes) -> Request | BadRequest | None:
    """What a request says; None if these bytes are not exactly one request frame."""
    size = len(frame)
    if size < 2 or frame[0] != BINARY_START or frame_length(frame, REQUEST_TAILS) != size:
        return None
    address, at = split(frame)
    command = _COMMANDS[frame[at]]
    if sum(frame) - frame[-1] & 0xFF != frame[-1]:
        return BadRequest(address, ErrorCode.CHECKSUM) if command in _ANSWERED else None
    com_no = frame[at + 1] << 8 | frame[at + 2]
    data = frame[at + 3] << 8 | frame[at + 4] if command is not Command.R else 0
    return Request(address, command, com_no, data)


def parse_reply(frame: bytes) -> Reply | ErrorReply | None:
    """What a reply says; None if these bytes are not exactly one reply with a right checksum."""
    size = len(frame)
    if size < 2 or frame[0] != BINARY_START or frame_length(frame, REPLY_TAILS) != size:
        return None
    if sum(frame) - frame[-1] & 0xFF != frame[-1]:
        return None
    address, at = split(frame)
    tripped = bool(frame[at] & TRIPPED_BIT)
    code = frame[at] & ~TRIPPED_BIT
    word = frame[at + 1] << 8 | frame[at + 2]
    if code == _ERROR_CMD:
        error = _ERROR_CODES.get(word)
        return None if error is None else ErrorReply(address, error, tripped)
    return Reply(address, _COMMANDS[code], word, frame[at + 3] << 8 | frame[at + 4], tripped)


def is_number(byte: int) -> bool:
    """True if a second byte is an INV-NO and not the CMD already."""
    return byte <= HIGHEST_BINARY_INV_NO or byte == BROADCAST


def split(frame: bytes) -> tuple[int | None, int]:
    """INV-NO and the index of the CMD."""
    return (frame[1], 2) if is_number(frame[1]) else (None, 1)


def number_bytes(address: Address) -> bytes:
    """INV-NO as it stands in a frame. ValueError for a group and for a number over 3FH."""
    if address is None:
        return b""
    if isinstance(address, int) and is_number(address):
        return bytes((address,))
    raise ValueError(f"a binary frame cannot be addressed to {address}")
