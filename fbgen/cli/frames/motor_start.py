"""Whether a frame may start a motor: fbgen never sends one of these unasked."""

from fbgen.catalog import Drive
from fbgen.wire import modbus, modbus_rtu, toshiba_stream
from fbgen.wire.toshiba import Command, Request
from fbgen.wire.toshiba_block import BlockRequest

STARTS = ("run", "jog")
"""Bits of command words that turn a motor."""


def may_start(series: Drive, protocol: str, frame: bytes) -> bool:
    """True if a request sets such a bit, or writes words of which the frame does not say where."""
    return any(
        com_no is None or starts(series, com_no, word)
        for com_no, word in _written(series, protocol, frame)
    )


def starts(series: Drive, com_no: int, word: int) -> bool:
    """True if this word in this ComNo turns a motor."""
    known = next((item for item in series.comnos if item.number == com_no), None)
    if known is None or known.word is None:
        return False
    fields = series.word(known.word).decode(word)
    return any(item.value and item.field.name in STARTS for item in fields)


def _written(series: Drive, protocol: str, frame: bytes) -> list[tuple[int | None, int]]:
    """ComNos with the words that a request writes; None where other ComNos choose the ComNo."""
    if protocol == "modbus":
        match modbus_rtu.parse_request(frame):
            case modbus.WriteRequest(_, start, word):
                return [(start, word)]
            case modbus.WriteSeveralRequest(_, start, words):
                return _several(series, start, words)
            case modbus.ReadWriteRequest(_, _, _, start, words):
                return _several(series, start, words)
        return []
    match toshiba_stream.parse_request(frame):
        case Request(_, Command.W | Command.P, com_no, data):
            return [(com_no, data)]
        case BlockRequest(_, words):
            return [(None, word) for word in words]
    return []


def _several(series: Drive, start: int, words: tuple[int, ...]) -> list[tuple[int | None, int]]:
    known = {item.number for item in series.comnos}
    return [(start + place if start in known else None, word) for place, word in enumerate(words)]
