"""SCATTER, GATHER, SEG and BCDCPL.

Expected values: TIA Portal help, "SCATTER", "SCATTER_BLK" (bit 0 is the first BOOL), "BCDCPL"
(10000000 minus the number); the segments from the table of FC93, a in bit 0 to g in bit 6.
"""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import load_program

_PROGRAM = Path(__file__).with_name("bits.scl")


def _bits(word: int, count: int = 16) -> list[bool]:
    return [bool(word >> number & 1) for number in range(count)]


@pytest.mark.parametrize("word", [0, 0x8001, 0x1234, 0xFFFF])
def test_a_word_becomes_bits_and_comes_back(engine_name: str, word: int) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Bits")
    block(word=word, first=1)
    assert list(block["flags"]) == _bits(word)
    assert [block[f"small.b{number}"] for number in range(8)] == _bits(word, 8)
    assert (block["back"], block["low"]) == (word, word & 0xFF)


def test_words_of_an_array_become_bits_and_come_back(engine_name: str) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Bits")
    block(word=0, first=2)
    assert list(block["many"]) == [*[False] * 16, *_bits(0x00F0), *_bits(0xFFFF)]
    assert list(block["again"]) == [0, 0x00F0, 0xFFFF]


def test_beyond_the_array_the_program_stops(engine_name: str) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Bits")
    with pytest.raises(DiagnosticError) as stop:
        block(word=0, first=3)
    assert stop.value.diagnostics[0].code == "FB6002"


@pytest.mark.parametrize(
    ("word", "segments"),
    [(0x0123, 0x3F065B4F), (0x4567, 0x666D7D07), (0x89AB, 0x7F67777C), (0xCDEF, 0x395E7971)],
)
def test_digits_become_segments(engine_name: str, word: int, segments: int) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Bits")
    block(word=word, first=1)
    assert block["segments"] == segments


def test_the_tens_complement_is_what_is_missing(engine_name: str) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Bits")
    block(word=0, first=1)
    assert block["complement"] == 0x09987655


def test_a_digit_above_nine_has_no_complement(engine_name: str) -> None:
    text = 'FUNCTION "F" : DWord\nVAR_INPUT x : DWord; END_VAR\n"F" := BCDCPL(#x);\nEND_FUNCTION\n'
    program = load_program([Source("f.scl", text)], engine=engine_name)
    assert program.call("F", x=0) == 0x10000000
    with pytest.raises(DiagnosticError) as stop:
        program.call("F", x=0xA)
    assert stop.value.diagnostics[0].code == "FB6014"
