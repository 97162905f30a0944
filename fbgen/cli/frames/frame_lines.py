"""A frame of the inverters' line in one line of text."""

from collections.abc import Callable
from itertools import count

from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_reading import shown
from fbgen.cli.frames.modbus_pairs import first_word
from fbgen.cli.frames.modbus_reading import EXCEPTIONS
from fbgen.cli.frames.toshiba_answers import ERRORS, READS, address_text
from fbgen.diagnostics import DiagnosticError
from fbgen.wire import modbus, modbus_rtu, toshiba_stream
from fbgen.wire.line_frames import Direction
from fbgen.wire.toshiba import BadRequest, Command, ErrorReply, Reply, Request
from fbgen.wire.toshiba_block import BlockReply, BlockRequest
from fbgen.wire.toshiba_inter_drive import set_point_of

NO_FRAME = "no frame"
_KEPT = {Command.W: " (RAM and EEPROM)"}

CellsOf = Callable[[object], CellTexts]
"""The texts for the ComNos of a device, by the address of its frames."""


class FrameLines:
    """Says what frames say, one after the other: a MODBUS reply needs the request before."""

    def __init__(self, protocol: str, cells: CellsOf) -> None:
        self._protocol = protocol
        self._cells = cells
        self._asked = b""

    def line(self, direction: Direction, frame: bytes) -> str:
        """What a frame says; `no frame` for bytes that are none."""
        if direction == "unknown":
            return NO_FRAME
        if self._protocol == "toshiba":
            return self._toshiba(direction, frame)
        if direction == "request":
            self._asked = frame
        return self._modbus(direction, frame)

    def _toshiba(self, direction: Direction, frame: bytes) -> str:
        if direction == "request":
            request = toshiba_stream.parse_request(frame)
            return NO_FRAME if request is None else self._asks(request)
        reply = toshiba_stream.parse_reply(frame)
        return NO_FRAME if reply is None else self._says(reply)

    def _asks(self, request: Request | BadRequest | BlockRequest) -> str:
        who = address_text(request.address)
        cells = self._cells(request.address)
        match request:
            case BadRequest():
                return f"{who}: a request to refuse, {ERRORS[request.error]}"
            case BlockRequest():
                return f"{who}: write {len(request.words)} words, read {request.reads} (block)"
            case Request(_, command, com_no, data):
                if command in READS:
                    return f"{who}: read {cells.short(com_no)}"
                point = set_point_of(request)
                if point is not None:
                    return f"{who}: set-point {point.percent:.2f} % of a master"
                value = cells.value(com_no, data)
                return f"{who}: write {cells.short(com_no)} {value}{_KEPT.get(command, '')}"

    def _says(self, reply: Reply | ErrorReply | BlockReply) -> str:
        who = address_text(reply.address)
        tripped = "; it has tripped" if reply.tripped else ""
        match reply:
            case ErrorReply():
                return f"{who} refuses: {ERRORS[reply.error]}{tripped}"
            case BlockReply():
                words = " ".join(f"{word:04X}" for word in reply.words)
                return f"{who}: block {words}".rstrip() + tripped
            case Reply():
                cells = self._cells(reply.address)
                value = cells.value(reply.com_no, reply.data)
                return f"{who}: {cells.short(reply.com_no)} {value}{tripped}"

    def _modbus(self, direction: Direction, frame: bytes) -> str:
        if direction == "request":
            request = modbus_rtu.parse_request(frame)
            return NO_FRAME if request is None else self._modbus_asks(request)
        reply = modbus_rtu.parse_reply(frame)
        return NO_FRAME if reply is None else self._modbus_says(reply)

    def _modbus_asks(self, request: modbus.Request | modbus.BadRequest) -> str:
        who = "all devices" if request.address == modbus.BROADCAST else f"device {request.address}"
        cells = self._cells(request.address)
        match request:
            case modbus.BadRequest():
                return f"{who}: a request to refuse, {EXCEPTIONS[request.error]}"
            case modbus.ReadRequest(_, start, number):
                return f"{who}: read {_cells(cells, start, number)}"
            case modbus.WriteRequest(_, start, word):
                return f"{who}: write {cells.short(start)} {cells.value(start, word)}"
            case modbus.WriteSeveralRequest(_, start, words):
                return f"{who}: write {_words(cells, start, words)}"
            case modbus.ReadWriteRequest(_, start, number, write_start, words):
                written = _words(cells, write_start, words)
                return f"{who}: write {written}; read {_cells(cells, start, number)}"
            case modbus.IdentifyRequest():
                return f"{who}: who are you?"

    def _modbus_says(self, reply: modbus.Reply) -> str:
        who, cells = f"device {reply.address}", self._cells(reply.address)
        match reply:
            case modbus.ExceptionReply(_, _, code):
                known = {int(item): text for item, text in EXCEPTIONS.items()}
                return f"{who} refuses: {known.get(code, f'exception {code:02X}')}"
            case modbus.ReadReply(_, words) | modbus.ReadWriteReply(_, words):
                start = self._first_word(reply)
                if start is None:
                    return f"{who}: " + " ".join(f"{word:04X}" for word in words)
                return f"{who}: {_words(cells, start, words)}"
            case modbus.WriteReply(_, start, word):
                return f"{who}: {cells.short(start)} {cells.value(start, word)}"
            case modbus.WriteSeveralReply(_, start, number):
                return f"{who}: {_cells(cells, start, number)} written"
            case modbus.IdentifyReply(_, _, _, objects):
                texts = " ".join(text.decode("ascii", "replace") for _, text in objects)
                return f"{who}: {texts}"

    def _first_word(self, reply: modbus.Reply) -> int | None:
        try:
            return first_word(self._asked, reply) if self._asked else None
        except DiagnosticError:
            return None


def _words(cells: CellTexts, start: int, words: tuple[int, ...]) -> str:
    return ", ".join(
        f"{cells.short(com_no)} {cells.value(com_no, word)}"
        for com_no, word in zip(count(start), words)
    )


def _cells(cells: CellTexts, start: int, number: int) -> str:
    more = f" and {number - 1} more" if number > 1 else ""
    return f"{cells.short(start)}{more}"


def frame_bytes(frame: bytes) -> str:
    """The bytes of a frame for a person: as text if it is one, else in hexadecimal."""
    if frame.startswith(b"(") and frame.endswith(b"\r") and frame.isascii():
        return frame.decode("ascii").replace("\r", " CR")
    return shown(frame)
