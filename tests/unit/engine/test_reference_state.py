"""State of the reference evaluator: snapshots can be kept, compared and brought back."""

from pathlib import Path

import pytest

from harness import LoadedProgram, load_program

FILE = Path(__file__).with_name("engine_program.scl")


@pytest.fixture
def program() -> LoadedProgram:
    return load_program([FILE], engine="reference")


def test_an_instance_goes_back_to_its_snapshot_with_its_timers(program: LoadedProgram) -> None:
    counter = program.engine.instance("Counter")
    counter.call({"step": 2})
    saved = counter.snapshot()
    program.clock.advance(ms=10)
    counter.call({})
    assert counter.get("delay.Q") is True
    later = counter.snapshot()
    assert later != saved
    counter.restore(saved)
    assert counter.snapshot() == saved
    assert (counter.get("count"), counter.get("delay.Q")) == (2, False)
    counter.call({})
    assert counter.snapshot() == later


def test_a_snapshot_fits_another_instance_of_the_block(program: LoadedProgram) -> None:
    one, two = program.engine.instance("Counter"), program.engine.instance("Counter")
    one.call({"step": 2})
    two.restore(one.snapshot())
    one.call({})
    assert (one.get("count"), two.get("count")) == (4, 2)


def test_hidden_memory_belongs_to_the_snapshot(program: LoadedProgram) -> None:
    one, two = program.engine.instance("R_TRIG"), program.engine.instance("R_TRIG")
    one.call({"CLK": True})
    one.call({"CLK": True})
    two.set("CLK", True)
    assert one.get("Q") == two.get("Q")
    assert one.snapshot() != two.snapshot()


def test_the_program_goes_back_to_its_snapshot(program: LoadedProgram) -> None:
    saved = program.engine.snapshot()
    program.run("Main")
    assert program.engine.snapshot() != saved
    program.engine.restore(saved)
    assert program.engine.snapshot() == saved
    assert program.globals.Plant.point.x == 9


def test_a_data_block_of_a_function_block_can_be_called(program: LoadedProgram) -> None:
    program.engine.global_instance("CounterDb").call({})
    assert program.globals.CounterDb.count == 5
