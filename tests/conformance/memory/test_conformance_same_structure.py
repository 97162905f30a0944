"""Structures and arrays that are declared apart and have the same parts are copied.

Source: TIA Portal help, "Transferring a tag of the PLC data type (UDT)" and "Transferring tags of
the ARRAY / ARRAY[*] data type".
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def copies(load: Load) -> BlockInstance:
    instance = load("same_structure.scl").instance("Copies")
    instance()
    return instance


def test_parts_go_by_their_order(copies: BlockInstance) -> None:
    assert (copies.place.across, copies.place.others.up) == (7, 1.5)
    assert copies.place.others.name == "there"
    assert list(copies.place.values) == [0, 9, 0]
    assert (copies.plain.a, copies.plain.b.d, list(copies.plain.e)) == (7, "there", [0, 9, 0])


def test_arrays_of_structures_go_element_by_element(copies: BlockInstance) -> None:
    assert copies.points[1].more.text == "there"
    assert copies.places[6].others.name == "there"
    assert copies.places[5].across == 7


def test_arrays_with_other_bounds_go_in_order(copies: BlockInstance) -> None:
    assert list(copies.others) == [0, 0, 0, 4]
    assert copies.table[2, 3] == 6


def test_a_result_and_a_chain_are_worked_out_once(copies: BlockInstance) -> None:
    assert (copies.first.across, copies.first.others.name) == (3, "made")
    assert list(copies.first.values) == [0, 0, 4]
    assert list(copies.second.list) == [0, 0, 4]


def test_inputs_take_arrays_with_other_bounds(copies: BlockInstance) -> None:
    assert copies.ends == 24
    assert (copies.keeps.last, list(copies.keeps.list)) == (4, [2, 0, 0, 4])
