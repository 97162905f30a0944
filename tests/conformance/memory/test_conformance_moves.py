"""MOVE_BLK, FILL_BLK, BLKMOV, FILL and POKE_BLK.

Sources: TIA Portal help, "MOVE_BLK: Move block", "FILL_BLK: Fill block", "BLKMOV: Move block" (only
as much as the smaller area holds), "FILL: Fill block" (the last one may be cut), "POKE_BLK".
"""

from collections.abc import Callable

import pytest

from fbgen.diagnostics import DiagnosticError
from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def program(load: Load) -> LoadedProgram:
    return load("moves.scl")


@pytest.fixture
def block(program: LoadedProgram) -> BlockInstance:
    return program.instance("Moves")


def test_elements_move_from_array_to_array(block: BlockInstance) -> None:
    block(step=1, count=3)
    assert block.copy == [0, 2, 3, 4, 0, 0]


def test_elements_are_filled(block: BlockInstance) -> None:
    block(step=2, count=4, value=-3)
    assert block.copy == [0, 0, -3, -3, -3, -3]
    block(step=11, count=2)
    assert block.row == [1, 2, 3, 7, 7]


def test_nothing_happens_for_no_elements(block: BlockInstance) -> None:
    block(step=1, count=0)
    assert block.copy == [0] * 6


def test_areas_that_overlap_are_read_first(block: BlockInstance) -> None:
    block(step=3, count=4)
    assert block.grid == [1, 2, 2, 3, 4, 5]
    block(step=4, count=3)
    assert [point["x"] for point in block.points] == [1, 1, 2, 3]


@pytest.mark.parametrize(
    ("step", "count", "room"), [(1, 5, 4), (2, 5, 4), (3, 5, 4), (4, -1, 4), (11, 3, 2)]
)
def test_more_elements_than_there_are_stop_the_program(
    block: BlockInstance, step: int, count: int, room: int
) -> None:
    with pytest.raises(DiagnosticError, match=f"FB6041.*{count} elements, the array has {room}"):
        block(step=step, count=count)


def test_blkmov_copies_bytes(block: BlockInstance) -> None:
    block(step=5)
    assert block.bytes == [1, 2, 3, 4, 5, 6]
    assert block.result == 0


def test_blkmov_gives_bytes_their_meaning(block: BlockInstance) -> None:
    block.bytes = [0xFF, 0xFE, 0, 0, 1, 0]
    block(step=6)
    assert block.pair == {"a": -2, "b": 256}


def test_blkmov_copies_no_more_than_the_smaller_area_holds(block: BlockInstance) -> None:
    block(step=10)
    assert block.copy == [0x0102, 0x0304, 0x0506, 0x0708, 0x090A, 0]


def test_a_single_value_is_an_area_too(block: BlockInstance) -> None:
    block(step=12)
    assert block.result == 0


def test_fill_repeats_and_cuts_its_pattern(block: BlockInstance) -> None:
    block(step=7)
    assert block.bytes == [0xA5, 0x5A, 0xA5, 0x5A, 0xA5, 0x5A]


def test_areas_can_be_given_by_their_address(program: LoadedProgram, block: BlockInstance) -> None:
    block(step=8)
    assert program.engine.environment.markers[10:14] == bytes([3, 4, 5, 6])


def test_poke_blk_copies_within_a_data_block(program: LoadedProgram, block: BlockInstance) -> None:
    block(step=9, count=10)
    assert program.globals.DB100.bytes == [1, 2, 1, 2, 3, 4, 5, 6, 7, 8]
    assert program.globals.DB100.speed == 0x090A
    with pytest.raises(DiagnosticError, match=r"FB6010.*%DB100\.DBB2"):
        block(step=9, count=15)
