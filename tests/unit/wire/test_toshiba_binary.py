"""Binary frames byte for byte. Vectors are written out with their source, nothing derives them."""

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
    checksum,
    is_sealed,
    seal,
)
from fbgen.wire.toshiba_binary import encode_reply, encode_request, parse_reply, parse_request

REQUESTS = [
    # TOSPBDP001 manual, section 8 G, rows 1 to 4, with 2FH and SUM of the drive's protocol
    ("2F 0B 50 FA 00 C4 00 48", Request(0x0B, Command.P, 0xFA00, 0xC400)),
    ("2F 0B 50 FA 01 13 88 20", Request(0x0B, Command.P, 0xFA01, 5000)),
    ("2F 0B 47 FE 03 00 00 82", Request(0x0B, Command.G, 0xFE03, 0)),
    ("2F 0B 50 FA 00 C2 00 46", Request(0x0B, Command.P, 0xFA00, 0xC200)),
    # TOSPBDP001 manual, section 7: fault reset of all drives
    ("2F FF 50 FA 00 20 00 98", Request(BROADCAST, Command.P, 0xFA00, 0x2000)),
    # reading the trip code of drive 11, E6581222 p. 11 for the form
    ("2F 0B 47 FC 90 00 00 0D", Request(0x0B, Command.G, 0xFC90, 0)),
    ("2F 0B 52 FC 90 18", Request(0x0B, Command.R, 0xFC90, 0)),
    # without INV-NO, E6581222 p. 11
    ("2F 52 FC 90 0D", Request(None, Command.R, 0xFC90, 0)),
    ("2F 57 00 10 00 64 FA", Request(None, Command.W, 0x0010, 100)),
    # between drives, VF-AS1 RS485 manual pp. 19, 39
    ("2F FF 53 FA 01 27 10 B3", Request(BROADCAST, Command.S, 0xFA01, 10000)),
    ("2F FF 73 FA 01 27 10 D3", Request(BROADCAST, Command.S_TRIPPED, 0xFA01, 10000)),
]

REPLIES = [
    ("2F 0B 50 FA 00 C4 00 48", Reply(0x0B, Command.P, 0xFA00, 0xC400)),
    ("2F 0B 47 FE 03 10 E8 7A", Reply(0x0B, Command.G, 0xFE03, 4328)),
    # tripped: lower case, VF-S11 manual E6581222 pp. 9, 12
    ("2F 0B 67 FC 90 00 18 45", Reply(0x0B, Command.G, 0xFC90, 0x18, tripped=True)),
    # VF-S15 RS485 manual E6581913, p. 12
    ("2F 4E 00 00 7D", ErrorReply(None, ErrorCode.CANNOT_EXECUTE)),
    ("2F 4E 00 04 81", ErrorReply(None, ErrorCode.CHECKSUM)),
    ("2F 0B 4E 00 01 89", ErrorReply(0x0B, ErrorCode.DATA)),
    ("2F 0B 6E 00 02 AA", ErrorReply(0x0B, ErrorCode.COM_NO, tripped=True)),
]


@pytest.mark.parametrize(("frame", "request_"), REQUESTS)
def test_request_is_written_and_read_as_the_manual_prints_it(frame: str, request_: Request) -> None:
    assert encode_request(request_) == bytes.fromhex(frame)
    assert parse_request(bytes.fromhex(frame)) == request_


@pytest.mark.parametrize(("frame", "reply"), REPLIES)
def test_reply_is_written_and_read_as_the_manual_prints_it(
    frame: str, reply: Reply | ErrorReply
) -> None:
    assert encode_reply(reply) == bytes.fromhex(frame)
    assert parse_reply(bytes.fromhex(frame)) == reply


def test_checksum_of_the_block_frames_of_the_manual() -> None:
    # VF-AS1 RS485 manual, pp. 16 and 19
    request = bytes.fromhex("2F 58 02 05 C4 00 17 70 D9")
    reply = bytes.fromhex("2F 59 05 00 64 00 17 70 1A 8A 24 FD 00 00 3D")
    assert checksum(request[:-1]) == 0xD9
    assert is_sealed(request)
    assert is_sealed(reply)
    assert seal(reply[1:-1]) == reply


def test_wrong_checksum_is_refused_with_error_4() -> None:
    frame = bytes.fromhex("2F 0B 50 FA 00 C4 00 49")
    assert parse_request(frame) == BadRequest(0x0B, ErrorCode.CHECKSUM)


def test_frame_of_cleared_outputs_is_no_request() -> None:
    # what a gateway makes of six zero bytes: sealed, but CMD 00 is none
    frame = seal(bytes(6))
    assert frame == bytes.fromhex("2F 00 00 00 00 00 00 2F")
    assert parse_request(frame) is None


@pytest.mark.parametrize(
    "frame", ["", "2F", "2F 0B", "2F 0B 50 FA 00 C4 00", "2F 0B 50 FA 00 C4 00 48 00", "2F 0B 4E"]
)
def test_what_is_not_exactly_one_request_is_none(frame: str) -> None:
    assert parse_request(bytes.fromhex(frame)) is None


@pytest.mark.parametrize("frame", ["2F 0B 67 FC 90 00 18 46", "2F 0B 4E 00 05 8D", "2F 0B 53"])
def test_what_is_not_a_right_reply_is_none(frame: str) -> None:
    assert parse_reply(bytes.fromhex(frame)) is None


@pytest.mark.parametrize("address", [Group(None, 2), 64, 254])
def test_binary_has_no_groups_and_no_number_over_63(address: int | Group) -> None:
    with pytest.raises(ValueError, match="cannot be addressed"):
        encode_request(Request(address, Command.P, 0xFA00, 0))


@pytest.mark.parametrize("frame", [b"", b"/", b"/\x00", b"(R0000)\r"])
def test_what_has_no_start_code_or_a_wrong_sum_is_not_sealed(frame: bytes) -> None:
    assert not is_sealed(frame)
