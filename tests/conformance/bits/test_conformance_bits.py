"""Bit operations, slices, and how operands are evaluated.

Sources: IEC 61131-3, 6.6.2.5.9 and table 71 (priorities); TIA Portal help, "Addressing areas of a
variable with slice access" (bit 0, byte 0 and word 0 are the least significant ones).
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def block(load: Load) -> BlockInstance:
    instance = load("bits.scl").instance("Bits")
    instance(a=0xF00F, b=0x3C3C, n=1)
    return instance


def test_bit_by_bit(block: BlockInstance) -> None:
    assert block.conjunction == 0x300C
    assert block.disjunction == 0xFC3F
    assert block.exclusive == 0xCC33
    assert block.complement == 0x0FF0


def test_slices_are_read_from_the_least_significant_end(block: BlockInstance) -> None:
    assert (block.bit15, block.lowByte) == (True, 0x0F)


def test_writing_a_slice_leaves_the_rest(block: BlockInstance) -> None:
    assert block.built == 0xF00F805A


def test_slices_of_a_signed_number_are_its_pattern(block: BlockInstance) -> None:
    assert (block.signBit, block.negative) == (False, -32767)


def test_priorities_of_the_logical_operators(block: BlockInstance) -> None:
    assert block.priority is True


def test_both_sides_of_and_and_or_are_evaluated(block: BlockInstance) -> None:
    assert (block.calls, block.both) == (4, True)
