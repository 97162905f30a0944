"""Conversions and rounding.

Sources: IEC 61131-3, 6.6.2.5; TIA Portal help, "Explicit data type conversion".
To nearest means ties to even (IEC 60559); TRUNC cuts towards zero.
"""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.mark.parametrize(
    ("number", "nearest", "cut", "up", "down"),
    [
        (2.5, 2, 2, 3, 2),
        (3.5, 4, 3, 4, 3),
        (-2.5, -2, -2, -2, -3),
        (-3.5, -4, -3, -3, -4),
        (0.5, 0, 0, 1, 0),
        (1.5, 2, 1, 2, 1),
        (2.4999, 2, 2, 3, 2),
        (-0.75, -1, 0, 0, -1),
        (7.0, 7, 7, 7, 7),
    ],
)
def test_rounding(load: Load, *, number: float, nearest: int, cut: int, up: int, down: int) -> None:
    block = load("conversions.scl").instance("Rounding")
    block(number=number)
    assert (block.converted, block.nearest) == (nearest, nearest)
    assert (block.cut, block.up, block.down) == (cut, up, down)


@pytest.mark.parametrize("number", [32767.5, 40000.0, -32769.0, float("inf"), float("nan")])
def test_a_real_that_does_not_fit_is_reported(load: Load, number: float) -> None:
    block = load("conversions.scl").instance("Rounding")
    with pytest.raises(DiagnosticError) as failure:
        block(number=number)
    diagnostic = failure.value.diagnostics[0]
    assert diagnostic.code == "FB6006"
    assert diagnostic.span is not None
    assert diagnostic.span.text == "REAL_TO_INT(#number)"


@pytest.mark.parametrize("number", [32767.4, -32768.5])
def test_a_real_that_fits_after_rounding_is_taken(load: Load, number: float) -> None:
    block = load("conversions.scl").instance("Rounding")
    block(number=number)
    assert block.converted == round(number)


def widths(load: Load, **inputs: float) -> BlockInstance:
    block = load("conversions.scl").instance("Widths")
    block(**inputs)
    return block


def test_a_narrower_whole_number_keeps_the_low_bits(load: Load) -> None:
    block = widths(load, double=0x12348765)
    assert block.low == 0x8765 - 0x10000
    assert block.lowUnsigned == 0x65
    assert block.pattern == 0x8765


def test_a_negative_number_keeps_its_pattern(load: Load) -> None:
    block = widths(load, double=-2)
    assert (block.low, block.lowUnsigned, block.pattern) == (-2, 254, 0xFFFE)


def test_a_bit_string_becomes_a_signed_number_of_its_width_by_pattern(load: Load) -> None:
    block = widths(load, word=0xFFFF)
    assert (block.asSigned, block.asDouble) == (-1, 65535)


@pytest.mark.parametrize(("word", "expected"), [(0, False), (1, True), (2, False), (0x8001, True)])
def test_bool_is_the_lowest_bit(load: Load, word: int, expected: bool) -> None:
    assert widths(load, word=word).lowestBit is expected


def test_real_and_dword_share_their_bits(load: Load) -> None:
    block = widths(load, real=-1.5)
    assert (block.realPattern, block.fromPattern) == (0xBFC00000, -1.5)


def test_time_counts_milliseconds(load: Load) -> None:
    assert widths(load, duration=-1500).milliseconds == -1500


@pytest.mark.parametrize(
    ("double", "expected"),
    [(16777216, 16777216.0), (16777217, 16777216.0), (16777219, 16777220.0)],
)
def test_a_whole_number_becomes_the_nearest_real(load: Load, double: int, expected: float) -> None:
    assert widths(load, double=double).asReal == expected


def test_real_results_have_32_bits(load: Load) -> None:
    block = load("conversions.scl").instance("Precision")
    block(a=0.1, b=0.2)
    # the nearest 32 bit numbers: 16#3DCCCCCD + 16#3E4CCCCD = 16#3E99999A
    assert block.a == 0.100000001490116119384765625
    assert block.sum == 0.300000011920928955078125
    assert block.wide == 0.100000001490116119384765625


def test_real_loses_what_24_bits_cannot_hold(load: Load) -> None:
    block = load("conversions.scl").instance("Precision")
    block(a=16777216.0, b=1.0)
    assert block.sum == 16777216.0
