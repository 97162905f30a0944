"""What frames of MODBUS-RTU on a line are and say, in words, from the catalogue.

What the words of a reply are stands in the request before it.
"""

from collections.abc import Mapping, Sequence
from itertools import count

from fbgen.catalog import Drive
from fbgen.wire import modbus, modbus_rtu
from harness.trace.meaning import cell_name, word_meaning
from harness.trace.model import FrameKind

_REFUSALS = {
    modbus.ExceptionCode.FUNCTION: "there is no such function",
    modbus.ExceptionCode.ADDRESS: "there is no such ComNo",
    modbus.ExceptionCode.VALUE: "the value or the number of words lies outside the range",
    modbus.ExceptionCode.CANNOT_EXECUTE: "it cannot be done now",
}


class ModbusMeanings:
    """Kind and meaning of the frames of one line, in their order."""

    def __init__(self, series: Mapping[int, Drive]) -> None:
        """`series` are the drives of the line by their numbers."""
        self._series = series
        self._first = next(iter(series.values()))
        self._asked: modbus.Request | modbus.BadRequest | None = None
        self._known: dict[tuple[bytes, bool, object], tuple[FrameKind, str]] = {}

    def of(self, data: bytes, to_drives: bool) -> tuple[FrameKind, str]:
        """What a frame is and says; no meaning for bytes that are no frame of the protocol."""
        if to_drives:
            self._asked = modbus_rtu.parse_request(data)
        key = data, to_drives, self._asked
        found = self._known.get(key)
        if found is None:
            found = self._known[key] = self._read(data, to_drives)
        return found

    def _read(self, data: bytes, to_drives: bool) -> tuple[FrameKind, str]:
        if to_drives:
            asked = self._asked
            return ("unknown", "") if asked is None else ("request", self._request(asked))
        reply = modbus_rtu.parse_reply(data)
        if reply is None:
            return "unknown", ""
        kind: FrameKind = "refusal" if isinstance(reply, modbus.ExceptionReply) else "reply"
        return kind, self._reply(reply)

    def _drive(self, address: int) -> Drive:
        return self._series.get(address, self._first)

    def _request(self, request: modbus.Request | modbus.BadRequest) -> str:
        drive = self._drive(request.address)
        text = "all drives: " if request.address == modbus.BROADCAST else _who(request.address)
        match request:
            case modbus.BadRequest():
                return f"{text}function {request.function:02X}, which it refuses"
            case modbus.ReadRequest(_, start, number):
                return f"{text}read {_cells(drive, start, number)}"
            case modbus.WriteRequest(_, start, word):
                return f"{text}write {_words(drive, start, [word], '=')}"
            case modbus.WriteSeveralRequest(_, start, words):
                return f"{text}write {_words(drive, start, words, '=')}"
            case modbus.ReadWriteRequest(_, start, number, write_start, words):
                written = _words(drive, write_start, words, "=")
                return f"{text}write {written}, read {_cells(drive, start, number)}"
            case modbus.IdentifyRequest():
                return f"{text}who is it?"

    def _reply(self, reply: modbus.Reply) -> str:
        drive, text = self._drive(reply.address), _who(reply.address)
        match reply:
            case modbus.ExceptionReply(_, _, code):
                known = {int(item): words for item, words in _REFUSALS.items()}
                why = known.get(code, f"exception {code:02X}")
                return f"{text.removesuffix(': ')} refuses: {why}"
            case modbus.ReadReply(_, words) | modbus.ReadWriteReply(_, words):
                start = self._start_of(reply.address, len(words))
                if start is None:
                    return text + " ".join(f"{word:04X}" for word in words)
                return text + _words(drive, start, words, "is")
            case modbus.WriteReply(_, start, word):
                return text + _words(drive, start, [word], "is")
            case modbus.WriteSeveralReply(_, start, number):
                return f"{text}{_cells(drive, start, number)} written"
            case modbus.IdentifyReply(_, _, _, objects):
                return text + " ".join(item.decode("ascii", "replace") for _, item in objects)

    def _start_of(self, address: int, number: int) -> int | None:
        """The ComNo of the first word of a reply; None if it does not answer the last request."""
        match self._asked:
            case modbus.ReadRequest(asked, start, wanted):
                return start if (asked, wanted) == (address, number) else None
            case modbus.ReadWriteRequest(asked, start, wanted):
                return start if (asked, wanted) == (address, number) else None
        return None


def _who(address: int) -> str:
    return f"drive {address}: "


def _words(drive: Drive, start: int, words: Sequence[int], joint: str) -> str:
    return ", ".join(
        f"{cell_name(drive, com_no)} {joint} {word_meaning(drive, com_no, word)}"
        for com_no, word in zip(count(start), words)
    )


def _cells(drive: Drive, start: int, number: int) -> str:
    more = f" and {number - 1} more" if number > 1 else ""
    return f"{cell_name(drive, start)}{more}"
