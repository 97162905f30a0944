"""Telegrams in words: what the PLC wants and what the drive says."""

import pytest

from fbgen.catalog import load_catalog
from harness.trace.meaning import telegram_meaning, word_meaning

CATALOG = load_catalog()
DRIVE = CATALOG.drive("vf-s11")


@pytest.mark.parametrize(
    ("output", "reply", "meaning"),
    [
        (
            "E0 00 01 0B 50 FA 00 C4 00",
            "DF 00 0B 50 FA 00 C4 00",
            "drive 11: write FA00 Command word = C400 (network_command, network_frequency, run)",
        ),
        (
            "A0 00 02 0B 50 FA 01 13 88",
            None,
            "drive 11: write FA01 Frequency set-point = 1388 (50.00 Hz)",
        ),
        ("E0 00 03 0B 47 FE 03 00 00", "DF 00 0B 47 FE 03 10 E8", "= 10E8 (43.28 %)"),
        ("E0 00 03 0B 47 FC 90 00 00", None, "drive 11: read FC90 Trip code, 0000 while ready"),
        ("00 00 04 FF 50 FA 00 20 00", None, "all drives: write FA00 Command word = 2000 (fault_"),
        ("00 00 05 0B 47 12 34 00 00", None, "drive 11: read 1234"),
        ("00 00 05 0B 50 12 34 00 07", None, "drive 11: write 1234 = 0007"),
        ("00 00 06 0B 11 FA 00 00 00", None, "command 11 is none of the protocol"),
        ("00 00 00 00 00 00 00 00 00", None, "command 00 is none of the protocol"),
    ],
)
def test_a_telegram_in_words(output: str, reply: str | None, meaning: str) -> None:
    answered = bytes.fromhex(reply) if reply is not None else None
    assert meaning in telegram_meaning(bytes.fromhex(output), answered, DRIVE, CATALOG)


def test_a_word_without_set_bits_says_so() -> None:
    assert word_meaning(DRIVE, 0xFA00, 0) == "0000 (no bit set)"
