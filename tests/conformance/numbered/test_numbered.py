"""Timers, counters and data blocks as parameters: TIMER, COUNTER, BLOCK_DB, DB_ANY.

Expected values: S7-SCL V5.3 manual, "Parameter types TIMER and COUNTER", "BLOCK"; TIA Portal help,
"DB_ANY".
"""

from pathlib import Path

import pytest

from harness import load_program
from harness.engine.variables import BlockInstance

_HERE = Path(__file__).parent
_BLOCKS = {"numbers.scl": ("tia", "Numbers"), "numbers.step7": ("step7", "FB1")}


@pytest.fixture(params=sorted(_BLOCKS))
def block(request: pytest.FixtureRequest, engine_name: str) -> BlockInstance:
    """A block that was called twice, two seconds apart."""
    dialect, name = _BLOCKS[request.param]
    path = _HERE / request.param
    numbers = {"values": 20}
    program = load_program([path], dialect=dialect, engine=engine_name, db_numbers=numbers)
    instance = program.instance(name)
    instance()
    assert not instance["q"]
    program.clock.advance(s=2)
    instance()
    return instance


def test_a_block_starts_the_timer_that_it_is_given(block: BlockInstance) -> None:
    assert block["q"]


def test_a_block_reads_the_data_block_that_it_is_given(block: BlockInstance) -> None:
    assert block["a"] == 5 + 7


def test_a_number_becomes_a_data_block(block: BlockInstance) -> None:
    assert block["c"] == 5 + 7


def test_the_number_of_a_named_data_block_is_handed_on(engine_name: str) -> None:
    path = _HERE / "numbers.scl"
    program = load_program([path], dialect="tia", engine=engine_name, db_numbers={"values": 20})
    instance = program.instance("Numbers")
    instance()
    assert instance["b"] == 50 + 70
