"""READ_LITTLE, WRITE_LITTLE, READ_BIG and WRITE_BIG.

Expected values: TIA Portal help, the pages of the four: POS counts from 0 and goes on behind what
was read or written; 16#80B4 for a wrong type, 16#8382 for a POS outside, 16#8383 for too little
room.
"""

from pathlib import Path

import pytest

from harness import load_program

_PROGRAM = Path(__file__).with_name("order.scl")


def test_bytes_stand_in_the_order_of_the_instruction(engine_name: str) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Order")
    block(at=2)
    assert list(block["bytes"]) == [0, 0, 4, 3, 2, 1, 0, 0]
    assert list(block["others"]) == [0, 0, 0x3F, 0, 0, 0, 0, 0]
    assert block["number"] == 0x04030201
    assert list(block["result"]) == [0, 0, 0, 0]
    assert list(block["position"]) == [6, 6, 6, 6]


def test_reading_in_the_other_order_gives_another_number(engine_name: str) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Order")
    block(at=0)
    assert block["real"] == pytest.approx(8.828e-44, rel=1e-3), "the bytes 3F 00 00 00 from behind"


@pytest.mark.parametrize(("at", "code"), [(-1, 0x8382), (8, 0x8382), (5, 0x8383)])
def test_without_room_nothing_happens(engine_name: str, at: int, code: int) -> None:
    block = load_program([_PROGRAM], engine=engine_name).instance("Order")
    block(at=at)
    assert list(block["result"]) == [code - 0x10000] * 4
    assert list(block["position"]) == [at] * 4
    assert list(block["bytes"]) == [0] * 8


@pytest.mark.parametrize("which", [1, 2, 3, 4])
def test_wrong_types_are_said_in_ret_val(engine_name: str, which: int) -> None:
    program = load_program([_PROGRAM], engine=engine_name)
    assert program.call("Wrong", which=which) == 0x80B4 - 0x10000
