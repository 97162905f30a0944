"""FDL telegrams: decoding undoes encoding, and damage is noticed or harmless.

pyprofibus, which was written by others, takes our telegrams for what they are.
"""

from hypothesis import given
from hypothesis import strategies as st
from pyprofibus.fdl import FdlTelegram

from fbgen.wire.fdl import (
    DataTelegram,
    ShortAcknowledgement,
    TelegramError,
    Token,
    decode,
    encode,
)
from fbgen.wire.fdl_stream import TelegramReader

addresses, senders = st.integers(0, 127), st.integers(0, 126)
saps = st.none() | st.integers(0, 63)
controls = st.integers(0, 0x7F)
fixed = st.builds(
    DataTelegram,
    addresses,
    senders,
    controls,
    st.binary(min_size=8, max_size=8),
    fixed=st.just(True),
)
with_data = st.builds(
    DataTelegram, addresses, senders, controls, st.binary(max_size=244), saps, saps
)
short = st.builds(DataTelegram, addresses, senders, controls)
telegrams = st.one_of(
    with_data, fixed, short, st.builds(Token, addresses, senders), st.just(ShortAcknowledgement())
)
KINDS = (
    DataTelegram(2, 1, 0x49),
    DataTelegram(2, 1, 0x6D, b"", 60, 62),
    DataTelegram(2, 1, 0x5D, bytes.fromhex("B8 01 0A 0B 18 03 00"), 61, 62),
    DataTelegram(2, 1, 0x4D, bytes(range(8)), fixed=True),
    DataTelegram(127, 1, 0x46, b"\x20\x01", 58, 62),
)


@given(telegrams)
def test_decoding_gives_back_what_was_encoded(telegram):
    assert decode(encode(telegram)) == telegram


@given(st.one_of(with_data, fixed, short))
def test_another_implementation_reads_the_same(telegram):
    other = FdlTelegram.fromRawData(bytearray(encode(telegram)))
    extensions = [
        b"" if sap is None else bytes((sap,))
        for sap in (telegram.destination_sap, telegram.source_sap)
    ]
    assert (other.da, other.sa, other.fc) == (
        telegram.destination, telegram.source, telegram.control,
    )  # fmt: skip
    assert [bytes(other.dae), bytes(other.sae)] == extensions
    assert bytes(other.du or b"") == telegram.data


def test_every_single_bit_that_is_wrong_is_noticed():
    for telegram in KINDS:
        whole = encode(telegram)
        for bit in range(len(whole) * 8):
            damaged = bytearray(whole)
            damaged[bit // 8] ^= 1 << bit % 8
            assert refused(damaged), (telegram, bit)


def test_every_telegram_that_is_cut_short_is_noticed():
    for telegram in (*KINDS, Token(2, 1), ShortAcknowledgement()):
        whole = encode(telegram)
        for length in range(len(whole)):
            assert refused(whole[:length]), (telegram, length)


def refused(data):
    try:
        decode(data)
    except TelegramError:
        return True
    return False


@given(st.binary(max_size=60), st.binary(max_size=60))
def test_any_bytes_are_read_without_an_error(first, second):
    reader = TelegramReader()
    found = reader.feed(first) + reader.feed(second) + reader.silence()
    assert sum(len(encode(telegram)) for telegram in found) + reader.skipped == len(first + second)
    assert not reader.waiting


@given(st.lists(telegrams, max_size=5), st.lists(st.integers(1, 40), min_size=1))
def test_telegrams_come_out_however_the_stream_is_parted(sent, lengths):
    stream = b"".join(encode(telegram) for telegram in sent)
    reader, found, at = TelegramReader(), [], 0
    while at < len(stream):
        length = lengths[at % len(lengths)]
        found += reader.feed(stream[at : at + length])
        at += length
    assert found == sent


@given(telegrams, st.binary(max_size=20))
def test_behind_silence_the_next_telegram_is_read_whatever_came_before(telegram, garbage):
    reader = TelegramReader()
    reader.feed(garbage)
    reader.silence()
    assert reader.feed(encode(telegram)) == [telegram]
