"""MODBUS-RTU frames that no manual prints: what is refused, and what is met with silence."""

import pytest

from fbgen.wire import modbus
from fbgen.wire.modbus_lengths import expected_reply_length, reply_length, request_length
from fbgen.wire.modbus_rtu import encode_reply, encode_request, parse_reply, parse_request

REQUESTS = [
    # MODBUS Application Protocol V1.1b3: the examples of 6.6 and 6.12 with 6.17, at address 17
    ("11 06 00 01 00 03", modbus.WriteRequest(17, 1, 3)),
    ("11 10 00 01 00 02 04 00 0A 01 02", modbus.WriteSeveralRequest(17, 1, (0x000A, 0x0102))),
    (
        "11 17 00 03 00 06 00 0E 00 03 06 00 FF 00 FF 00 FF",
        modbus.ReadWriteRequest(17, 3, 6, 14, (0xFF, 0xFF, 0xFF)),
    ),
    ("11 03 00 6B 00 03", modbus.ReadRequest(17, 107, 3)),
    ("11 2B 0E 04 02", modbus.IdentifyRequest(17, 4, 2)),
    ("00 06 FA 00 C4 00", modbus.WriteRequest(modbus.BROADCAST, 0xFA00, 0xC400)),
]
REPLIES = [
    ("11 03 06 02 2B 00 00 00 64", modbus.ReadReply(17, (0x022B, 0, 100))),
    ("11 06 00 01 00 03", modbus.WriteReply(17, 1, 3)),
    ("11 10 00 01 00 02", modbus.WriteSeveralReply(17, 1, 2)),
    ("11 17 04 00 FE 0A CD", modbus.ReadWriteReply(17, (0x00FE, 0x0ACD))),
    ("11 2B 0E 01 81 FF 02 01 00 01 41", modbus.IdentifyReply(17, 1, 0x81, ((0, b"A"),), True, 2)),
    ("11 97 02", modbus.ExceptionReply(17, 0x17, 2)),
]


@pytest.mark.parametrize(("payload", "request_"), REQUESTS)
def test_request_is_written_and_read(payload: str, request_: modbus.Request) -> None:
    frame = modbus.seal(bytes.fromhex(payload))
    assert encode_request(request_) == frame
    assert parse_request(frame) == request_
    assert request_length(frame) == len(frame)


@pytest.mark.parametrize(("payload", "reply"), REPLIES)
def test_reply_is_written_and_read(payload: str, reply: modbus.Reply) -> None:
    frame = modbus.seal(bytes.fromhex(payload))
    assert encode_reply(reply) == frame
    assert parse_reply(frame) == reply
    assert reply_length(frame) == len(frame)


def test_check_sum_is_the_one_that_the_specification_works_out() -> None:
    # MODBUS over Serial Line V1.02, 6.2.2: the frame 02 07 has 12 41 behind it
    assert modbus.crc(b"\x02\x07") == 0x4112
    assert modbus.crc(b"\x02\x07\x41\x12") == 0


@pytest.mark.parametrize(
    ("payload", "error"),
    [
        ("01 04 FD 00 00 01", modbus.ExceptionCode.FUNCTION),
        ("01 00 00 00", modbus.ExceptionCode.FUNCTION),
        ("01 2B 0D 01 00", modbus.ExceptionCode.FUNCTION),
        ("01 03 FD 00 00 00", modbus.ExceptionCode.VALUE),
        ("01 03 FD 00 00 7E", modbus.ExceptionCode.VALUE),
        ("01 10 18 70 00 00 00", modbus.ExceptionCode.VALUE),
        ("01 10 18 70 00 03 04 C4 00 17 70", modbus.ExceptionCode.VALUE),
        ("01 17 18 75 00 00 18 70 00 01 02 C4 00", modbus.ExceptionCode.VALUE),
        ("01 17 18 75 00 01 18 70 00 02 02 C4 00", modbus.ExceptionCode.VALUE),
        ("01 2B 0E 00 00", modbus.ExceptionCode.VALUE),
        ("01 2B 0E 05 00", modbus.ExceptionCode.VALUE),
    ],
)
def test_frame_in_good_form_with_wrong_content_is_refused(
    payload: str, error: modbus.ExceptionCode
) -> None:
    frame = bytes.fromhex(payload)
    assert parse_request(modbus.seal(frame)) == modbus.BadRequest(1, frame[1], error)


@pytest.mark.parametrize(
    "payload",
    [
        "01 03 FD 00 00",
        "01 03 FD 00 00 01 00",
        "01 06 FA 00 C4",
        "01 10 18 70 00 02 04 C4 00",
        "01 10 18 70",
        "01 17 18 75 00 01 18 70 00 01 02 C4",
        "01 17 18",
        "01 2B 0E 01",
        "01 83 03",
        "F8 03 FD 00 00 01",
    ],
)
def test_frame_of_a_wrong_length_or_for_nobody_is_met_with_silence(payload: str) -> None:
    assert parse_request(modbus.seal(bytes.fromhex(payload))) is None


