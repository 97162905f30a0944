"""Frames of the Toshiba protocol from their fields, for `fbgen encode`."""

from fbgen.cli.frames.frame_fields import Fields
from fbgen.wire import toshiba_ascii, toshiba_binary, toshiba_block
from fbgen.wire.toshiba import (
    BROADCAST,
    HIGHEST_BINARY_INV_NO,
    Address,
    Command,
    ErrorCode,
    ErrorReply,
    Form,
    Group,
    Reply,
    Request,
)
from fbgen.wire.toshiba_block import MOST_READ, MOST_WRITTEN, BlockReply, BlockRequest

_REQUESTS: dict[str, Command | None] = {
    "R": Command.R,
    "G": Command.G,
    "W": Command.W,
    "P": Command.P,
    "S": Command.S,
    "s": Command.S_TRIPPED,
    "X": None,
}
_REPLIES: dict[str, Command | None] = {
    "R": Command.R,
    "G": Command.G,
    "W": Command.W,
    "P": Command.P,
    "N": None,
    "Y": None,
}
_IN_ASCII = ("R", "W", "P", "N")
_FORMS = {"binary": Form.BINARY, "ascii": Form.ASCII}
_ALL = ("all", "**", "FF", "ff")


def toshiba_frame(direction: str, fields: Fields) -> bytes:
    """The frame. Raises DiagnosticError FB9042 and FB9043 with everything that is wrong."""
    return _request(fields) if direction == "request" else _reply(fields)


def _request(fields: Fields) -> bytes:
    letter = fields.choice("command", _REQUESTS)
    command = _REQUESTS[letter]
    if command is None:
        words = fields.words("write", MOST_WRITTEN, 0)
        reads = fields.number("read", range(MOST_READ + 1), 0)
        block = BlockRequest(_address(fields, Form.BINARY), words, reads)
        fields.close()
        return toshiba_block.encode_request(block)
    form = _form(fields, letter)
    com_no = fields.com_no()
    reads_only = command in (Command.R, Command.G)
    data = 0 if reads_only else fields.word("data", com_no)
    request = Request(_address(fields, form), command, com_no, data, form, _checked(fields, form))
    fields.close()
    if form is Form.ASCII:
        return toshiba_ascii.encode_request(request)
    return toshiba_binary.encode_request(request)


def _reply(fields: Fields) -> bytes:
    letter = fields.choice("command", _REPLIES)
    command = _REPLIES[letter]
    tripped = fields.flag("tripped", "no")
    if letter == "Y":
        words = fields.words("words", MOST_READ, 0)
        status = fields.number("status", range(0x100), 0)
        block = BlockReply(_address(fields, Form.BINARY), words, status, tripped)
        fields.close()
        return toshiba_block.encode_reply(block)
    form = _form(fields, letter)
    address, checked = _address(fields, form), _checked(fields, form)
    reply: Reply | ErrorReply
    if command is None:
        error = ErrorCode(fields.number("error", range(max(ErrorCode) + 1)))
        reply = ErrorReply(address, error, tripped, form, checked)
    else:
        com_no = fields.com_no()
        data = fields.word("data", com_no)
        reply = Reply(address, command, com_no, data, tripped, form, checked)
    fields.close()
    if form is Form.ASCII:
        return toshiba_ascii.encode_reply(reply)
    return toshiba_binary.encode_reply(reply)


def _form(fields: Fields, letter: str) -> Form:
    form = _FORMS[fields.choice("form", _FORMS, "binary")]
    if form is Form.ASCII and letter not in _IN_ASCII:
        fields.wrong("command", "is none in ASCII", "use R, W or P, or leave out form=ascii")
    return form


def _checked(fields: Fields, form: Form) -> bool:
    """Binary always has a sum."""
    return form is Form.BINARY or fields.flag("sum", "yes")


def _address(fields: Fields, form: Form) -> Address:
    if not fields.has("inv_no"):
        return None
    text = fields.text("inv_no")
    if text in _ALL:
        return BROADCAST
    if form is Form.ASCII and len(text) == 2 and text.count("*") == 1:
        digit = text.replace("*", "")
        if digit in "0123456789":
            number = int(digit)
            return Group(None, number) if text[0] == "*" else Group(number, None)
    highest = HIGHEST_BINARY_INV_NO if form is Form.BINARY else 99
    if text.isascii() and text.isdigit() and int(text) <= highest:
        return int(text)
    groups = "" if form is Form.BINARY else ", *2 or 1*"
    fields.wrong("inv_no", "is no INV-NO", f"use 0 to {highest}, all{groups}")
    return None
