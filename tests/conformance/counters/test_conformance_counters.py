"""Counters count rising edges (IEC 61131-3 table 45)."""

from collections.abc import Callable

from harness import LoadedProgram
from harness.engine.variables import BlockInstance

Load = Callable[[str], LoadedProgram]


def pulse(block: BlockInstance, **inputs: bool) -> None:
    block(**inputs)
    block(**dict.fromkeys(inputs, False))


def test_ctu_counts_rising_edges_and_reports_the_preset(load: Load) -> None:
    block = load("counters.scl").instance("Counters")
    block(up=True)
    assert (block.upCount, block.upDone) == (1, False)
    block(up=True)
    assert block.upCount == 1
    block(up=False)
    block(up=True)
    assert (block.upCount, block.upDone) == (2, True)
    block(up=False, reset=True)
    assert (block.upCount, block.upDone) == (0, False)


def test_reset_wins_and_the_edge_is_lost(load: Load) -> None:
    block = load("counters.scl").instance("Counters")
    block(up=True, reset=True)
    block(up=True, reset=False)
    assert block.upCount == 0


def test_ctd_counts_down_from_the_loaded_value(load: Load) -> None:
    block = load("counters.scl").instance("Counters")
    block()
    assert (block.downCount, block.downDone) == (0, True)
    block(load=True)
    assert (block.downCount, block.downDone) == (2, False)
    block(load=False)
    pulse(block, down=True)
    assert (block.downCount, block.downDone) == (1, False)
    pulse(block, down=True)
    pulse(block, down=True)
    assert (block.downCount, block.downDone) == (-1, True)


def test_ctud_counts_both_ways_and_both_edges_cancel(load: Load) -> None:
    block = load("counters.scl").instance("Counters")
    pulse(block, up=True)
    pulse(block, up=True)
    assert (block.bothCount, block.top, block.bottom) == (2, True, False)
    pulse(block, up=True, down=True)
    assert block.bothCount == 2
    pulse(block, down=True)
    pulse(block, down=True)
    assert (block.bothCount, block.top, block.bottom) == (0, False, True)
    block(load=True, reset=True)
    assert block.bothCount == 0
    block(load=True, reset=False)
    assert block.bothCount == 2


def test_counters_stop_at_the_ends_of_their_type(load: Load) -> None:
    block = load("counters.scl").instance("Limits")
    for _ in range(130):
        pulse(block, pulse=True)
    assert (block.highest, block.lowest) == (127, -128)


def test_an_iec_counter_is_called_with_its_kind(load: Load) -> None:
    block = load("iec_counter.scl").instance("Piles")
    block(load=True)
    assert (block.rest, block.empty) == (2, False)
    pulse(block, up=True, load=False)
    assert (block.height, block.full) == (1, False)
    pulse(block, up=True)
    assert (block.height, block.full) == (2, True)
    pulse(block, down=True)
    pulse(block, down=True)
    assert (block.rest, block.empty) == (0, True)
    block(reset=True)
    assert (block.height, block.full) == (0, False)
