"""Frames of MODBUS-RTU for `fbgen decode`: what each field says, and what comes back.

MODBUS Application Protocol Specification V1.1b3; what an inverter answers: VF-S15 RS485 manual
E6581913, pp. 25-39.
"""

from collections.abc import Iterator

from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_reading import (
    Part,
    Reading,
    directions,
    no_frame,
    shown,
    size_of,
    wrong_size,
)
from fbgen.cli.frames.modbus_pairs import Message, first_word
from fbgen.wire import modbus, modbus_rtu
from fbgen.wire.modbus_lengths import expected_reply_length, reply_length, request_length

EXCEPTIONS = {
    modbus.ExceptionCode.FUNCTION: "there is no such function",
    modbus.ExceptionCode.ADDRESS: "there is no such ComNo",
    modbus.ExceptionCode.VALUE: "the data or their number are outside of the range",
    modbus.ExceptionCode.CANNOT_EXECUTE: "it cannot be executed",
}
_FUNCTIONS = {
    modbus.Function.READ: "read words",
    modbus.Function.WRITE: "write a word",
    modbus.Function.WRITE_SEVERAL: "write words",
    modbus.Function.READ_WRITE: "write words, then read words",
    modbus.Function.IDENTIFY: "who are you?",
}
_OBJECTS = {0: "maker", 1: "product", 2: "version"}
_SHORTEST = 4


def modbus_reading(
    frame: bytes, direction: str | None, cells: CellTexts, asked: bytes | None
) -> Reading:
    """The reading of a frame; of a reply with the request that it answers, if that is known.

    Raises DiagnosticError FB9041 if it is none, FB9045 if it does not answer that request.
    """
    ways = directions(direction if asked is None else "reply")
    right = modbus.seal(frame[:-2])
    for way in ways if len(frame) >= _SHORTEST else ():
        parse = modbus_rtu.parse_request if way == "request" else modbus_rtu.parse_reply
        message = parse(right)
        if message is not None:
            start = None if asked is None else first_word(asked, message)
            return Reading(
                f"MODBUS-RTU, {way}",
                way,
                frame,
                right,
                tuple(_parts(frame, right, message, cells, start)),
                tuple(_remarks(message, frame, right, direction, cells)),
            )
    raise no_frame(
        "frame of MODBUS-RTU", _why_not(frame, ways), "address, function, data, CRC: 2 bytes"
    )


def _why_not(frame: bytes, ways: tuple[str, ...]) -> str:
    if len(frame) < _SHORTEST:
        return f"{size_of(len(frame))} are too few"
    if frame[0] > modbus.HIGHEST_ADDRESS:
        return f"no device has the address {frame[0]}"
    wanted = [(request_length if way == "request" else reply_length)(frame) for way in ways]
    if wrong := wrong_size(frame, wanted, "function"):
        return wrong
    if not any(wanted):
        return f"no inverter has the function {frame[1]:02X}"
    return "its fields do not fit together"


def _parts(
    frame: bytes, right: bytes, message: Message, cells: CellTexts, start: int | None
) -> Iterator[Part]:
    yield Part(frame[:1], "address", _who(message.address))
    yield Part(frame[1:2], "function", _function(frame[1]))
    if isinstance(message, modbus.ReadReply | modbus.ReadWriteReply):
        yield from _words(frame[2:-2], message.words, cells, start)
    else:
        yield from _content(frame[2:-2], message, cells)
    given, wanted = frame[-2:], right[-2:]
    text = "right" if given == wanted else f"wrong: {shown(wanted)} is right"
    yield Part(given, "CRC", text)


def _function(code: int) -> str:
    known = next(
        (text for item, text in _FUNCTIONS.items() if item == code & ~modbus.EXCEPTION_BIT), ""
    )
    text = known or "none that inverters have"
    return f"{text}: refused" if code & modbus.EXCEPTION_BIT else text


def _who(address: int) -> str:
    return "all devices" if address == modbus.BROADCAST else f"device {address}"


def _content(data: bytes, message: Message, cells: CellTexts) -> Iterator[Part]:
    match message:
        case modbus.ReadRequest(_, start, count):
            yield Part(data[:2], "start", cells.name(start))
            yield Part(data[2:], "count", f"{count} to read")
        case modbus.WriteRequest(_, start, word) | modbus.WriteReply(_, start, word):
            yield Part(data[:2], "ComNo", cells.name(start))
            yield Part(data[2:], "word", cells.value(start, word))
        case modbus.WriteSeveralReply(_, start, count):
            yield Part(data[:2], "start", cells.name(start))
            yield Part(data[2:], "count", f"{count} written")
        case modbus.WriteSeveralRequest(_, start, words):
            yield from _written(data, start, words, cells)
        case modbus.ReadWriteRequest(_, start, count, write_start, words):
            yield Part(data[:2], "read from", cells.name(start))
            yield Part(data[2:4], "count", f"{count} to read")
            yield from _written(data[4:], write_start, words, cells)
        case modbus.IdentifyRequest(_, code, object_id):
            yield Part(data[:1], "type", "device identification")
            yield Part(data[1:2], "code", f"{code}")
            yield Part(data[2:], "object", f"{object_id}, {_OBJECTS.get(object_id, 'other')}")
        case modbus.IdentifyReply():
            yield from _identification(data, message)
        case modbus.ExceptionReply():
            known = next((text for code, text in EXCEPTIONS.items() if code == message.code), "")
            yield Part(data, "code", f"{message.code:02X}: {known or 'not known of inverters'}")
        case modbus.BadRequest():
            yield Part(data, "data", "")


