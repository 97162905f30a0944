"""Toshiba ASCII frames: `(`, INV-NO, CMD, ComNo, DATA, `&` SUM, `)`, CR.

INV-NO is two decimal digits and may be left out; `*` stands for any digit. SUM may be left out,
with its `&`; a reply carries INV-NO and SUM only if the request did (VF-S11 communications manual
E6581222, pp. 8-10; VF-AS1 RS485 manual E6581315, p. 7). A frame has at most 17 bytes.
"""

import re
from functools import lru_cache

from fbgen.wire.toshiba import (
    BROADCAST,
    TRIPPED_BIT,
    Address,
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Form,
    Group,
    Reply,
    Request,
    checksum,
)

CARRIAGE_RETURN = 0x0D
LONGEST_FRAME = 17
_DIGITS = frozenset(b"0123456789")
_HEX = frozenset(b"0123456789ABCDEF")
_LETTERS = frozenset(range(ord("A"), ord("Z") + 1)) | frozenset(range(ord("a"), ord("z") + 1))
INNER_BYTES = _DIGITS | _LETTERS | frozenset(b"*&)")
"""Everything that may stand between `(` and CR."""

_COMMANDS: dict[int, Command] = {
    int(command): command for command in (Command.R, Command.W, Command.P)
}
_ERROR_CMDS = b"Nn"
_FORM = re.compile(rb"\((\*\*|\*\d|\d\*|\d\d)?([A-Za-z][A-Za-z0-9]*)(?:&([0-9A-F]{2}))?\)\r")
_ADDRESSES: dict[bytes | None, Address] = {
    None: None,
    b"**": BROADCAST,
    **{b"%02d" % number: number for number in range(100)},
    **{b"*%d" % digit: Group(None, digit) for digit in range(10)},
    **{b"%d*" % digit: Group(digit, None) for digit in range(10)},
}
"""INV-NO by its two characters. One digit alone is none (VF-AS1 RS485 manual E6581315, p. 20)."""


def encode_request(request: Request) -> bytes:
    """The frame of a request. ASCII has no G, no S and no number over 99: a ValueError."""
    if request.command not in _COMMANDS:
        raise ValueError(f"there is no command {request.command.name} in ASCII")
    body = b"%c%04X" % (request.command, request.com_no)
    if request.command is not Command.R:
        body += b"%04X" % request.data
    return _frame(request.address, body, request.checked)


def encode_reply(reply: Reply | ErrorReply) -> bytes:
    """The frame of a reply or refusal, with lower-case CMD if the drive is tripped."""
    case = TRIPPED_BIT if reply.tripped else 0
    if isinstance(reply, ErrorReply):
        body = b"%c%04X" % (ord("N") | case, reply.error)
    else:
        body = b"%c%04X%04X" % (reply.command | case, reply.com_no, reply.data)
    return _frame(reply.address, body, reply.checked)


@lru_cache(maxsize=1024)
def parse_request(frame: bytes) -> Request | BadRequest | None:
    """What a request says; None if its form is wrong, on which a drive keeps silent."""
    parts = _take_apart(frame)
    if parts is None:
        return None
    address, body, checked, sum_is_right = parts
    if not sum_is_right:
        return BadRequest(address, ErrorCode.CHECKSUM, Form.ASCII, checked)
    command = _COMMANDS.get(body[0])
    if command is None:
        return BadRequest(address, ErrorCode.COMMAND, Form.ASCII, checked)
    digits = body[1:]
    if len(digits) < 4 or not _HEX.issuperset(digits):
        return None
    com_no, data = int(digits[:4], 16), digits[4:]
    if len(data) > 4 or not (data or command is Command.R):
        return BadRequest(address, ErrorCode.DATA, Form.ASCII, checked)
    value = 0 if command is Command.R else int(data, 16)
    return Request(address, command, com_no, value, Form.ASCII, checked)


@lru_cache(maxsize=1024)
def parse_reply(frame: bytes) -> Reply | ErrorReply | None:
    """What a reply says; None if its form or its checksum is wrong."""
    parts = _take_apart(frame)
    if parts is None or not parts[3]:
        return None
    address, body, checked, _ = parts
    digits = body[1:]
    if len(digits) not in (4, 8) or not _HEX.issuperset(digits):
        return None
    tripped = bool(body[0] & TRIPPED_BIT)
    first = int(digits[:4], 16)
    if len(digits) == 4:
        if body[0] not in _ERROR_CMDS or first > max(ErrorCode):
            return None
        return ErrorReply(address, ErrorCode(first), tripped, Form.ASCII, checked)
    command = _COMMANDS.get(body[0] & ~TRIPPED_BIT)
    if command is None:
        return None
    return Reply(address, command, first, int(digits[4:], 16), tripped, Form.ASCII, checked)


def _frame(address: Address, body: bytes, checked: bool) -> bytes:
    frame = b"(" + _number(address) + body
    if checked:
        frame += b"&"
        frame += b"%02X" % checksum(frame)
    return frame + b")\r"


def _take_apart(frame: bytes) -> tuple[Address, bytes, bool, bool] | None:
    """Address, what stands from CMD on, whether there is a SUM, and whether it is right."""
    found = _FORM.fullmatch(frame) if len(frame) <= LONGEST_FRAME else None
    if found is None:
        return None
    number, body, given = found.groups()
    if given is None:
        return _ADDRESSES[number], body, False, True
    sum_is_right = int(given, 16) == sum(frame[:-4]) & 0xFF
    return _ADDRESSES[number], body, True, sum_is_right


def _number(address: Address) -> bytes:
    if address is None:
        return b""
    if isinstance(address, Group):
        tens, units = ("*" if digit is None else str(digit) for digit in address)
        return f"{tens}{units}".encode("ascii")
    if address == BROADCAST:
        return b"**"
    if 0 <= address <= 99:
        return b"%02d" % address
    raise ValueError(f"an ASCII frame cannot be addressed to {address}")
