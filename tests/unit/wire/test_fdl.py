"""FDL telegrams, byte by byte. The example of SD3 is what another master sends for eight bytes."""

import pytest

from fbgen.wire.fdl import (
    DataTelegram,
    RequestFunction,
    ShortAcknowledgement,
    TelegramError,
    Token,
    decode,
    encode,
    first_request_control,
    measure,
    request_control,
)
from fbgen.wire.fdl_stream import TelegramReader

TELEGRAMS = {
    "SD1": ("10 02 01 49 4C 16", DataTelegram(2, 1, 0x49)),
    "SD2": ("68 05 05 68 82 81 6D 3C 3E EA 16", DataTelegram(2, 1, 0x6D, b"", 60, 62)),
    "SD2 with data": (
        "68 07 07 68 FF 81 46 3A 3E 20 01 5F 16",
        DataTelegram(127, 1, 0x46, b"\x20\x01", 58, 62),
    ),
    "SD3": (
        "A2 02 01 4D 00 01 02 03 04 05 06 07 6C 16",
        DataTelegram(2, 1, 0x4D, bytes(range(8)), fixed=True),
    ),
    "SD4": ("DC 02 01", Token(2, 1)),
    "SC": ("E5", ShortAcknowledgement()),
}


@pytest.mark.parametrize(("text", "telegram"), TELEGRAMS.values(), ids=TELEGRAMS)
def test_a_telegram_is_encoded_and_decoded(text, telegram):
    assert encode(telegram) == bytes.fromhex(text)
    assert decode(bytes.fromhex(text)) == telegram


def test_the_function_code_says_what_a_telegram_is():
    request = DataTelegram(2, 1, request_control(RequestFunction.SRD_HIGH, True))
    assert (request.is_request, request.function) == (True, RequestFunction.SRD_HIGH)
    assert (request.frame_count_bit, request.frame_count_valid) == (True, True)
    first = DataTelegram(2, 1, first_request_control(RequestFunction.SRD_HIGH))
    assert (first.frame_count_bit, first.frame_count_valid) == (True, False)
    status = DataTelegram(2, 1, request_control(RequestFunction.FDL_STATUS))
    assert (status.frame_count_bit, status.frame_count_valid) == (False, False)
    reply = DataTelegram(1, 2, 0x28)
    assert (reply.is_request, reply.station_type) == (False, 2)


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("", "not one whole"),
        ("11", "begins with 11"),
        ("10 02 01 49 4D 16", "check sum"),
        ("10 02 01 49 4C 17", "end delimiter"),
        ("10 82 01 49 CC 16", "not there"),
        ("10 02 7F 49 CA 16", "sender 127"),
        ("10 02 01 C9 CC 16", "reserved bit 7"),
        ("68 03 03 68 02 01 49 4C 16", "length 3"),
        ("68 05 04 68", "given as 5 and as 4"),
        ("68 05 05 69", "second start"),
        ("68 04 04 68 82 01 49 BC 88 16", "address extension BC"),
        ("DC FF 01", "address 255"),
        ("E5 E5", "not one whole"),
    ],
)
def test_what_is_no_telegram_is_refused(text, why):
    with pytest.raises(TelegramError, match=why):
        decode(bytes.fromhex(text))


@pytest.mark.parametrize(
    "wrong",
    [
        {"destination": 128},
        {"source": 127},
        {"control": 0x80},
        {"data": bytes(247)},
        {"data": bytes(245), "destination_sap": 1, "source_sap": 1},
        {"destination_sap": 64},
        {"data": bytes(7), "fixed": True},
    ],
)
def test_what_no_telegram_can_say_is_refused(wrong):
    with pytest.raises(TelegramError):
        DataTelegram(**({"destination": 2, "source": 1, "control": 0x4D} | wrong))


def test_the_longest_telegram_has_246_bytes_of_data():
    longest = DataTelegram(2, 1, 0x4D, bytes(246))
    assert len(encode(longest)) == 255
    assert decode(encode(longest)) == longest


def test_the_length_is_known_after_four_bytes_at_most():
    whole = bytes.fromhex("68 05 05 68 82 81 6D 3C 3E EA 16")
    assert [measure(whole[:count]) for count in range(5)] == [None, None, None, None, 11]
    assert measure(b"\x10") == 6


def test_telegrams_are_found_in_any_portions_and_behind_garbage():
    stream = b"\x00\x16\x99" + b"".join(bytes.fromhex(text) for text, _ in TELEGRAMS.values())
    reader = TelegramReader()
    found = [item for byte in stream for item in reader.feed(bytes((byte,)))]
    assert found == [telegram for _, telegram in TELEGRAMS.values()]
    assert reader.skipped == 3
    assert not reader.waiting


def test_silence_ends_a_telegram_that_was_not_completed():
    status = bytes.fromhex("10 02 01 49 4C 16")
    reader = TelegramReader()
    assert reader.feed(b"\x68\x20\x20\x68" + status) == []
    assert reader.waiting
    assert reader.silence() == [decode(status)]
    assert not reader.waiting