def _words(
    data: bytes, words: tuple[int, ...], cells: CellTexts, start: int | None
) -> Iterator[Part]:
    """The words of a reply, by ComNo if it is known where they begin."""
    yield Part(data[:1], "bytes", f"{data[0]} follow")
    for number, word in enumerate(words):
        text = f"{word:04X}"
        if start is not None:
            com_no = start + number
            text = f"{cells.short(com_no)}: {cells.value(com_no, word)}"
        yield Part(data[1 + 2 * number : 3 + 2 * number], f"word {number + 1}", text)


def _written(data: bytes, start: int, words: tuple[int, ...], cells: CellTexts) -> Iterator[Part]:
    yield Part(data[:2], "write from", cells.name(start))
    yield Part(data[2:4], "count", f"{len(words)} to write")
    yield Part(data[4:5], "bytes", f"{data[4]} follow")
    for number, word in enumerate(words):
        at = 5 + 2 * number
        com_no = start + number
        text = cells.value(com_no, word)
        yield Part(data[at : at + 2], f"word {number + 1}", f"{cells.short(com_no)}: {text}")


def _identification(data: bytes, reply: modbus.IdentifyReply) -> Iterator[Part]:
    yield Part(data[:1], "type", "device identification")
    yield Part(data[1:2], "code", f"{reply.code}")
    yield Part(data[2:3], "conformity", f"{reply.conformity:02X}")
    more = f"yes, from object {reply.next_object} on" if reply.more_follows else "no"
    yield Part(data[3:5], "more", more)
    yield Part(data[5:6], "objects", f"{len(reply.objects)}")
    at = 6
    for number, text in reply.objects:
        end = at + 2 + len(text)
        name = _OBJECTS.get(number, f"object {number}")
        yield Part(data[at:end], name, text.decode("ascii", "replace"))
        at = end


def _remarks(
    message: Message, frame: bytes, right: bytes, direction: str | None, cells: CellTexts
) -> Iterator[str]:
    if frame != right:
        yield "The CRC is wrong: nobody takes notice of it."
        return
    if isinstance(message, modbus.BadRequest):
        reply = modbus.ExceptionReply(message.address, message.function, message.error)
        text = "nobody answers" if message.address == modbus.BROADCAST else _encoded(reply)
        yield f"Refused with {message.error:02X}, {EXCEPTIONS[message.error]}: {text}"
    elif isinstance(message, modbus.Request):
        yield from _replies(message, cells)
        if direction is None and isinstance(message, modbus.WriteRequest) and message.address:
            value = cells.value(message.start, message.word)
            name = cells.short(message.start)
            who = _who(message.address)
            yield f"As a reply the same bytes say: {who} has taken {name} = {value}."


def _replies(request: modbus.Request, cells: CellTexts) -> Iterator[str]:
    size = expected_reply_length(request)
    match request:
        case _ if request.address == modbus.BROADCAST:
            yield "Nobody answers what is for all."
        case modbus.WriteRequest(address, start, word):
            if cells.resets(start, word):
                yield "Nobody answers: the inverter resets."
            else:
                yield f"Reply: {_encoded(modbus.WriteReply(address, start, word))}"
        case modbus.WriteSeveralRequest(address, start, words):
            yield f"Reply: {_encoded(modbus.WriteSeveralReply(address, start, len(words)))}"
        case modbus.ReadRequest(address, _, count) | modbus.ReadWriteRequest(address, _, count):
            head = shown(bytes((address, _function_of(request), 2 * count)))
            yield f"Reply: {head}, the words and the CRC, {size_of(size or 0)}"
        case modbus.IdentifyRequest():
            yield "Reply: maker, product and version, each with its length"


def _function_of(request: modbus.ReadRequest | modbus.ReadWriteRequest) -> modbus.Function:
    """The function of a request for words."""
    return (
        modbus.Function.READ
        if isinstance(request, modbus.ReadRequest)
        else modbus.Function.READ_WRITE
    )


def _encoded(reply: modbus.Reply) -> str:
    return shown(modbus_rtu.encode_reply(reply))
