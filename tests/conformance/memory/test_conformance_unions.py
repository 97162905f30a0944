"""The parts of a union share their bytes, the lowest byte first.

Sources: CODESYS help, "Data type UNION"; the controllers of the dialects iec and twincat are little
endian, a BOOL takes a byte, each type starts at a multiple of its size.
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def block(load: Load) -> BlockInstance:
    return load("unions.st").instance("Unions")


def test_a_real_is_its_ieee_bits(block: BlockInstance) -> None:
    block(step=0)
    assert (block.whole, block.low) == (0x3F800000, 0)
    assert block.number.bytes == [0, 0, 0x80, 0x3F]


def test_the_lowest_byte_is_the_first(block: BlockInstance) -> None:
    block(step=1)
    assert (block.whole, block.low) == (0x1234, 0x34)
    assert block.number.parts == {"low": 0x1234, "flag": False, "high": 0}


def test_a_union_is_handed_over_and_copied_whole(block: BlockInstance) -> None:
    block(step=2)
    assert block.real == 3.0
    assert block.pair.first.real == 3.0
    assert block.whole == 0xFFFFFFFF
    assert block["many[1].whole"] == 0


def test_bytes_that_are_no_value_are_kept(block: BlockInstance) -> None:
    block.number = {"bytes": [1, 2, 0x7E, 4]}
    assert block.number.parts.flag is False
    assert block.number.whole == 0x047E0201


def test_a_text_ends_with_a_zero(block: BlockInstance) -> None:
    block["number.whole"] = 0xFFFFFFFF
    block["number.text"] = "ab"
    assert block.number.bytes == [0x61, 0x62, 0, 0xFF]
    assert block.number.text == "ab"


def test_a_snapshot_has_the_bytes(load: Load) -> None:
    instance = load("unions.st").engine.instance("Unions")
    instance.set("pair.first.bytes", [1, 2, 0x7E, 4])
    saved = instance.snapshot()
    instance.set("pair.first.whole", 0)
    instance.restore(saved)
    assert instance.get("pair.first.bytes") == [1, 2, 0x7E, 4]
