"""Parameters, temporaries and copies (IEC 61131-3, 6.6.1.5 and 6.6.3; TIA Portal help, calls)."""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def block(load: Load) -> BlockInstance:
    instance = load("parameters.scl").instance("Parameters")
    instance()
    instance()
    return instance


def test_a_function_gets_copies_and_starts_anew_each_time(block: BlockInstance) -> None:
    assert (block.doubled, block.original) == (42, 21)
    assert (block.given1, block.given2) == (1, 1)


def test_an_output_that_a_function_does_not_write_has_its_default(block: BlockInstance) -> None:
    assert block.untouched == 0


def test_in_outs_are_copied_out_in_their_order(block: BlockInstance) -> None:
    assert (block.shared, block.seen) == (11, 1)


def test_in_outs_are_found_before_the_call_and_outputs_behind_it(block: BlockInstance) -> None:
    assert block.i == 3
    assert block.list == [0, 10, 0]
    assert block.element == 10


def test_temporaries_start_anew_each_call(block: BlockInstance) -> None:
    assert block.temporary == 1


def test_structures_are_copied(block: BlockInstance) -> None:
    assert (block.copyLeft, block.copyRight) == (1, 20)


def test_an_input_that_is_not_given_keeps_its_value(block: BlockInstance) -> None:
    assert block.kept == 77


def test_initial_values_come_from_the_type(load: Load) -> None:
    fresh = load("parameters.scl").instance("Parameters")
    assert fresh.one == {"left": 7, "right": [1, 2]}
    assert fresh.untouched == 5


def test_a_function_is_called_from_outside(load: Load) -> None:
    program = load("parameters.scl")
    assert program.call("Double", value=-3) == -6
    result = program.call_with_outputs("double", VALUE=4)
    assert (result.value, result.outputs) == (8, {"given": 1, "untouched": 0})


def test_an_in_out_from_outside_is_a_place_of_its_own(load: Load) -> None:
    instance = load("parameters.scl").instance("Aliased")
    instance(copied=1, first=5, second=6)
    assert (instance.first, instance.second, instance.seen) == (6, 16, 1)
    instance()
    assert (instance.first, instance.second) == (7, 26)


def test_static_variables_of_a_function_outlive_its_calls(load: Load) -> None:
    program = load("shared.twincat")
    assert [program.call("CountCalls") for _ in range(3)] == [11, 12, 13]
    program.reset()
    assert program.call("CountCalls") == 11


def test_static_variables_are_shared_by_all_instances(load: Load) -> None:
    program = load("shared.twincat")
    one, two = program.instance("Member"), program.instance("Member")
    for member in (one, two, one):
        member()
    assert (one.number, two.number, one.all) == (1, 2, 2)
