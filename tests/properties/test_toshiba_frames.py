"""Toshiba frames: what is written is read, whatever the bytes around it and however they arrive."""

from hypothesis import given
from hypothesis import strategies as st

from fbgen.wire import toshiba_ascii, toshiba_binary
from fbgen.wire.toshiba import (
    BROADCAST,
    Address,
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Form,
    Group,
    Reply,
    Request,
)
from fbgen.wire.toshiba_stream import FRAME_TIMEOUT_NS, request_stream

BYTE_NS = 572_916

words = st.integers(0, 0xFFFF)
binary_addresses = st.one_of(st.none(), st.integers(0, 0x3F), st.just(BROADCAST))
ascii_addresses: st.SearchStrategy[Address] = st.one_of(
    st.none(),
    st.integers(0, 99),
    st.just(BROADCAST),
    st.builds(Group, st.none(), st.integers(0, 9)),
    st.builds(Group, st.integers(0, 9), st.none()),
)
binary_requests = st.builds(
    lambda address, command, com_no, data: Request(
        address, command, com_no, 0 if command is Command.R else data
    ),
    binary_addresses,
    st.sampled_from(Command),
    words,
    words,
)
ascii_requests = st.builds(
    Request,
    ascii_addresses,
    st.sampled_from([Command.W, Command.P]),
    words,
    words,
    st.just(Form.ASCII),
    st.booleans(),
)
replies = st.builds(
    Reply,
    binary_addresses,
    st.sampled_from([Command.R, Command.G, Command.W, Command.P]),
    words,
    words,
    st.booleans(),
    st.just(Form.BINARY),
    st.just(True),
) | st.builds(
    ErrorReply,
    binary_addresses,
    st.sampled_from(ErrorCode),
    st.booleans(),
    st.just(Form.BINARY),
    st.just(True),
)


@given(binary_requests)
def test_binary_request_survives_the_wire(request: Request) -> None:
    assert toshiba_binary.parse_request(toshiba_binary.encode_request(request)) == request


@given(ascii_requests)
def test_ascii_request_survives_the_wire(request: Request) -> None:
    frame = toshiba_ascii.encode_request(request)
    assert len(frame) <= toshiba_ascii.LONGEST_FRAME
    assert toshiba_ascii.parse_request(frame) == request


@given(replies)
def test_reply_survives_the_wire(reply: Reply | ErrorReply) -> None:
    assert toshiba_binary.parse_reply(toshiba_binary.encode_reply(reply)) == reply


@given(st.binary(max_size=40))
def test_parsers_take_any_bytes(data: bytes) -> None:
    for parse in (
        toshiba_binary.parse_request,
        toshiba_binary.parse_reply,
        toshiba_ascii.parse_request,
        toshiba_ascii.parse_reply,
    ):
        assert parse(data) is None or data[:1] in (b"/", b"(")


@given(
    st.lists(
        st.one_of(
            st.binary(max_size=6),
            binary_requests.map(toshiba_binary.encode_request),
            ascii_requests.map(toshiba_ascii.encode_request),
        ),
        max_size=4,
    )
)
def test_messages_do_not_depend_on_how_the_bytes_are_handed_over(pieces: list[bytes]) -> None:
    data = b"".join(pieces)
    at_once = request_stream().feed(data, 0, BYTE_NS)
    stream = request_stream()
    one_by_one: list[Request | BadRequest] = []
    for index in range(len(data)):
        one_by_one += stream.feed(data[index : index + 1], index * BYTE_NS, BYTE_NS)
    assert at_once == tuple(one_by_one)


@given(st.binary(max_size=40), binary_requests)
def test_every_frame_is_heard_half_a_second_after_any_noise(noise: bytes, request: Request) -> None:
    stream = request_stream()
    stream.feed(noise, 0, BYTE_NS)
    later_ns = len(noise) * BYTE_NS + FRAME_TIMEOUT_NS
    assert stream.feed(toshiba_binary.encode_request(request), later_ns, BYTE_NS) == (request,)


@given(binary_requests, st.data())
def test_one_changed_byte_is_never_taken_for_another_request(
    request: Request, data: st.DataObject
) -> None:
    frame = bytearray(toshiba_binary.encode_request(request))
    at = data.draw(st.integers(0, len(frame) - 1))
    frame[at] ^= data.draw(st.integers(1, 255))
    for message in request_stream().feed(bytes(frame), 0, BYTE_NS):
        assert not isinstance(message, Request) or at <= 2
