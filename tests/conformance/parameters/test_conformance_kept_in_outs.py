"""In-outs of elementary types that a function block of S7 copies into its instance and back.

Sources: S7-SCL V5.3 manual, "Supplying parameters in function block calls"; TIA Portal help,
"Calling function blocks"; S7-1200 System Manual, "Block optimization and passing parameters".
"""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


@pytest.fixture
def block(load: Load) -> BlockInstance:
    instance = load("kept.scl").instance("Kept")
    instance()
    return instance


def test_without_an_argument_it_begins_with_the_start_value(block: BlockInstance) -> None:
    assert block.start == 6
    assert block.database == 41


def test_a_call_copies_in_and_out_and_the_instance_keeps_the_value(block: BlockInstance) -> None:
    assert (block.given, block.left) == (21, 21)


def test_without_an_argument_it_goes_on_with_what_is_kept(block: BlockInstance) -> None:
    assert block.again == 24
    assert block.own == 0


def test_it_is_written_by_its_name_like_an_input(block: BlockInstance) -> None:
    assert block.written == 73  # amount is kept as well


def test_two_in_outs_on_one_variable_are_two_copies(block: BlockInstance) -> None:
    assert block.same == 11


def test_copying_out_wins_over_what_the_block_did_by_another_name(block: BlockInstance) -> None:
    assert (block.direct, block.seen) == (7, 7)


def test_the_place_is_found_once(block: BlockInstance) -> None:
    assert (block.element, block.calls) == (31, 2)


def test_from_outside_it_is_given_read_and_written(load: Load) -> None:
    counter = load("kept.scl").instance("Counter")
    counter()
    assert counter.total == 6
    counter(total=98, amount=3)
    assert (counter.total, counter.overrun) == (101, True)
    counter.total = 10
    counter(amount=1)
    assert (counter.total, counter.overrun) == (11, False)


def test_a_warm_start_keeps_it_where_the_instance_is_retentive(load: Load) -> None:
    program = load("kept.step7")
    block = program.instance("FB2")
    block()
    assert (block.given, block.left, block.again) == (21, 21, 24)
    assert (program.globals.DB1.total, program.globals.DB2.total) == (24, 61)
    program.reset(warm=True)
    assert (program.globals.DB1.total, program.globals.DB2.total) == (24, 60)
    program.reset()
    assert program.globals.DB1.total == 40


def test_a_saved_instance_has_it(load: Load) -> None:
    program = load("kept.scl")
    one, two = (program.engine.instance("Counter") for _ in range(2))
    one.call({"total": 33})
    two.restore(one.snapshot())
    assert two.get("total") == 34


def test_in_iec_both_in_outs_are_the_variable_itself(load: Load) -> None:
    instance = load("references.st").instance("Parameters")
    instance()
    assert instance.shared == 12
