"""Toshiba ASCII frames: `(`, INV-NO, CMD, ComNo, DATA, `&` SUM, `)`, CR.

INV-NO is two decimal digits and may be left out; `*` stands for any digit. SUM may be left out,
with its `&`; a reply carries INV-NO and SUM only if the request did (VF-S11 communications manual
E6581222, pp. 8-10; VF-AS1 RS485 manual E6581315, p. 7). A frame has at most 17 bytes.
"""

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
    com_no, data = _word(body[1:5]), body[5:]
    if com_no is None or not _HEX.issuperset(data):
        return None
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
    tripped = bool(body[0] & TRIPPED_BIT)
    first = _word(body[1:5])
    if first is None:
        return None
    if body[0] in _ERROR_CMDS and len(body) == 5:
        if first > max(ErrorCode):
            return None
        return ErrorReply(address, ErrorCode(first), tripped, Form.ASCII, checked)
    command, data = _COMMANDS.get(body[0] & ~TRIPPED_BIT), _word(body[5:])
    if command is None or data is None:
        return None
    return Reply(address, command, first, data, tripped, Form.ASCII, checked)


def _frame(address: Address, body: bytes, checked: bool) -> bytes:
    frame = b"(" + _number(address) + body
    if checked:
        frame += b"&"
        frame += b"%02X" % checksum(frame)
    return frame + b")\r"


def _take_apart(frame: bytes) -> tuple[Address, bytes, bool, bool] | None:
    """Address, what stands from CMD on, whether there is a SUM, and whether it is right."""
    if not (frame.startswith(b"(") and frame.endswith(b")\r")) or len(frame) > LONGEST_FRAME:
        return None
    inner, checked, sum_is_right = frame[1:-2], False, True
    if inner[-3:-2] == b"&":
        given = inner[-2:]
        if not _HEX.issuperset(given):
            return None
        inner, checked = inner[:-3], True
        sum_is_right = int(given, 16) == checksum(b"(" + inner + b"&")
    if not inner or not (_DIGITS | _LETTERS).issuperset(inner.lstrip(b"*0123456789")):
        return None
    if inner[0] in _LETTERS:
        return None, inner, checked, sum_is_right
    address = _address(inner[:2])
    if address is None or inner[2:3] == b"" or inner[2] not in _LETTERS:
        return None
    return address, inner[2:], checked, sum_is_right


def _address(two: bytes) -> Address:
    """INV-NO from its two characters; None if they are none, such as a number of one digit."""
    if two == b"**":
        return BROADCAST
    digits = [int(char) if char.isdigit() else None for char in two.decode("ascii")]
    tens, units = digits if len(digits) == 2 else (None, None)
    if tens is not None and units is not None:
        return 10 * tens + units
    if (tens is None and two[:1] != b"*") or (units is None and two[1:] != b"*"):
        return None
    return Group(tens, units)


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


def _word(digits: bytes) -> int | None:
    return int(digits, 16) if len(digits) == 4 and _HEX.issuperset(digits) else None
