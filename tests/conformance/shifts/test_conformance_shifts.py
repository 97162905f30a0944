"""Shifts and rotations (IEC 61131-3 table 30; TIA Portal help, "Shift and rotate").

A shift by the width or more leaves nothing but, for signed numbers on S7, the sign.
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


def shifted(load: Load, **inputs: int) -> BlockInstance:
    block = load("shifts.scl").instance("Shifts")
    block(**inputs)
    return block


@pytest.mark.parametrize(
    ("count", "left", "right", "rotated_left", "rotated_right"),
    [
        (0, 0xB1, 0xB1, 0xB1, 0xB1),
        (1, 0x62, 0x58, 0x63, 0xD8),
        (4, 0x10, 0x0B, 0x1B, 0x1B),
        (7, 0x80, 0x01, 0xD8, 0x63),
        (8, 0x00, 0x00, 0xB1, 0xB1),
        (9, 0x00, 0x00, 0x63, 0xD8),
        (100, 0x00, 0x00, 0x1B, 0x1B),
    ],
)
def test_bit_strings_are_filled_with_zeros_and_rotate_in_their_width(
    load: Load, *, count: int, left: int, right: int, rotated_left: int, rotated_right: int
) -> None:
    block = shifted(load, narrow=0xB1, count=count)
    assert (block.left, block.right) == (left, right)
    assert (block.rotatedLeft, block.rotatedRight) == (rotated_left, rotated_right)


@pytest.mark.parametrize(
    ("signed", "count", "left", "right"),
    [
        (-16, 2, -64, -4),
        (-1, 15, -32768, -1),
        (-32768, 16, 0, -1),
        (16384, 1, -32768, 8192),
        (32767, 40, 0, 0),
    ],
)
def test_signed_numbers_keep_their_sign_to_the_right(
    load: Load, signed: int, count: int, left: int, right: int
) -> None:
    block = shifted(load, signed=signed, count=count)
    assert (block.signedLeft, block.signedRight) == (left, right)


def test_a_shift_does_not_reach_into_a_wider_type(load: Load) -> None:
    assert shifted(load, wide=0x80FF, count=1).wideLeft == 0x01FE


def test_a_negative_count_is_read_as_a_very_large_one(load: Load) -> None:
    block = shifted(load, narrow=0xB1, signed=-5, count=-1)
    assert (block.left, block.right, block.signedRight) == (0, 0, -1)
    assert block.rotatedLeft == 0xD8


def test_swap_turns_the_bytes_round(load: Load) -> None:
    assert shifted(load, wide=0x12AB).swapped == 0xAB12
