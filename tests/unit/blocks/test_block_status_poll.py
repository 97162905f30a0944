"""TOS_StatusPoll: four values of each drive in turn, their ages, drives that are lost.

Source: TOSPBDP001 manual v1.1, 7 (poll FC90 of each drive regularly), 9 (one telegram at a time).
"""

from typing import Any

import pytest

from harness import LoadedProgram
from tests.unit.blocks.channel_bench import CYCLE_MS, Answer, ChannelBench, Request

FC90, FD01, FD00, FE03 = 0xFC90, 0xFD01, 0xFD00, 0xFE03
NOBODY = {"invNo": 0, "valid": False, "lost": False, "tripped": False, "tripCode": 0}


def polling(bench: ChannelBench, count: int = 5) -> Any:
    """A poll of drives 10, 11, ... on the line."""
    drives = [NOBODY | {"invNo": 10 + place, "statusWord": 0} for place in range(5)]
    poll = bench.add("TOS_StatusPoll", enable=True, count=count, timeout=100)
    poll(enable=False, drives=drives)
    return poll


@pytest.mark.fact("tos.status.poll")
def test_four_values_of_every_drive_are_read_in_turn(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    poll = polling(bench, count=3)
    bench.until(lambda: poll.rounds == 2)
    once = [
        f"{inv_no:02X} 47 {comno} 0000"
        for inv_no in (10, 11, 12)
        for comno in ("FC90", "FD01", "FD00", "FE03")
    ]
    assert bench.sent()[:24] == once * 2


def test_what_was_read_stands_with_its_drive(program: LoadedProgram) -> None:
    def answer(request: Request) -> Answer:
        base = {FC90: 0, FD01: 0x100, FD00: 0x200, FE03: 0x300}
        return Answer(base[request.comno] + request.inv_no)

    bench = ChannelBench(program, answer)
    poll = polling(bench)
    bench.until(lambda: poll.rounds == 1)
    for place in range(1, 6):
        drive = poll.drives[place]
        assert (drive.valid, drive.lost, drive.tripped) == (True, False, False)
        assert (drive.tripCode, drive.statusWord) == (9 + place, 0x109 + place)
        assert drive.frequency == pytest.approx((0x209 + place) / 100)
        assert drive.current == pytest.approx((0x309 + place) / 100)


def test_each_value_has_its_age(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    poll = polling(bench, count=2)
    bench.until(lambda: poll.rounds == 2)
    first = poll.drives[1]
    ages = [first.tripCodeAge, first.statusWordAge, first.frequencyAge, first.currentAge]
    cycles = bench.cycles_to_reply + 1
    assert ages == [turns * cycles * CYCLE_MS for turns in (3, 2, 1, 0)]
    bench.answer = lambda request: Answer(status=0x8401)
    bench.until(lambda: poll.rounds == 12)
    assert poll.drives[1].currentAge > 20 * cycles * CYCLE_MS


def test_ages_go_on_when_the_clock_begins_again(program: LoadedProgram) -> None:
    bench = ChannelBench(program, lambda request: Answer(status=0x8401 * (request.inv_no == 10)))
    poll = polling(bench, count=2)
    for _ in range(3):
        bench.program.clock.advance(ms=3_500_000)
        bench.cycles(40)
    assert 10_500_000 <= poll.drives[1].tripCodeAge <= 10_505_000
    assert poll.drives[2].tripCodeAge < 1_000


def test_a_drive_that_does_not_answer_is_lost_and_the_others_go_on(program: LoadedProgram) -> None:
    bench = ChannelBench(program, lambda request: Answer(status=0x8401 * (request.inv_no == 11)))
    poll = polling(bench, count=3)
    bench.until(lambda: poll.rounds == 1)
    assert [poll.drives[place].lost for place in (1, 2, 3)] == [False, True, False]
    assert [poll.drives[place].valid for place in (1, 2, 3)] == [True, False, True]
    assert [str(request)[:7] for request in bench.requests].count("0B 47 F") == 1
    bench.answer = lambda request: Answer()
    bench.until(lambda: poll.rounds == 2)
    assert (poll.drives[2].lost, poll.drives[2].valid) == (False, True)


def test_a_tripped_drive_is_marked(program: LoadedProgram) -> None:
    bench = ChannelBench(program, lambda request: Answer(0x18, tripped=request.inv_no == 12))
    poll = polling(bench, count=3)
    bench.until(lambda: poll.rounds == 1)
    assert [poll.drives[place].tripped for place in (1, 2, 3)] == [False, False, True]


@pytest.mark.parametrize("inputs", [{"enable": False}, {"count": 0}])
def test_switched_off_or_without_drives_nothing_is_read(
    program: LoadedProgram, inputs: dict[str, bool | int]
) -> None:
    bench = ChannelBench(program)
    poll = polling(bench)
    bench.give(poll, **inputs)
    bench.cycles(50)
    assert bench.requests == []


def test_a_poll_that_is_switched_off_finishes_its_telegram(
    program: LoadedProgram,
) -> None:
    bench = ChannelBench(program)
    poll = polling(bench)
    bench.cycle()
    bench.give(poll, enable=False)
    bench.cycles(10)
    assert len(bench.requests) == 1
