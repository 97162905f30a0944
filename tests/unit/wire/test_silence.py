"""How silence parts frames: of MODBUS-RTU, and of the Toshiba protocol of VF-AS1 and VF-S15."""

import pytest

from fbgen.wire import modbus_stream, toshiba_stream
from fbgen.wire.modbus import BadRequest, ReadReply, ReadRequest, Request
from fbgen.wire.silence import SilenceStream, SilentIntervals, characters_ns
from fbgen.wire.toshiba import Command
from fbgen.wire.toshiba import Request as ToshibaRequest
from fbgen.wire.toshiba_block import BlockReply, BlockRequest

BAUD = 19_200
BYTE_NS = characters_ns(1, BAUD)
SILENCES = modbus_stream.silent_intervals(BAUD)
READ = bytes.fromhex("01 03 FD 00 00 01 B5 A6")
REQUEST = ReadRequest(1, 0xFD00)
END_NS = len(READ) * BYTE_NS

Heard = tuple[Request | BadRequest, ...]


def stream() -> SilenceStream[Request | BadRequest]:
    return modbus_stream.request_stream(SILENCES)


def parted(at: int, gap_ns: int) -> Heard:
    """What is heard of the frame with a silence inside."""
    listening = stream()
    heard = listening.feed(READ[:at], 0, BYTE_NS)
    start_ns = at * BYTE_NS + gap_ns
    heard += listening.feed(READ[at:], start_ns, BYTE_NS)
    return heard + listening.end(start_ns + (len(READ) - at) * BYTE_NS + SILENCES.frame_ns)


@pytest.mark.parametrize(
    ("baud", "intervals"),
    [
        (9600, SilentIntervals(4_010_417, 1_718_750)),
        (19_200, SilentIntervals(2_005_208, 859_375)),
        (19_201, SilentIntervals(1_750_000, 750_000)),
        (38_400, SilentIntervals(1_750_000, 750_000)),
        (115_200, SilentIntervals(1_750_000, 750_000)),
    ],
)
def test_silences_of_modbus_are_fixed_above_19200(baud: int, intervals: SilentIntervals) -> None:
    assert modbus_stream.silent_intervals(baud) == intervals


@pytest.mark.parametrize(("baud", "about_ms"), [(9600, 4), (19_200, 2), (38_400, 1)])
def test_silence_of_the_toshiba_protocol_is_what_the_manual_says(baud: int, about_ms: int) -> None:
    # VF-S15 RS485 manual E6581913, p. 5: about 4, 2 and 1 ms
    intervals = toshiba_stream.silent_intervals(baud)
    assert round(intervals.frame_ns / 1e6) == about_ms
    assert intervals.inside_ns == intervals.frame_ns


def test_message_is_there_when_the_silence_behind_it_is_over() -> None:
    listening = stream()
    assert listening.feed(READ, 0, BYTE_NS) == ()
    assert listening.ends_ns == END_NS + SILENCES.frame_ns
    assert listening.end(listening.ends_ns - 1) == ()
    assert listening.end(listening.ends_ns) == (REQUEST,)
    assert listening.ends_ns is None
    assert listening.end(2 * END_NS) == ()


def test_who_asks_nobody_hears_of_the_frame_with_the_next_bytes() -> None:
    listening = stream()
    listening.feed(READ, 0, BYTE_NS)
    assert listening.feed(READ, END_NS + SILENCES.frame_ns, BYTE_NS) == (REQUEST,)


def test_frames_without_silence_between_them_are_one_and_none() -> None:
    listening = stream()
    listening.feed(READ + READ, 0, BYTE_NS)
    assert listening.end(3 * END_NS) == ()


def test_silence_of_one_and_a_half_characters_does_no_harm() -> None:
    assert parted(3, SILENCES.inside_ns) == (REQUEST,)


@pytest.mark.parametrize("at", range(1, len(READ)))
def test_longer_silence_inside_spoils_the_frame(at: int) -> None:
    assert parted(at, SILENCES.inside_ns + 1) == ()
    assert parted(at, SILENCES.frame_ns - 1) == ()
    assert parted(at, SILENCES.frame_ns) == ()


@pytest.mark.parametrize("bad", range(len(READ)))
def test_byte_with_an_error_spoils_the_frame_and_nothing_else(bad: int) -> None:
    listening = stream()
    marks = bytes(index == bad for index in range(len(READ)))
    assert listening.feed(READ, 0, BYTE_NS, marks) == ()
    assert listening.ends_ns is None
    assert listening.feed(READ, END_NS + SILENCES.frame_ns, BYTE_NS, bytes(len(READ))) == ()
    assert listening.end(3 * END_NS + SILENCES.frame_ns) == (REQUEST,)


