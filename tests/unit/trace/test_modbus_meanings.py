"""Frames of MODBUS-RTU in words: a reply says which ComNos its words are of."""

import pytest

from fbgen.catalog import load_catalog
from fbgen.wire.modbus import seal
from harness.trace.modbus_meanings import ModbusMeanings

CATALOG = load_catalog()


@pytest.fixture
def meanings() -> ModbusMeanings:
    return ModbusMeanings({1: CATALOG.drive("vf-s11"), 2: CATALOG.drive("vf-s15")})


def frame(payload: str) -> bytes:
    return seal(bytes.fromhex(payload))


@pytest.mark.parametrize(
    ("payload", "meaning"),
    [
        ("01 03 FE 03 00 01", "drive 1: read FE03"),
        ("02 03 FD 00 00 02", "drive 2: read FD00 Output frequency and 1 more"),
        ("01 06 FA 01 0F A0", "drive 1: write FA01 Frequency set-point = 0FA0 (40.00 Hz)"),
        ("00 06 FA 00 08 00", "all drives: write FA00 Command word = 0800 (coast_stop)"),
        ("02 10 FA 00 00 02 04 C4 00 0F A0", "write FA00 Command word = C400 (network_command"),
        ("02 2B 0E 01 00", "drive 2: who is it?"),
        ("02 42 00 00", "drive 2: function 42, which it refuses"),
    ],
)
def test_a_request_in_words(meanings: ModbusMeanings, payload: str, meaning: str) -> None:
    kind, text = meanings.of(frame(payload), to_drives=True)
    assert kind == "request"
    assert meaning in text


@pytest.mark.parametrize(
    ("asked", "payload", "kind", "meaning"),
    [
        (
            "01 03 FD 00 00 01",
            "01 03 02 0F A0",
            "reply",
            "FD00 Output frequency is 0FA0 (40.00 Hz)",
        ),
        ("02 03 FD 00 00 01", "01 03 02 0F A0", "reply", "drive 1: 0FA0"),
        ("01 03 FD 00 00 01", "01 83 02", "refusal", "drive 1 refuses: there is no such ComNo"),
        ("01 03 FD 00 00 01", "01 83 09", "refusal", "drive 1 refuses: exception 09"),
        ("01 06 FA 01 0F A0", "01 06 FA 01 0F A0", "reply", "FA01 Frequency set-point is 0FA0"),
        ("02 10 FA 00 00 02 04 C4 00 0F A0", "02 10 FA 00 00 02", "reply", "and 1 more written"),
    ],
)
def test_a_reply_says_what_was_asked(
    meanings: ModbusMeanings, asked: str, payload: str, kind: str, meaning: str
) -> None:
    meanings.of(frame(asked), to_drives=True)
    found = meanings.of(frame(payload), to_drives=False)
    assert found[0] == kind
    assert meaning in found[1]


@pytest.mark.parametrize("to_drives", [True, False])
def test_bytes_that_are_no_frame_say_nothing(meanings: ModbusMeanings, to_drives: bool) -> None:
    assert meanings.of(b"\x01\x03\xfe\x03", to_drives) == ("unknown", "")


def test_the_same_reply_to_another_request_says_something_else(meanings: ModbusMeanings) -> None:
    said = []
    for asked in ("01 03 FD 00 00 01", "01 03 FD 02 00 01"):
        meanings.of(frame(asked), to_drives=True)
        said.append(meanings.of(frame("01 03 02 0F A0"), to_drives=False)[1])
    assert said[0] != said[1]
