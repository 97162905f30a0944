"""Bits that flip and ends that get lost: what each protocol notices, frame kind by frame kind.

What the sum of the Toshiba protocol lets through is counted in `docs/reference/protocols.md`, and
`tests/unit/wire/test_protocols_page.py` counts it again.
"""

from collections.abc import Callable, Iterator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fbgen.wire import modbus_stream, toshiba_stream
from fbgen.wire.modbus import Reply, Request, crc, seal
from fbgen.wire.modbus_lengths import reply_length, request_length
from fbgen.wire.modbus_rtu import encode_reply, encode_request
from fbgen.wire.modbus_rtu import parse_reply as parse_modbus_reply
from fbgen.wire.modbus_rtu import parse_request as parse_modbus_request
from fbgen.wire.toshiba import BadRequest
from fbgen.wire.toshiba_block import reply_length as toshiba_reply_length
from fbgen.wire.toshiba_block import request_length as toshiba_request_length
from tests.frames import ASCII_CHECKED, MODBUS, TOSHIBA_BINARY
from tests.properties.modbus_messages import replies, requests

BYTE_NS = 572_916
LATER_NS = 10_000_000_000


def _flipped(frame: bytes) -> Iterator[bytes]:
    for bit in range(8 * len(frame)):
        damaged = bytearray(frame)
        damaged[bit >> 3] ^= 1 << (bit & 7)
        yield bytes(damaged)


def _cut(frame: bytes) -> Iterator[bytes]:
    for at in range(1, len(frame)):
        yield frame[:at]
        yield frame[at:]


def _all_heard(damaged: bytes) -> list[object]:
    """What parsers and streams of both sides make of bytes of the Toshiba protocol."""
    toshiba_request_length(damaged)
    toshiba_reply_length(damaged)
    heard: list[object] = [
        toshiba_stream.parse_request(damaged),
        toshiba_stream.parse_reply(damaged),
    ]
    for stream in (
        toshiba_stream.request_stream(),
        toshiba_stream.reply_stream(),
        toshiba_stream.block_request_stream(),
        toshiba_stream.block_reply_stream(),
    ):
        heard += stream.feed(damaged, 0, BYTE_NS)
    intervals = toshiba_stream.silent_intervals(19_200)
    for between in (
        toshiba_stream.silence_request_stream(intervals),
        toshiba_stream.silence_reply_stream(intervals),
    ):
        between.feed(damaged, 0, BYTE_NS)
        heard += between.end(LATER_NS)
    return heard


@pytest.mark.parametrize("damage", [_flipped, _cut])
@pytest.mark.parametrize("name", TOSHIBA_BINARY)
def test_damaged_binary_frame_is_never_taken_as_right(
    name: str, damage: Callable[[bytes], Iterator[bytes]]
) -> None:
    for damaged in damage(TOSHIBA_BINARY[name]):
        for message in _all_heard(damaged):
            assert message is None or isinstance(message, BadRequest), damaged.hex(" ")


@pytest.mark.parametrize("name", ASCII_CHECKED)
def test_ascii_frame_cut_short_is_never_taken_as_right(name: str) -> None:
    for damaged in _cut(ASCII_CHECKED[name]):
        for message in _all_heard(damaged):
            assert message is None or isinstance(message, BadRequest), damaged


def test_flip_of_the_sum_mark_of_a_short_ascii_frame_is_the_one_that_passes() -> None:
    # & with bit 4 flipped is 6: the sum turns into data, and nothing is left to check them with
    passed = [
        (frame, damaged)
        for frame in ASCII_CHECKED.values()
        for damaged in _flipped(frame)
        for message in (toshiba_stream.parse_request(damaged), toshiba_stream.parse_reply(damaged))
        if message is not None and not isinstance(message, BadRequest)
    ]
    assert passed == [(b"(R0000&60)\r", b"(R0000660)\r")]


@pytest.mark.parametrize("name", MODBUS)
def test_damaged_modbus_frame_is_never_taken_as_right(name: str) -> None:
    frame = MODBUS[name]
    intervals = modbus_stream.silent_intervals(19_200)
    for damaged in [*_flipped(frame), *_cut(frame)]:
        request_length(damaged)
        reply_length(damaged)
        assert parse_modbus_request(damaged) is None
        assert parse_modbus_reply(damaged) is None
        for stream in (
            modbus_stream.request_stream(intervals),
            modbus_stream.reply_stream(intervals),
        ):
            stream.feed(damaged, 0, BYTE_NS)
            assert stream.end(LATER_NS) == ()


def test_one_or_two_flipped_bits_pass_the_check_sum_of_no_modbus_frame() -> None:
    # The check sum is linear: what a flip does to it depends on its place from the end only. None
    # of the 2048 places of the longest frame does nothing, and no two of them do the same.
    longest = 256
    right = seal(bytes(longest - 2))
    effects = {crc(damaged) for damaged in _flipped(right)}
    assert crc(right) == 0
    assert 0 not in effects
    assert len(effects) == 8 * longest


@given(st.one_of(requests, replies), st.data())
def test_burst_of_up_to_sixteen_bits_passes_no_modbus_check_sum(
    message: Request | Reply, data: st.DataObject
) -> None:
    frame = encode_request(message) if isinstance(message, Request) else encode_reply(message)
    # bits go over the line with the lowest of each byte first
    bits = int.from_bytes(frame, "little")
    burst = data.draw(st.integers(1, 0xFFFF)) << data.draw(st.integers(0, 8 * len(frame) - 16))
    damaged = (bits ^ burst).to_bytes(len(frame), "little")
    assert parse_modbus_request(damaged) is None
    assert parse_modbus_reply(damaged) is None


@pytest.mark.parametrize("name", [*TOSHIBA_BINARY, *ASCII_CHECKED])
def test_undamaged_frame_of_the_toshiba_protocol_is_heard(name: str) -> None:
    frame = {**TOSHIBA_BINARY, **ASCII_CHECKED}[name]
    heard = [toshiba_stream.parse_request(frame), toshiba_stream.parse_reply(frame)]
    assert any(message is not None and not isinstance(message, BadRequest) for message in heard)


@pytest.mark.parametrize("name", MODBUS)
def test_undamaged_frame_of_modbus_is_heard(name: str) -> None:
    frame = MODBUS[name]
    assert parse_modbus_request(frame) or parse_modbus_reply(frame)
