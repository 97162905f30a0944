"""Variables that lie over each other with AT show how each type lies in memory.

Sources: STEP 7 System Software reference, appendix "Data types": BOOLs packed from bit 0 on, words
and structures at even bytes, STRING with two bytes in front, DATE_AND_TIME and S5TIME in BCD (the
bytes of DT#1993-12-25-08:01:01.123 are its example), REAL after IEEE 754, all numbers with the most
significant byte first; TIA Portal help, "Overlaying tags with AT".
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def block(load: Load) -> BlockInstance:
    return load("overlays.scl").instance("Overlays")


def test_the_most_significant_byte_is_the_first(block: BlockInstance) -> None:
    block(number=0x11223344)
    assert (block.highByte, block.lowByte) == (0x11, 0x44)
    assert block.numberBytes == [0x11, 0x22, 0x33, 0x44]


def test_a_temporary_real_shows_its_ieee_bits(block: BlockInstance) -> None:
    block()
    assert block.realBits == 0xC0200000


def test_a_structure_is_packed_and_aligned(block: BlockInstance) -> None:
    block.mixed = {
        "flag": True,
        "other": True,
        "small": 0xAA,
        "tiny": -1,
        "wide": 0x1234,
        "part": {"a": 0x55},
        "after": True,
        "row": [1, 2, 3],
        "last": 0x99,
    }
    assert bytes(block.mixedBytes).hex(" ") == "03 aa ff 00 12 34 55 00 01 00 01 02 03 00 99 00"


def test_bytes_change_the_structure_under_them(block: BlockInstance) -> None:
    block.mixedBytes = [2, 0, 0x80, 0, 0xFF, 0xFE, 0, 0, 0, 0, 0, 7, 0, 0, 0, 0]
    assert block.mixed.flag is False
    assert block.mixed.other is True
    assert (block.mixed.tiny, block.mixed.wide, block.mixed.row[2]) == (-128, -2, 7)


def test_bit_0_of_an_array_is_bit_0_of_the_first_byte(block: BlockInstance) -> None:
    block["flagBits[0]"] = True
    block["flagBits[9]"] = True
    assert block.flags == 0x0102
    assert block.flagBytes == {"high": 1, "low": 2}


def test_a_string_has_its_room_and_its_length_in_front(block: BlockInstance) -> None:
    assert bytes(block.textBytes) == b"\x05\x02ab\0\0\0"
    block["textBytes[1]"] = 1
    assert block.text == "a"


def test_a_shorter_text_leaves_what_lies_behind_it(block: BlockInstance) -> None:
    block.text = "xyz"
    block.text = "k"
    assert bytes(block.textBytes) == b"\x05\x01kyz\0\0"


def test_date_and_time_is_decimal_with_the_weekday(block: BlockInstance) -> None:
    assert bytes(block.momentBytes).hex(" ") == "93 12 25 08 01 01 12 37"


def test_s5time_is_decimal_with_the_base(block: BlockInstance) -> None:
    assert block.secondsWord == 0x0300


def test_times_and_dates_are_counts(block: BlockInstance) -> None:
    assert (block.spanNumber, block.dayWord) == (1000, 1)


def test_characters_are_bytes(block: BlockInstance) -> None:
    assert block.lettersWord == 0x417A


def test_a_function_overlays_its_inputs_and_temporaries(load: Load) -> None:
    program = load("overlays.scl")
    assert program.call("Halves", number=0x00030004) == 7007


def test_what_is_handed_over_by_reference_is_still_the_same_memory(load: Load) -> None:
    block = load("overlays.scl").instance("Handed")
    block()
    assert block.sum == 0x7FFF + 1 - 0x10000 + 5
    assert block.bytes == [0x80, 0x05]


def test_overlaid_memory_is_remembered_byte_by_byte(load: Load) -> None:
    instance = load("overlays.scl").engine.instance("Overlays")
    instance.set("momentBytes", [0xFF] * 8)
    saved = instance.snapshot()
    instance.set("momentBytes", [0] * 8)
    assert instance.snapshot() != saved
    instance.restore(saved)
    assert instance.get("momentBytes") == [0xFF] * 8
