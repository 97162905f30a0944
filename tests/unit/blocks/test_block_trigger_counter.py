"""TOS_TriggerCounter. Source: TOSPBDP001 manual v1.1, 8 B (power-on value 00, counter 01 to FF)."""

import pytest

from harness import LoadedProgram
from tests.unit.blocks.programs import block


def test_it_shows_00_until_the_first_telegram(program: LoadedProgram) -> None:
    counter = block(program, "TOS_TriggerCounter")
    for _ in range(3):
        counter(advance=False)
        assert counter.trigger == 0


@pytest.mark.fact("tos.trig")
def test_it_begins_with_ff_and_counts_01_to_ff_and_01_again_never_00(
    program: LoadedProgram,
) -> None:
    counter = block(program, "TOS_TriggerCounter")
    seen = []
    for _ in range(600):
        counter(advance=True)
        seen.append(counter.trigger)
        counter(advance=False)
        assert counter.trigger == seen[-1]
    assert seen == [255, *(number % 255 + 1 for number in range(599))]


def test_it_takes_one_step_per_edge_however_long_advance_stays(program: LoadedProgram) -> None:
    counter = block(program, "TOS_TriggerCounter")
    for _ in range(5):
        counter(advance=True)
    assert counter.trigger == 255
    counter(advance=False)
    counter(advance=True)
    assert counter.trigger == 1


def test_two_counters_do_not_share_their_count(program: LoadedProgram) -> None:
    first, second = (block(program, "TOS_TriggerCounter") for _ in range(2))
    first(advance=True)
    second(advance=False)
    assert (first.trigger, second.trigger) == (255, 0)
