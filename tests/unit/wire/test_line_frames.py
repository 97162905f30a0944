"""Frames out of what somebody hears who only listens, both directions mixed."""

from random import Random

import pytest

from fbgen.wire import toshiba_binary
from fbgen.wire.line_frames import NS_PER_MS, FrameSplitter, LineFrame
from fbgen.wire.line_protocols import LINE_PROTOCOLS, LineProtocol
from fbgen.wire.modbus import seal
from fbgen.wire.toshiba import Command, Request
from tests.vectors.reading import entries

TOSHIBA, MODBUS = LINE_PROTOCOLS["toshiba"], LINE_PROTOCOLS["modbus"]
READ, VALUE = "2F 0B 52 FD 01 8A", "2F 0B 52 FD 01 60 00 EA"
WRITE = "2F 0B 50 FA 00 C4 00 48"


def heard(splitter: FrameSplitter, *parts: tuple[float, str]) -> list[tuple[str, str]]:
    """Direction and bytes of the frames in what comes at these milliseconds."""
    found: list[LineFrame] = []
    for at_ms, text in parts:
        found += splitter.feed(bytes.fromhex(text), round(at_ms * NS_PER_MS))
    found += splitter.flush()
    return [(frame.direction, frame.data.hex(" ").upper()) for frame in found]


def test_a_request_and_its_reply_are_told_apart_although_they_look_alike() -> None:
    assert heard(FrameSplitter(TOSHIBA), (0, WRITE), (15, WRITE), (40, WRITE)) == [
        ("request", WRITE),
        ("reply", WRITE),
        ("request", WRITE),
    ]


def test_who_asks_again_after_long_asks() -> None:
    assert heard(FrameSplitter(TOSHIBA), (0, WRITE), (500, WRITE)) == [("request", WRITE)] * 2
    assert heard(FrameSplitter(TOSHIBA), (0, READ), (200, READ), (215, VALUE)) == [
        *(("request", READ), ("request", READ), ("reply", VALUE))
    ]


def test_bytes_may_come_one_by_one_or_all_at_once() -> None:
    stream = READ + VALUE + WRITE + WRITE
    wanted = [("request", READ), ("reply", VALUE), ("request", WRITE), ("reply", WRITE)]
    assert heard(FrameSplitter(TOSHIBA), (0, stream)) == wanted
    single = [(at, f"{byte:02X}") for at, byte in enumerate(bytes.fromhex(stream))]
    assert heard(FrameSplitter(TOSHIBA), *single) == wanted


def test_the_time_of_a_frame_is_that_of_its_first_and_last_byte() -> None:
    splitter = FrameSplitter(TOSHIBA)
    splitter.feed(bytes.fromhex(READ[:8]), 5)
    (frame,) = splitter.feed(bytes.fromhex(READ[8:]), 9)
    assert (frame.start_ns, frame.end_ns) == (5, 9)


def test_what_is_no_frame_is_told_as_unknown_bytes() -> None:
    broken = VALUE[:-2] + "00"
    assert heard(FrameSplitter(TOSHIBA), (0, READ), (15, broken), (100, READ)) == [
        *(("request", READ), ("unknown", broken), ("request", READ))
    ]
    assert heard(FrameSplitter(TOSHIBA), (0, "00 00" + READ)) == [
        *(("unknown", "00 00"), ("request", READ))
    ]


def test_silence_ends_what_has_begun() -> None:
    splitter = FrameSplitter(TOSHIBA)
    assert splitter.feed(bytes.fromhex("2F 0B 52"), 0) == []
    assert splitter.end(10 * NS_PER_MS) == []
    (frame,) = splitter.end(60 * NS_PER_MS)
    assert (frame.direction, frame.data) == ("unknown", b"\x2f\x0b\x52")
    assert splitter.idle


def test_another_drives_frame_is_no_reply() -> None:
    other = "2F 0C 50 FA 00 C4 00 49"
    assert heard(FrameSplitter(TOSHIBA), (0, WRITE), (20, other)) == [
        *(("request", WRITE), ("request", other))
    ]


def test_a_broadcast_is_answered_by_whoever_has_number_0() -> None:
    reset = "2F FF 50 FA 00 20 00 98"
    assert heard(FrameSplitter(TOSHIBA), (0, reset), (20, READ)) == [
        *(("request", reset), ("request", READ))
    ]


def test_a_set_point_of_another_drive_is_not_answered() -> None:
    frame = toshiba_binary.encode_request(Request(None, Command.S, 0xFA01, 5000)).hex(" ").upper()
    assert heard(FrameSplitter(TOSHIBA), (0, frame), (5, frame)) == [("request", frame)] * 2


@pytest.mark.parametrize("name", ["binary", "ascii"])
def test_the_manuals_requests_and_replies_are_found_in_one_stream(name: str) -> None:
    known = entries("toshiba_frames")
    for entry in known.values():
        if entry.get("mode") != name or "reply_to" not in entry or entry["kind"] != "frame":
            continue
        asked, replied = _bytes(known[entry["reply_to"]]), _bytes(entry)
        if asked is None or replied is None:
            continue
        found = heard(FrameSplitter(TOSHIBA), (0, asked), (20, replied))
        assert [way for way, _ in found] == ["request", "reply"], entry["id"]


def _bytes(entry: dict[str, str]) -> str | None:
    if "text" in entry:
        return entry["text"].encode("ascii").replace(b"\\r", b"\r").hex(" ")
    return None if "xx" in entry["bytes"] or "checksum_ok" in entry else entry["bytes"]


def test_modbus_requests_and_replies_are_told_apart() -> None:
    read, words = "01 03 FD 00 00 01 B5 A6", "01 03 02 17 70 B6 50"
    write, refused = (
        seal(bytes.fromhex(text)).hex(" ").upper() for text in ("01 06 FA 01 13 88", "01 86 02")
    )
    assert heard(FrameSplitter(MODBUS), (0, read), (20, words), (40, write), (60, write)) == [
        *(("request", read), ("reply", words), ("request", write), ("reply", write))
    ]
    assert heard(FrameSplitter(MODBUS), (0, write), (20, refused)) == [
        *(("request", write), ("reply", refused))
    ]


def test_where_only_one_direction_can_be_heard_the_other_is_unknown() -> None:
    assert heard(FrameSplitter(TOSHIBA, "reply"), (0, VALUE), (20, READ)) == [
        *(("reply", VALUE), ("unknown", READ))
    ]


@pytest.mark.parametrize("protocol", [TOSHIBA, MODBUS], ids=lambda item: item.name)
def test_every_byte_that_was_heard_is_told_once_and_in_order(protocol: LineProtocol) -> None:
    random = Random(7)
    known = [bytes.fromhex(text) for text in (READ, VALUE, WRITE, "01 03 FD 00 00 01 B5 A6")]
    for _ in range(200):
        pieces = [random.choice([*known, random.randbytes(5)]) for _ in range(6)]
        stream = bytearray(b"".join(pieces))
        if random.random() < 0.5:
            stream[random.randrange(len(stream))] ^= 1 << random.randrange(8)
        splitter = FrameSplitter(protocol)
        found: list[LineFrame] = []
        now_ns, at = 0, 0
        while at < len(stream):
            size = random.randrange(1, 12)
            now_ns += random.choice((1, 20, 90, 400)) * NS_PER_MS
            found += splitter.feed(bytes(stream[at : at + size]), now_ns)
            at += size
        found += splitter.flush()
        assert b"".join(frame.data for frame in found) == bytes(stream)
        assert all(frame.start_ns <= frame.end_ns for frame in found)
        assert splitter.idle
