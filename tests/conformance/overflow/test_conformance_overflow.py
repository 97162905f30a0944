"""Whole numbers wrap around in two's complement of their width.

IEC 61131-3 leaves the result of an overflow to the implementation; S7 and every IEC runtime we
know keep the low bits. REAL overflows to infinite (IEEE 754).
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram

Load = Callable[[str], LoadedProgram]

EXPECTED = {
    "tinyPlus1": -128,
    "tinyUPlus1": 0,
    "wordPlus1": -32768,
    "wordUPlus1": 0,
    "doublePlus1": -2147483648,
    "doubleUPlus1": 0,
    "longPlus1": -9223372036854775808,
    "longUPlus1": 0,
    "noneMinus1": 65535,
    "squared": 1,
    "negated": -32768,
    "absolute": -32768,
    "power": -3477,
    "infinite": True,
    "intermediate": -16384,
}


@pytest.mark.parametrize("output", EXPECTED)
def test_overflow_keeps_the_low_bits(load: Load, output: str) -> None:
    block = load("overflow.scl").instance("Overflow")
    block()
    assert block[output] == EXPECTED[output]
