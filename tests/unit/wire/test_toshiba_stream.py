"""How a drive finds frames in what comes over the line."""

import pytest

from fbgen.wire.toshiba import BadRequest, Command, ErrorCode, Form, Reply, Request
from fbgen.wire.toshiba_stream import FRAME_TIMEOUT_NS, reply_stream, request_stream

BYTE_NS = 572_916
RUN = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")
RUN_REQUEST = Request(0x0B, Command.P, 0xFA00, 0xC400)
HEARTBEAT = b"(**P08800001)\r"


def hear(data: bytes, marks: bytes | None = None) -> tuple[Request | BadRequest, ...]:
    return request_stream().feed(data, 0, BYTE_NS, marks)


def test_frame_comes_out_when_its_last_byte_is_there() -> None:
    stream = request_stream()
    assert stream.feed(RUN[:-1], 0, BYTE_NS) == ()
    assert stream.feed(RUN[-1:], 10 * BYTE_NS, BYTE_NS) == (RUN_REQUEST,)
    assert not stream.pending


def test_bytes_before_the_start_code_are_dropped() -> None:
    assert hear(b"\x00\xff\x50\r)" + RUN) == (RUN_REQUEST,)


def test_start_code_decides_between_ascii_and_binary_frame_by_frame() -> None:
    heard = hear(HEARTBEAT + RUN + HEARTBEAT)
    assert [message.form for message in heard] == [Form.ASCII, Form.BINARY, Form.ASCII]


def test_of_several_start_codes_the_last_is_valid() -> None:
    assert hear(b"\x2f\x2f\x2f" + RUN[1:]) == (RUN_REQUEST,)


def test_start_code_among_the_data_means_nothing() -> None:
    # FA01 = 122FH, 46.55 Hz
    frame = bytes.fromhex("2F 0B 50 FA 01 12 2F C6")
    assert hear(frame) == (Request(0x0B, Command.P, 0xFA01, 0x122F),)


def test_drive_with_number_2f_can_be_reached() -> None:
    frame = bytes.fromhex("2F 2F 47 FC 90 00 00 31")
    assert hear(frame) == (Request(0x2F, Command.G, 0xFC90),)


def test_frame_of_cleared_outputs_does_not_swallow_what_follows() -> None:
    cleared = bytes.fromhex("2F 00 00 00 00 00 00 2F")
    stream = request_stream()
    assert stream.feed(cleared, 0, BYTE_NS) == ()
    heard = stream.feed(HEARTBEAT, 400_000_000, BYTE_NS)
    assert [message.form for message in heard] == [Form.ASCII]
    assert hear(cleared + RUN) == (RUN_REQUEST,)


def test_incomplete_frame_is_forgotten_after_half_a_second() -> None:
    stream = request_stream()
    stream.feed(RUN[:3], 0, BYTE_NS)
    assert stream.feed(RUN, FRAME_TIMEOUT_NS + BYTE_NS, BYTE_NS) == (RUN_REQUEST,)


def test_incomplete_frame_takes_bytes_of_the_next_within_half_a_second() -> None:
    stream = request_stream()
    stream.feed(RUN[:7], 0, BYTE_NS)
    assert stream.feed(RUN, FRAME_TIMEOUT_NS - BYTE_NS, BYTE_NS) == (
        BadRequest(0x0B, ErrorCode.CHECKSUM),
    )


def test_time_out_counts_from_the_start_code() -> None:
    stream = request_stream()
    stream.feed(RUN[:4], 0, BYTE_NS)
    assert stream.feed(RUN[4:], FRAME_TIMEOUT_NS, BYTE_NS) == ()
    assert not stream.pending


@pytest.mark.parametrize("bad", range(len(RUN)))
def test_parity_or_framing_error_in_a_frame_means_silence(bad: int) -> None:
    marks = bytes(1 if index == bad else 0 for index in range(len(RUN)))
    assert hear(RUN, marks) == ()


def test_next_frame_after_a_damaged_one_is_heard() -> None:
    marks = bytes([0, 0, 0, 1, 0, 0, 0, 0])
    stream = request_stream()
    stream.feed(RUN, 0, BYTE_NS, marks)
    assert stream.feed(RUN, 20 * BYTE_NS, BYTE_NS) == (RUN_REQUEST,)


def test_unknown_command_is_met_with_silence_in_binary() -> None:
    assert hear(bytes.fromhex("2F 0B 51 FA 00 C4 00 49")) == ()


def test_ascii_frame_begins_anew_at_the_next_start_code() -> None:
    assert hear(b"(11PFA" + RUN) == (RUN_REQUEST,)
    assert len(hear(b"(11PFA" + HEARTBEAT)) == 1


def test_ascii_frame_of_more_than_17_characters_is_dropped() -> None:
    assert hear(b"(11PFA0000000000&00)\r" + RUN) == (RUN_REQUEST,)


def test_reset_forgets_a_frame_in_progress() -> None:
    stream = request_stream()
    stream.feed(RUN[:4], 0, BYTE_NS)
    stream.reset()
    assert stream.feed(RUN, BYTE_NS, BYTE_NS) == (RUN_REQUEST,)


def test_master_finds_replies_and_refusals_by_their_length() -> None:
    frames = bytes.fromhex("2F 0B 67 FC 90 00 18 45 2F 0B 4E 00 01 89")
    heard = reply_stream().feed(frames, 0, BYTE_NS)
    assert heard[0] == Reply(0x0B, Command.G, 0xFC90, 0x18, tripped=True)
    assert len(heard) == 2
