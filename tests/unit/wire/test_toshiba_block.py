"""Block communication, and set-points between drives. The printed frames are in the vectors."""

import pytest

from fbgen.wire.toshiba import (
    BROADCAST,
    BadRequest,
    Command,
    ErrorCode,
    ErrorReply,
    Group,
    Reply,
    Request,
    seal,
)
from fbgen.wire.toshiba_binary import parse_request as parse_telegram
from fbgen.wire.toshiba_block import (
    BlockReply,
    BlockRequest,
    encode_reply,
    encode_request,
    parse_reply,
    parse_request,
    reply_length,
    request_length,
)
from fbgen.wire.toshiba_inter_drive import FOUR_WIRE, SetPoint, encode, set_point_of
from fbgen.wire.toshiba_stream import (
    BLOCK_TIMEOUT_NS,
    FRAME_TIMEOUT_NS,
    block_reply_stream,
    block_request_stream,
    request_stream,
)

BYTE_NS = 572_916
BLOCK = bytes.fromhex("2F 58 02 05 C4 00 17 70 D9")
REQUEST = BlockRequest(None, (0xC400, 0x1770), 5)


@pytest.mark.parametrize(
    ("payload", "request_"),
    [
        ("0B 58 02 05 C4 00 17 70", BlockRequest(11, (0xC400, 0x1770), 5)),
        ("0B 58 01 00 C4 00", BlockRequest(11, (0xC400,), 0)),
        ("58 00 03", BlockRequest(None, (), 3)),
        ("FF 58 01 00 C4 00", BlockRequest(BROADCAST, (0xC400,), 0)),
        ("2F 58 00 01", BlockRequest(0x2F, (), 1)),
    ],
)
def test_request_is_written_and_read(payload: str, request_: BlockRequest) -> None:
    frame = seal(bytes.fromhex(payload))
    assert encode_request(request_) == frame
    assert parse_request(frame) == request_
    assert request_length(frame) == len(frame)


@pytest.mark.parametrize(
    ("payload", "reply"),
    [
        ("0B 59 01 00 17 70", BlockReply(11, (0x1770,))),
        ("59 00 00", BlockReply(None, ())),
        ("0B 79 01 00 17 70", BlockReply(11, (0x1770,), tripped=True)),
        ("59 01 07 17 70", BlockReply(None, (0x1770,), status=7)),
    ],
)
def test_reply_is_written_and_read(payload: str, reply: BlockReply) -> None:
    frame = seal(bytes.fromhex(payload))
    assert encode_reply(reply) == frame
    assert parse_reply(frame) == reply
    assert reply_length(frame) == len(frame)


def test_more_words_to_write_than_two_are_met_with_silence() -> None:
    # VF-S15 RS485 manual E6581913, p. 13
    assert parse_request(seal(bytes.fromhex("0B 58 03 00 00 00 00 00 00 00"))) is None
    assert request_length(b"\x2f\x58\x03") == 0


@pytest.mark.parametrize("reads", [6, 0xFF])
def test_more_words_to_read_than_five_are_none(reads: int) -> None:
    # VF-S15 RS485 manual E6581913, p. 13
    frame = seal(bytes((0x0B, 0x58, 0, reads)))
    assert parse_request(frame) == BlockRequest(11, (), 0)


def test_wrong_sum_is_refused_with_error_4() -> None:
    assert parse_request(BLOCK[:-1] + b"\xd8") == BadRequest(None, ErrorCode.CHECKSUM)


@pytest.mark.parametrize(
    "payload", ["0B 59 06 00 00 00 00 00 00 00 00 00 00 00 00 00", "0B 59 01 00 17", "0B 59 01"]
)
def test_what_is_not_a_right_reply_is_none(payload: str) -> None:
    assert parse_reply(seal(bytes.fromhex(payload))) is None


def test_reply_with_a_wrong_sum_or_without_its_start_is_none() -> None:
    frame = seal(bytes.fromhex("0B 59 01 00 17 70"))
    assert parse_reply(frame[:-1] + b"\x00") is None
    assert parse_reply(b"\x2e" + frame[1:]) is None
    assert parse_request(b"\x2e" + BLOCK[1:]) is None


@pytest.mark.parametrize(
    "request_",
    [
        BlockRequest(1, (0, 0, 0), 0),
        BlockRequest(1, (), 6),
        BlockRequest(64, (), 1),
        BlockRequest(Group(1, None), (), 1),
    ],
)
def test_block_that_no_frame_can_say_is_a_value_error(request_: BlockRequest) -> None:
    with pytest.raises(ValueError, match=r"at most 2 words|cannot be addressed"):
        encode_request(request_)


def test_reply_with_six_words_is_a_value_error() -> None:
    with pytest.raises(ValueError, match="at most 5 words"):
        encode_reply(BlockReply(1, (0,) * 6))


def test_drive_that_knows_blocks_knows_all_other_telegrams_too() -> None:
    telegram = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")
    heard = block_request_stream().feed(b"\x00" + telegram + BLOCK + b"(R0000)\r", 0, BYTE_NS)
    assert heard[0] == Request(11, Command.P, 0xFA00, 0xC400)
    assert heard[1] == REQUEST
    assert len(heard) == 3
    assert parse_request(telegram) == parse_telegram(telegram)


def test_drive_that_knows_no_blocks_keeps_silent() -> None:
    assert request_stream().feed(BLOCK, 0, BYTE_NS) == ()


def test_master_that_asks_for_blocks_hears_refusals_too() -> None:
    frames = bytes.fromhex("2F 59 01 00 17 70 10 2F 4E 00 04 81 2F 0B 50 FA 00 C4 00 48")
    assert block_reply_stream().feed(b"\x00" + frames, 0, BYTE_NS) == (
        BlockReply(None, (0x1770,)),
        ErrorReply(None, ErrorCode.CHECKSUM),
        Reply(11, Command.P, 0xFA00, 0xC400),
    )


def test_block_has_a_second_where_others_have_half_of_one() -> None:
    # VF-S11 communications manual E6581222, pp. 7 and 17
    stream = block_request_stream()
    stream.feed(BLOCK[:4], 0, BYTE_NS)
    assert stream.feed(BLOCK[4:], FRAME_TIMEOUT_NS, BYTE_NS) == (REQUEST,)
    stream.feed(BLOCK[:4], 0, BYTE_NS)
    assert stream.feed(BLOCK[4:], BLOCK_TIMEOUT_NS, BYTE_NS) == ()
    other = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")
    stream.feed(other[:4], 0, BYTE_NS)
    assert stream.feed(other[4:], FRAME_TIMEOUT_NS, BYTE_NS) == ()


@pytest.mark.parametrize(
    ("set_point", "frame"),
    [
        # VF-AS1 RS485 manual E6581315, pp. 19, 39
        (SetPoint(10_000), "2F FF 53 FA 01 27 10 B3"),
        (SetPoint(10_000, master_tripped=True), "2F FF 73 FA 01 27 10 D3"),
        (SetPoint(5_000, com_no=FOUR_WIRE, address=3), "2F 03 53 FA 05 13 88 1F"),
    ],
)
def test_set_point_goes_from_drive_to_drive(set_point: SetPoint, frame: str) -> None:
    assert encode(set_point) == bytes.fromhex(frame)
    request = parse_request(bytes.fromhex(frame))
    assert isinstance(request, Request)
    assert set_point_of(request) == set_point
    assert set_point.percent == set_point.word / 100


def test_other_requests_carry_no_set_point() -> None:
    assert set_point_of(Request(11, Command.P, 0xFA01, 10_000)) is None
