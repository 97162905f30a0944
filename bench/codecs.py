"""What a frame costs to write and to read, in each codec of the inverters' lines.

All frames are different ones and more than any cache holds, and they come in turn: so no figure
rests on a frame that was seen before.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from bench.measuring import Figure, measure
from fbgen.wire import modbus_rtu, toshiba_ascii, toshiba_binary, toshiba_block
from fbgen.wire.modbus import (
    ReadReply,
    ReadRequest,
    ReadWriteRequest,
    WriteRequest,
    WriteSeveralRequest,
)
from fbgen.wire.modbus_stream import request_stream, silent_intervals
from fbgen.wire.silence import characters_ns
from fbgen.wire.toshiba import Command, Form, Reply, Request
from fbgen.wire.toshiba_block import BlockReply, BlockRequest

_FRAMES = 6_000
_WINDOWS = 60
_BAUD = 19_200
_LIMIT = "at most 5 us (200,000 frames/s)"

Message = TypeVar("Message")


def _figures(
    name: str,
    make: Callable[[int], Message],
    encode: Callable[[Message], bytes],
    parse: Callable[[bytes], Message | object | None],
    limit: str = _LIMIT,
) -> Iterator[Figure]:
    messages = [make(number) for number in range(_FRAMES)]
    frames = [encode(message) for message in messages]
    assert len(set(frames)) == _FRAMES
    assert [parse(frame) for frame in frames] == messages
    size = len(frames[0])

    def encode_all(encode: Callable[[Message], bytes], messages: Sequence[Message]) -> None:
        for message in messages:
            encode(message)

    def parse_all(parse: Callable[[bytes], object], frames: Sequence[bytes]) -> None:
        for frame in frames:
            parse(frame)

    for way, action in (
        ("written", lambda: encode_all(encode, messages)),
        ("read", lambda: parse_all(parse, frames)),
    ):
        text = f"{name}, {size} bytes, {way}"
        yield measure(text, action, limit, per=_FRAMES, windows=_WINDOWS)


def _heard() -> Figure:
    """A frame between silences, from its bytes with their times to its message."""
    frames = [modbus_rtu.encode_request(ReadRequest(1, number)) for number in range(_FRAMES)]
    silences = silent_intervals(_BAUD)
    byte_ns = characters_ns(1, _BAUD)
    pause_ns = len(frames[0]) * byte_ns + silences.frame_ns

    def hear_all() -> None:
        stream = request_stream(silences)
        now_ns = 0
        for frame in frames:
            stream.feed(frame, now_ns, byte_ns)
            now_ns += pause_ns
            stream.end(now_ns)

    return measure("MODBUS 03 request, heard", hear_all, _LIMIT, per=_FRAMES, windows=_WINDOWS)


def figures() -> Iterator[Figure]:
    """Seconds for one frame."""
    yield from _figures(
        "Toshiba binary request",
        lambda number: Request(number & 0x3F, Command.P, 0xFA01, number),
        toshiba_binary.encode_request,
        toshiba_binary.parse_request,
    )
    yield from _figures(
        "Toshiba binary reply",
        lambda number: Reply(number & 0x3F, Command.G, 0xFE03, number),
        toshiba_binary.encode_reply,
        toshiba_binary.parse_reply,
    )
    yield from _figures(
        "Toshiba ASCII request",
        lambda number: Request(number % 100, Command.P, 0xFA01, number, Form.ASCII),
        toshiba_ascii.encode_request,
        toshiba_ascii.parse_request,
    )
    yield from _figures(
        "Toshiba ASCII reply",
        lambda number: Reply(number % 100, Command.R, 0xFE03, number, False, Form.ASCII),
        toshiba_ascii.encode_reply,
        toshiba_ascii.parse_reply,
    )
    yield from _figures(
        "Toshiba block request X",
        lambda number: BlockRequest(number & 0x3F, (0xC400, number), 5),
        toshiba_block.encode_request,
        toshiba_block.parse_request,
    )
    yield from _figures(
        "Toshiba block reply Y",
        lambda number: BlockReply(number & 0x3F, (0x6400, number, 0, 0, 0)),
        toshiba_block.encode_reply,
        toshiba_block.parse_reply,
    )
    yield from _figures(
        "MODBUS 03 request",
        lambda number: ReadRequest(1 + number % 247, number, 1),
        modbus_rtu.encode_request,
        modbus_rtu.parse_request,
    )
    yield from _figures(
        "MODBUS 03 reply",
        lambda number: ReadReply(1 + number % 247, (number,)),
        modbus_rtu.encode_reply,
        modbus_rtu.parse_reply,
    )
    yield from _figures(
        "MODBUS 03 reply of 8 words",
        lambda number: ReadReply(1 + number % 247, (number,) * 8),
        modbus_rtu.encode_reply,
        modbus_rtu.parse_reply,
    )
    yield from _figures(
        "MODBUS 06 request",
        lambda number: WriteRequest(1 + number % 247, 0xFA01, number),
        modbus_rtu.encode_request,
        modbus_rtu.parse_request,
    )
    yield from _figures(
        "MODBUS 10H request of 2 words",
        lambda number: WriteSeveralRequest(1 + number % 247, 0x1870, (0xC400, number)),
        modbus_rtu.encode_request,
        modbus_rtu.parse_request,
    )
    yield from _figures(
        "MODBUS 17H request of 2 words",
        lambda number: ReadWriteRequest(1 + number % 247, 0x1875, 5, 0x1870, (0xC400, number)),
        modbus_rtu.encode_request,
        modbus_rtu.parse_request,
    )
    yield _heard()
    yield from _figures(
        "MODBUS 03 reply of 125 words",
        lambda number: ReadReply(1 + number % 247, (number,) * 125),
        modbus_rtu.encode_reply,
        modbus_rtu.parse_reply,
        "no inverter has one so long",
    )