@pytest.mark.parametrize(
    "payload",
    [
        "01 03 01 17",
        "01 03 03 17 70 00",
        "01 03 00",
        "01 03 04 17 70",
        "01 06 FA 00 C4",
        "01 10 18 70 00 00",
        "01 10 18 70 00",
        "01 17 02 17",
        "01 2B 0E 01 01 00 00 01 00 02 41",
        "01 2B 0E 01 01 00 00 02 00 01 41",
        "01 2B 0E 01 01 01 00 00",
        "01 2B 0E 00 01 00 00 00",
        "01 2B 0D 01 01 00 00 00",
        "01 83 00",
        "01 83 03 00",
        "01 04 02 17 70",
        "00 03 02 17 70",
        "F8 03 02 17 70",
    ],
)
def test_what_is_not_a_right_reply_is_none(payload: str) -> None:
    assert parse_reply(modbus.seal(bytes.fromhex(payload))) is None


@pytest.mark.parametrize("frame", [b"", b"\x01", b"\xff\xff", b"\x01\x7e\x80", bytes(257)])
def test_what_is_no_frame_at_all_is_none(frame: bytes) -> None:
    assert parse_request(frame) is None
    assert parse_reply(frame) is None


@pytest.mark.parametrize(
    "request_",
    [
        modbus.ReadRequest(248, 0xFD00),
        modbus.ReadRequest(-1, 0xFD00),
        modbus.ReadRequest(1, 0x10000),
        modbus.ReadRequest(1, 0, 0),
        modbus.ReadRequest(1, 0, 126),
        modbus.WriteRequest(1, 0, -1),
        modbus.WriteSeveralRequest(1, 0, ()),
        modbus.WriteSeveralRequest(1, 0, (0,) * 124),
        modbus.WriteSeveralRequest(1, 0, (0x10000,)),
        modbus.ReadWriteRequest(1, 0, 1, 0, (0,) * 122),
        modbus.ReadWriteRequest(1, 0, 126, 0, (0,)),
        modbus.IdentifyRequest(1, 5),
        modbus.IdentifyRequest(1, 4, 256),
    ],
)
def test_request_that_no_frame_can_say_is_a_value_error(request_: modbus.Request) -> None:
    with pytest.raises(ValueError, match=r"cannot be|no frame|not possible|no identification"):
        encode_request(request_)


@pytest.mark.parametrize(
    "reply",
    [
        modbus.ReadReply(0, (1,)),
        modbus.ReadReply(1, ()),
        modbus.ReadWriteReply(1, (0,) * 126),
        modbus.WriteReply(1, 0, 0x10000),
        modbus.WriteSeveralReply(1, 0, 0),
        modbus.IdentifyReply(1, 0, 1, ()),
        modbus.IdentifyReply(1, 1, 1, ((0, bytes(250)),)),
        modbus.IdentifyReply(1, 1, 1, ((256, b""),)),
        modbus.ExceptionReply(1, 0x83, 3),
        modbus.ExceptionReply(1, 0x03, 0),
    ],
)
def test_reply_that_no_frame_can_say_is_a_value_error(reply: modbus.Reply) -> None:
    with pytest.raises(ValueError, match=r"cannot come|no frame|not possible|no id|no dev|not fit"):
        encode_reply(reply)


@pytest.mark.parametrize(
    ("request_", "length"),
    [
        (modbus.ReadRequest(1, 0xFD00), 7),
        (modbus.ReadRequest(1, 0xFD00, 8), 21),
        (modbus.WriteRequest(1, 0xFA00, 0), 8),
        (modbus.WriteSeveralRequest(1, 0x1870, (0, 0)), 8),
        (modbus.ReadWriteRequest(1, 0x1875, 5, 0x1870, (0, 0)), 15),
        (modbus.IdentifyRequest(1), None),
        (modbus.WriteRequest(modbus.BROADCAST, 0xFA00, 0), None),
    ],
)
def test_master_knows_how_long_a_reply_will_be(
    request_: modbus.Request, length: int | None
) -> None:
    assert expected_reply_length(request_) == length


@pytest.mark.parametrize(("payload", "_request"), REQUESTS)
def test_length_of_a_request_is_open_until_its_count_is_there(
    payload: str, _request: modbus.Request
) -> None:
    frame = modbus.seal(bytes.fromhex(payload))
    lengths = [request_length(frame[:end]) for end in range(len(frame) + 1)]
    known = lengths.index(len(frame))
    assert lengths == [None] * known + [len(frame)] * (len(frame) + 1 - known)


@pytest.mark.parametrize(("payload", "_reply"), REPLIES)
def test_length_of_a_reply_is_open_until_its_count_is_there(
    payload: str, _reply: modbus.Reply
) -> None:
    frame = modbus.seal(bytes.fromhex(payload))
    lengths = [reply_length(frame[:end]) for end in range(len(frame) + 1)]
    known = lengths.index(len(frame))
    assert lengths == [None] * known + [len(frame)] * (len(frame) + 1 - known)


def test_function_that_is_none_has_no_length() -> None:
    assert request_length(b"\x01\x04") == 0
    assert reply_length(b"\x01\x04") == 0
