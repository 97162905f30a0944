"""Frames in words: what each kind of frame is called and says."""

import pytest

from fbgen.catalog import load_catalog
from harness.trace.frame_meanings import FrameMeanings

CATALOG = load_catalog()
MEANINGS = FrameMeanings({11: CATALOG.drive("vf-s11")}, CATALOG)


@pytest.mark.parametrize(
    ("frame", "to_drives", "kind", "meaning"),
    [
        ("2F 0B 47 FE 03 00 00 82", True, "request", "drive 11: read FE03"),
        ("2F 0B 50 FA 01 0F A0 34", True, "request", "set-point = 0FA0 (40.00 Hz)"),
        ("2F FF 50 FA 00 08 00 80", True, "request", "all drives: write FA00"),
        ("2F 0B 47 FE 03 10 E8 7A", False, "reply", "is 10E8 (43.28 %)"),
        ("2F 0B 67 FC 90 00 0E 3B", False, "reply", ", tripped"),
        ("2F 0B 4E 00 01 89", False, "refusal", "drive 11 refuses: the value lies outside"),
        ("2F 0B 47 FE 03 00 00 83", True, "unknown", ""),
        ("55 55", False, "unknown", ""),
        (b"(00RFE00)\r".hex(), True, "heartbeat", "drive 0: read FE00"),
        (b"(11RFE001388)\r".hex(), False, "answer", "drive 11: FE00"),
        (b"(1*RFE00)\r".hex(), True, "heartbeat", "drives 1x: read FE00"),
    ],
)
def test_a_frame_in_words(frame: str, to_drives: bool, kind: str, meaning: str) -> None:
    found = MEANINGS.of(bytes.fromhex(frame), to_drives)
    assert found[0] == kind
    assert meaning in found[1] if meaning else found[1] == ""
