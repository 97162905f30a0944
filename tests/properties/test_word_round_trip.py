"""Encoding and decoding a word are each other's reverse, for every word of the catalogue."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fbgen.catalog import Word, load_catalog, parse_word

WORDS = dict(load_catalog().word_names())


@pytest.mark.parametrize("path", list(WORDS))
@given(value=st.integers(0, 0xFFFF))
def test_what_is_decoded_encodes_to_the_defined_bits(path: str, value: int) -> None:
    word = WORDS[path]
    values = {item.field.name: item.value for item in word.decode(value)}
    assert word.encode(values) | word.undefined(value) == value
    assert word.encode(values) & word.undefined(value) == 0


@given(data=st.data(), word=st.sampled_from(list(WORDS.values())))
def test_what_is_encoded_decodes_to_the_same_values(data: st.DataObject, word: Word) -> None:
    values = {
        field.name: data.draw(st.integers(0, field.maximum), label=field.name)
        for field in word.bits
    }
    decoded = word.decode(word.encode(values))
    assert {item.field.name: item.value for item in decoded} == values


@given(value=st.integers(0, 0xFFFF))
def test_a_word_is_read_in_every_spelling(value: int) -> None:
    spellings = (
        f"{value:04X}", f"{value:x}", f"16#{value:04X}", f"0x{value:X}", f"{value:X}h",
        f"2#{value:016b}", f"0b{value:03b}", f"10#{value}", f"{value:05d}",
    )  # fmt: skip
    assert {parse_word(text) for text in spellings} == {value}
