"""Frames of the Toshiba protocol for `fbgen decode`: what each field says, and what comes back.

Who answers and who keeps silent: VF-S11 communications manual E6581222, pp. 9-13, 22; VF-AS1 RS485
manual E6581315, pp. 19-20, 45; VF-S15 RS485 manual E6581913, pp. 12-13.
"""

from collections.abc import Iterator

from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_reading import Part, Reading, directions, no_frame, shown, wrong_size
from fbgen.cli.frames.toshiba_answers import ERRORS, READS, Message, address_text, remarks
from fbgen.wire import toshiba_ascii, toshiba_binary, toshiba_block
from fbgen.wire.toshiba import (
    ASCII_START,
    BINARY_START,
    BadRequest,
    ErrorReply,
    Reply,
    Request,
    checksum,
    seal,
)
from fbgen.wire.toshiba_block import BlockReply, BlockRequest
from fbgen.wire.toshiba_inter_drive import SetPoint, set_point_of

_COMMANDS = {
    "R": "read",
    "G": "read, with data that mean nothing",
    "W": "write to RAM and EEPROM",
    "P": "write to RAM",
    "S": "set-point of a master that is sound",
    "s": "set-point of a master that has tripped",
    "X": "block: write, then read",
    "Y": "block: the words read",
    "N": "refused",
}
_WRITTEN, _READ_FROM = ("F870", "F871"), ("F875", "F876", "F877", "F878", "F879")
_SUM_BYTES = 4
"""An ASCII frame with a sum ends with it, `)` and CR."""


def toshiba_reading(frame: bytes, direction: str | None, cells: CellTexts) -> Reading:
    """The reading of a frame. Raises DiagnosticError FB9041 if it is none."""
    is_ascii = frame[0] == ASCII_START
    right = _right_ascii(frame) if is_ascii else seal(frame[1:-1])
    if frame[0] in (ASCII_START, BINARY_START):
        for way in directions(direction):
            message = _parse(right, way, is_ascii)
            if message is not None:
                parts = _ascii_parts if is_ascii else _binary_parts
                return Reading(
                    f"Toshiba protocol, {'ASCII' if is_ascii else 'binary'}, {way}",
                    way,
                    frame,
                    right,
                    tuple(parts(frame, right, message, cells)),
                    tuple(remarks(message, frame, right, direction, cells)),
                )
    raise no_frame(
        "frame of the Toshiba protocol",
        _why_not(frame, directions(direction), is_ascii),
        "2F [INV-NO] CMD ComNo DATA SUM in binary, (11PFA00C400) in ASCII",
    )


def _parse(frame: bytes, way: str, is_ascii: bool) -> Message | None:
    if is_ascii:
        parse = toshiba_ascii.parse_request if way == "request" else toshiba_ascii.parse_reply
        return parse(frame)
    if way == "request":
        return toshiba_block.parse_request(frame)
    return toshiba_block.parse_reply(frame)


def _right_ascii(frame: bytes) -> bytes:
    if frame[-5:-4] != b"&":
        return frame
    return frame[:-_SUM_BYTES] + b"%02X)\r" % checksum(frame[:-_SUM_BYTES])


def _why_not(frame: bytes, ways: tuple[str, ...], is_ascii: bool) -> str:
    if is_ascii:
        return "its form is none that a drive or a master understands"
    if frame[0] != BINARY_START:
        return f"it begins with {frame[0]:02X}, not with 2F or ("
    wanted = []
    for way in ways:
        length = toshiba_block.request_length if way == "request" else toshiba_block.reply_length
        wanted.append(length(frame))
    if wrong := wrong_size(frame, wanted, "CMD"):
        return wrong
    if any(wanted):
        return "its code is none that a drive refuses with"
    at = 2 if toshiba_binary.is_number(frame[1]) else 1
    return f"{frame[at]:02X} is no CMD here, or counts more words than there can be"


