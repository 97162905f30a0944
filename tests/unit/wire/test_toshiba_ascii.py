"""ASCII frames character for character, with the source of each."""

import pytest

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
from fbgen.wire.toshiba_ascii import encode_reply, encode_request, parse_reply, parse_request


def _request(address: Address, command: Command, com_no: int, data: int, checked: bool) -> Request:
    return Request(address, command, com_no, data, Form.ASCII, checked)


REQUESTS = [
    # VF-AS1 RS485 manual E6581315, pp. 7, 17, 45
    (b"(R0000&60)\r", _request(None, Command.R, 0, 0, True)),
    (b"(W00100064)\r", _request(None, Command.W, 0x0010, 100, False)),
    (b"(PFA008400)\r", _request(None, Command.P, 0xFA00, 0x8400, False)),
    # broadcast, VF-AS3 manual: 60 Hz to all
    (b"(**PFA011770)\r", _request(BROADCAST, Command.P, 0xFA01, 6000, False)),
    # groups, VF-S11 manual E6581222, pp. 9, 22
    (b"(*2PFA001770)\r", _request(Group(None, 2), Command.P, 0xFA00, 6000, False)),
    (b"(1*PFA001770)\r", _request(Group(1, None), Command.P, 0xFA00, 6000, False)),
    (b"(11RFE03)\r", _request(11, Command.R, 0xFE03, 0, False)),
    (b"(99RFE03&00)\r", _request(99, Command.R, 0xFE03, 0, True)),
]


@pytest.mark.parametrize(("frame", "request_"), REQUESTS)
def test_request_is_written_and_read_as_the_manual_prints_it(
    frame: bytes, request_: Request
) -> None:
    assert encode_request(request_) == frame
    assert parse_request(frame) == request_


@pytest.mark.parametrize(
    ("frame", "reply"),
    [
        # VF-AS1 RS485 manual E6581315, example (RFE03) -> (RFE03077B)
        (b"(RFE03077B)\r", Reply(None, Command.R, 0xFE03, 0x077B, False, Form.ASCII, False)),
        (b"(11rFC900018)\r", Reply(11, Command.R, 0xFC90, 0x18, True, Form.ASCII, False)),
        (b"(N0003)\r", ErrorReply(None, ErrorCode.COMMAND, False, Form.ASCII, False)),
        (b"(11n0002&E0)\r", ErrorReply(11, ErrorCode.COM_NO, True, Form.ASCII, True)),
    ],
)
def test_reply_is_written_and_read(frame: bytes, reply: Reply | ErrorReply) -> None:
    assert encode_reply(reply) == frame
    assert parse_reply(frame) == reply


@pytest.mark.parametrize(
    ("frame", "error"),
    [
        (b"(11PFA008400&00)\r", ErrorCode.CHECKSUM),
        (b"(11QFA008400)\r", ErrorCode.COMMAND),
        (b"(11GFA008400)\r", ErrorCode.COMMAND),
        (b"(11pFA008400)\r", ErrorCode.COMMAND),
        (b"(11PFA0084000)\r", ErrorCode.DATA),
        (b"(11PFA00)\r", ErrorCode.DATA),
    ],
)
def test_frame_in_good_form_with_wrong_content_is_refused(frame: bytes, error: ErrorCode) -> None:
    refused = parse_request(frame)
    assert isinstance(refused, BadRequest)
    assert refused.error is error
    assert refused.address == 11


@pytest.mark.parametrize(
    "frame",
    [
        b"(1RFE03)\r",
        b"(111RFE03)\r",
        b"(*RFE03)\r",
        b"(RFE0)\r",
        b"(RFE0G)\r",
        b"(PFA00X400)\r",
        b"(RFE03&6)\r",
        b"(RFE03&XX)\r",
        b"(11PFA0000000000&00)\r",
        b"()\r",
        b"(&28)\r",
        b"(11)\r",
        b"RFE03)\r",
        b"(RFE03)",
    ],
)
def test_frame_in_wrong_form_is_ignored(frame: bytes) -> None:
    assert parse_request(frame) is None


@pytest.mark.parametrize(
    "frame", [b"(RFE03077B&00)\r", b"(N0009)\r", b"(N00)\r", b"(GFE03077B)\r", b"(RFE0307)\r"]
)
def test_what_is_not_a_right_reply_is_none(frame: bytes) -> None:
    assert parse_reply(frame) is None


def test_short_data_are_a_number_too() -> None:
    assert parse_request(b"(W001064)\r") == _request(None, Command.W, 0x0010, 0x64, False)


def test_ascii_has_no_g_and_no_number_over_99() -> None:
    with pytest.raises(ValueError, match="no command G"):
        encode_request(_request(0, Command.G, 0xFE03, 0, False))
    with pytest.raises(ValueError, match="cannot be addressed"):
        encode_request(_request(100, Command.R, 0xFE03, 0, False))


def test_group_says_whom_it_means_and_who_answers() -> None:
    assert Group(None, 2).includes(42)
    assert not Group(None, 2).includes(24)
    assert Group(1, None).includes(19)
    assert not Group(1, None).includes(21)
    assert (Group(None, 2).lowest, Group(1, None).lowest) == (2, 10)
