"""Configuration identifiers of PROFIBUS DP (EN 50170 volume 2, Chk_Cfg)."""

import pytest

from fbgen.wire.profibus import (
    Consistency,
    Extent,
    IdentifierError,
    decode_identifiers,
    encode_identifier,
    input_length,
    output_length,
    slot_table,
)

GSD = bytes.fromhex("30 30 20 30 30 70 20 70")


def test_the_printed_gsd_of_the_tospbdp001_carries_10_bytes_out_and_8_in():
    identifiers = decode_identifiers(GSD)
    assert (output_length(identifiers), input_length(identifiers)) == (10, 8)


def test_without_the_second_20_it_carries_9_and_8():
    identifiers = decode_identifiers(bytes.fromhex("30 30 20 30 30 70 70"))
    assert (output_length(identifiers), input_length(identifiers)) == (9, 8)


def test_slots_follow_each_other_without_a_gap():
    slots = slot_table(decode_identifiers(GSD), output_address=256, input_address=300)
    assert [slot.output_address for slot in slots] == [256, 257, 258, 259, 260, 261, 263, 264]
    assert [slot.input_address for slot in slots] == [300, 301, None, 302, 303, 304, None, 306]
    assert [slot.input_offset for slot in slots] == [0, 1, None, 2, 3, 4, None, 6]


def test_nothing_in_the_printed_gsd_is_consistent_beyond_one_unit():
    for identifier in decode_identifiers(GSD):
        for extent in (identifier.outputs, identifier.inputs):
            assert extent is None or extent.consistent_bytes == extent.unit_bytes


def test_one_special_identifier_can_cover_the_frame_consistently():
    (identifier,) = decode_identifiers(bytes.fromhex("C0 89 87"))
    assert identifier.outputs == Extent(10, 1, Consistency.WHOLE)
    assert identifier.inputs == Extent(8, 1, Consistency.WHOLE)
    assert identifier.outputs.consistent_bytes == 10


@pytest.mark.parametrize(
    ("code", "outputs", "inputs"),
    [
        ("1F", None, Extent(16)),
        ("E1", Extent(2, 2, Consistency.WHOLE), None),
        ("F7", Extent(8, 2, Consistency.WHOLE), Extent(8, 2, Consistency.WHOLE)),
        ("40 C3", None, Extent(4, 2, Consistency.WHOLE)),
        ("82 00 AA BB", Extent(1), None),
        ("00", None, None),
    ],
)
def test_identifiers_of_both_formats(code, outputs, inputs):
    (identifier,) = decode_identifiers(bytes.fromhex(code))
    assert (identifier.outputs, identifier.inputs) == (outputs, inputs)


def test_an_empty_place_takes_a_slot_and_no_addresses():
    slots = slot_table(decode_identifiers(bytes.fromhex("10 00 10")))
    assert [slot.input_address for slot in slots] == [0, None, 1]


def test_fifteen_manufacturer_bytes_mean_that_there_are_none():
    assert len(decode_identifiers(bytes.fromhex("4F 00 10"))) == 2


@pytest.mark.parametrize("code", ["C0", "C0 89", "42 00 01", "30 80"])
def test_missing_bytes_are_refused(code):
    with pytest.raises(IdentifierError, match="lacks"):
        decode_identifiers(bytes.fromhex(code))


@pytest.mark.parametrize("extent", [Extent(0), Extent(65), Extent(1, 4)])
def test_what_no_identifier_can_say_is_refused(extent):
    with pytest.raises(IdentifierError):
        encode_identifier(extent, None)