def _sum_part(given: bytes, right: bytes, name: str = "SUM") -> Part:
    text = "right" if given == right else f"wrong: {_plain(right)} is right"
    return Part(given, name, text)


def _plain(data: bytes) -> str:
    text = data.decode("ascii", "replace")
    return text if len(data) == 2 and text.isalnum() else shown(data)


def _command_part(data: bytes) -> Part:
    return Part(data, "CMD", command_text(data[0]))


def command_text(code: int) -> str:
    """What a CMD byte asks for, or says of the inverter that answers."""
    letter = chr(code)
    known = _COMMANDS.get(letter)
    if known is not None:
        return f"{letter}, {known}"
    upper = _COMMANDS.get(letter.upper())
    if upper is None:
        return f"{letter}, which is no command" if letter.isprintable() else "no command"
    return f"{letter}, {upper}; the inverter has tripped"


def _binary_parts(frame: bytes, right: bytes, message: Message, cells: CellTexts) -> Iterator[Part]:
    yield Part(frame[:1], "start", "binary")
    at = 1
    if message.address is not None:
        yield Part(frame[1:2], "INV-NO", address_text(message.address))
        at = 2
    yield _command_part(frame[at : at + 1])
    yield from _content(frame[at + 1 : -1], 2, message, cells)
    yield _sum_part(frame[-1:], right[-1:])


def _content(data: bytes, unit: int, message: Message, cells: CellTexts) -> Iterator[Part]:
    """What stands between CMD and SUM. A word has `unit` bytes: two, or four in ASCII."""
    match message:
        case BlockRequest():
            yield Part(data[:1], "nW", f"{data[0]} to write")
            reads = "" if data[1] == message.reads else ", which is too many: none"
            yield Part(data[1:2], "nR", f"{data[1]} to read{reads}")
            for number, place in enumerate(_WRITTEN[: data[0]], start=1):
                text = f"{message.words[number - 1]:04X}, for the ComNo chosen by {place}"
                yield Part(data[2 * number : 2 * number + 2], f"W{number}", text)
        case BlockReply():
            yield Part(data[:1], "nR", f"{data[0]} read")
            yield Part(data[1:2], "STATUS", "good" if not data[1] else "meaning unknown")
            for number, place in enumerate(_READ_FROM[: data[0]], start=1):
                text = f"{message.words[number - 1]:04X}, of the ComNo chosen by {place}"
                yield Part(data[2 * number : 2 * number + 2], f"R{number}", text)
        case ErrorReply():
            yield Part(data, "code", f"{message.error:04X}: {ERRORS[message.error]}")
        case Request() | Reply():
            yield Part(data[:unit], "ComNo", cells.name(message.com_no))
            if data[unit:]:
                yield Part(data[unit:], "DATA", _data_text(message, cells))
        case BadRequest():
            yield Part(data, "rest", "")


def _data_text(message: Request | Reply, cells: CellTexts) -> str:
    if isinstance(message, Request):
        if message.command in READS:
            return "means nothing"
        set_point = set_point_of(message)
        if set_point is not None:
            return _percent(set_point)
    return cells.value(message.com_no, message.data)


def _percent(set_point: SetPoint) -> str:
    return f"{set_point.word:04X} = {set_point.percent:.2f} % of the maximum frequency"


def _ascii_parts(frame: bytes, right: bytes, message: Message, cells: CellTexts) -> Iterator[Part]:
    yield Part(frame[:1], "start", "ASCII")
    at = 1
    if message.address is not None:
        yield Part(frame[1:3], "INV-NO", f"{frame[1:3].decode()}, {address_text(message.address)}")
        at = 3
    yield _command_part(frame[at : at + 1])
    checked = frame[-5:-4] == b"&"
    end = -5 if checked else -2
    yield from _content(frame[at + 1 : end], 4, message, cells)
    if checked:
        yield Part(b"&", "mark", "a sum follows")
        yield _sum_part(frame[-_SUM_BYTES:-2], right[-_SUM_BYTES:-2])
    yield Part(frame[-2:], "end", "bracket and CR")