def test_rest_of_a_spoiled_frame_is_dropped_up_to_the_next_silence() -> None:
    listening = stream()
    listening.feed(b"\x01", 0, BYTE_NS, b"\x01")
    listening.feed(READ, BYTE_NS, BYTE_NS)
    assert listening.end(3 * END_NS) == ()


def test_endless_bytes_take_no_room() -> None:
    listening = stream()
    for index in range(100):
        listening.feed(bytes(8), 8 * index * BYTE_NS, BYTE_NS)
        assert len(listening.pending) <= 256
    assert listening.end(10_000 * BYTE_NS) == ()
    assert listening.feed(READ, 20_000 * BYTE_NS, BYTE_NS) == ()
    assert listening.end(30_000 * BYTE_NS) == (REQUEST,)


def test_frame_on_its_way_at_power_on_is_not_understood() -> None:
    listening = stream()
    listening.reset(0)
    listening.feed(READ, SILENCES.frame_ns - 1, BYTE_NS)
    assert listening.end(10 * END_NS) == ()
    listening.reset(0)
    listening.feed(READ, SILENCES.frame_ns, BYTE_NS)
    assert listening.end(10 * END_NS) == (REQUEST,)


def test_nothing_heard_changes_nothing() -> None:
    listening = stream()
    listening.feed(READ, 0, BYTE_NS)
    assert listening.feed(b"", 5 * END_NS, BYTE_NS) == ()
    assert listening.end(5 * END_NS) == (REQUEST,)


def test_master_hears_replies() -> None:
    listening = modbus_stream.reply_stream(SILENCES)
    listening.feed(bytes.fromhex("01 03 02 17 70 B6 50"), 0, BYTE_NS)
    assert listening.end(END_NS + SILENCES.frame_ns) == (ReadReply(1, (0x1770,)),)


@pytest.mark.parametrize("text", [b"(11PFA008400)\r", b"(PFA008400)\r"])
def test_toshiba_frame_between_silences_may_be_ascii(text: bytes) -> None:
    listening = toshiba_stream.silence_request_stream(toshiba_stream.silent_intervals(BAUD))
    listening.feed(text, 0, BYTE_NS)
    (heard,) = listening.end(100 * BYTE_NS)
    assert isinstance(heard, ToshibaRequest)
    assert (heard.command, heard.data) == (Command.P, 0x8400)


def test_toshiba_frame_between_silences_is_whole_or_nothing() -> None:
    # by start code and length the frame would be heard in spite of the byte before it
    frame = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")
    intervals = toshiba_stream.silent_intervals(BAUD)
    listening = toshiba_stream.silence_request_stream(intervals)
    listening.feed(b"\x00" + frame, 0, BYTE_NS)
    assert listening.end(100 * BYTE_NS) == ()
    listening.feed(frame[:4], 200 * BYTE_NS, BYTE_NS)
    gap_ns = intervals.frame_ns - 1
    listening.feed(frame[4:], 204 * BYTE_NS + gap_ns, BYTE_NS)
    assert len(listening.end(300 * BYTE_NS)) == 1


def test_toshiba_blocks_are_heard_between_silences() -> None:
    intervals = toshiba_stream.silent_intervals(BAUD)
    drive = toshiba_stream.silence_request_stream(intervals)
    drive.feed(bytes.fromhex("2F 58 02 05 C4 00 17 70 D9"), 0, BYTE_NS)
    assert drive.end(100 * BYTE_NS) == (BlockRequest(None, (0xC400, 0x1770), 5),)
    master = toshiba_stream.silence_reply_stream(intervals)
    master.feed(bytes.fromhex("2F 59 01 00 17 70 10"), 0, BYTE_NS)
    assert master.end(100 * BYTE_NS) == (BlockReply(None, (0x1770,)),)


def test_a_frame_for_somebody_else_is_skipped_up_to_the_next_silence() -> None:
    frame = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")
    intervals = toshiba_stream.silent_intervals(BAUD)
    listening = toshiba_stream.silence_request_stream(intervals)
    listening.feed(frame[:4], 0, BYTE_NS)
    listening.skip()
    listening.feed(frame[4:], 4 * BYTE_NS, BYTE_NS)
    assert (listening.pending, listening.ends_ns) == (b"", None)
    assert listening.feed(frame, 100 * BYTE_NS, BYTE_NS) == ()
    assert len(listening.end(200 * BYTE_NS)) == 1
