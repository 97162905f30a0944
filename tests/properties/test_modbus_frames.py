"""MODBUS-RTU frames: what is written is read, and nothing that a line can deliver raises."""

from hypothesis import given
from hypothesis import strategies as st

from fbgen.wire.modbus import Reply, Request, crc, seal
from fbgen.wire.modbus_lengths import reply_length, request_length
from fbgen.wire.modbus_rtu import encode_reply, encode_request, parse_reply, parse_request
from fbgen.wire.modbus_stream import request_stream, silent_intervals
from tests.properties.modbus_messages import replies, requests

BYTE_NS = 572_916
SILENCES = silent_intervals(19_200)


@given(requests)
def test_request_survives_the_wire(request: Request) -> None:
    frame = encode_request(request)
    assert parse_request(frame) == request
    assert request_length(frame) == len(frame)
    assert crc(frame) == 0


@given(replies)
def test_reply_survives_the_wire(reply: Reply) -> None:
    frame = encode_reply(reply)
    assert parse_reply(frame) == reply
    assert reply_length(frame) == len(frame)


@given(st.binary(max_size=40), st.booleans())
def test_parsers_take_any_bytes_sealed_or_not(data: bytes, sealed: bool) -> None:
    frame = seal(data) if sealed else data
    for message in (parse_request(frame), parse_reply(frame)):
        assert message is None or message.address == frame[0]
    for length in (request_length(frame), reply_length(frame)):
        assert length is None or length >= 0


@given(
    st.lists(st.one_of(st.binary(max_size=12), requests.map(encode_request)), max_size=4),
    st.lists(st.integers(0, 3), min_size=4, max_size=4),
)
def test_every_frame_is_heard_after_a_silence_whatever_came_before(
    pieces: list[bytes], gaps: list[int]
) -> None:
    stream = request_stream(SILENCES)
    now_ns = 0
    for piece, gap in zip(pieces, gaps, strict=False):
        stream.feed(piece, now_ns, BYTE_NS)
        now_ns += len(piece) * BYTE_NS + gap * SILENCES.inside_ns
    stream.end(now_ns + SILENCES.frame_ns)
    frame = bytes.fromhex("01 03 FD 00 00 01 B5 A6")
    later_ns = now_ns + SILENCES.frame_ns
    stream.feed(frame, later_ns, BYTE_NS)
    heard = stream.end(later_ns + len(frame) * BYTE_NS + SILENCES.frame_ns)
    assert heard == (parse_request(frame),)
