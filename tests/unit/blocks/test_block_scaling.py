"""TOS_HzToWord, TOS_WordToHz, TOS_WordToPercent. Source: TOSPBDP001 manual v1.1, 8 F and 8 G."""

import math
import struct

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from harness import LoadedProgram
from harness.engine.loading import ENGINES
from tests.unit.blocks.programs import ALL_SEQUENCES, loaded
from tests.unit.blocks.vectors import vector

NOT_A_NUMBER = math.nan
INFINITE = math.inf


def as_real(value: float) -> float:
    """The nearest value of a 32-bit REAL."""
    return float(struct.unpack("<f", struct.pack("<f", value))[0])


@pytest.mark.fact("tos.data")
def test_the_worked_examples_of_the_manual(program: LoadedProgram) -> None:
    frequency = vector("tos.8f.maximum_frequency")
    word, hz = int(frequency["word"], 16), float(frequency["value"])
    assert program.call("TOS_HzToWord", hz=hz, maxFrequency=hz) == word
    assert program.call("TOS_WordToHz", value=word) == pytest.approx(hz)
    current = vector("tos.g.current")
    percent = program.call("TOS_WordToPercent", value=int(current["word"], 16))
    assert percent == pytest.approx(float(current["value"]))


@pytest.mark.parametrize(
    ("hz", "largest", "word"),
    [
        (50.0, 50.0, 0x1388),
        (0.0, 50.0, 0),
        (0.01, 50.0, 1),
        (49.99, 50.0, 4999),
        (50.01, 50.0, 5000),
        (1e9, 50.0, 5000),
        (INFINITE, 50.0, 5000),
        (-0.01, 50.0, 0),
        (-50.0, 50.0, 0),
        (-INFINITE, 50.0, 0),
        (NOT_A_NUMBER, 50.0, 0),
        (50.0, NOT_A_NUMBER, 0),
        (50.0, 0.0, 0),
        (50.0, -1.0, 0),
        (50.0, INFINITE, 5000),
        (INFINITE, INFINITE, 0xFFFF),
        (655.35, 1000.0, 0xFFFF),
        (700.0, 1000.0, 0xFFFF),
        (1e-30, 50.0, 0),
    ],
)
def test_a_set_point_is_limited_and_what_is_no_number_stops(
    program: LoadedProgram, hz: float, largest: float, word: int
) -> None:
    assert program.call("TOS_HzToWord", hz=hz, maxFrequency=largest) == word


@pytest.mark.parametrize("engine", sorted(ENGINES))
@given(word=st.integers(0, 0xFFFF))
@settings(max_examples=200)
def test_a_word_comes_back_from_hz_unchanged(engine: str, word: int) -> None:
    program = loaded(ALL_SEQUENCES, engine)
    hz = program.call("TOS_WordToHz", value=word)
    assert isinstance(hz, float)
    assert program.call("TOS_HzToWord", hz=hz, maxFrequency=700.0) == word


@pytest.mark.parametrize("engine", sorted(ENGINES))
@given(
    hz=st.floats(width=32),
    largest=st.floats(width=32),
)
@settings(max_examples=300)
def test_no_set_point_is_above_the_limit_of_the_drive(
    engine: str, hz: float, largest: float
) -> None:
    word = loaded(ALL_SEQUENCES, engine).call("TOS_HzToWord", hz=hz, maxFrequency=largest)
    assert isinstance(word, int)
    assert 0 <= word <= 0xFFFF
    limit = min(largest, hz) if largest > 0 and hz > 0 else 0.0
    assert word <= limit * 100 + 0.51 + limit * 1e-4


@pytest.mark.parametrize("word", [0, 1, 0x7FFF, 0x8000, 0xFFFF])
def test_words_are_unsigned(program: LoadedProgram, word: int) -> None:
    assert program.call("TOS_WordToHz", value=word) == as_real(word / 100)
    assert program.call("TOS_WordToPercent", value=word) == as_real(word / 100)
