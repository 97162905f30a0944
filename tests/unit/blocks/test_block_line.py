"""The line between its users: TOS_StatusPoll in turn, and the token that goes from slot to slot.

Source: TOSPBDP001 manual v1.1, 7 (poll FC90 of each drive regularly), 9 (one telegram at a time).
"""

from typing import Any

import pytest

from harness import LoadedProgram
from tests.unit.blocks.line_bench import Answer, LineBench, Request

FC90, FD01 = 0xFC90, 0xFD01
NOBODY = {"invNo": 0, "valid": False, "lost": False, "tripped": False, "tripCode": 0}


def polling(bench: LineBench, count: int = 5) -> Any:
    """A poll of drives 10, 11, ... on the line."""
    drives = [NOBODY | {"invNo": 10 + place, "statusWord": 0} for place in range(5)]
    poll = bench.add("TOS_StatusPoll", enable=True, count=count, timeout=100)
    poll(enable=False, drives=drives)
    return poll


@pytest.mark.fact("tos.status.poll")
def test_trip_code_and_status_word_of_every_drive_are_read_in_turn(program: LoadedProgram) -> None:
    bench = LineBench(program)
    poll = polling(bench, count=3)
    bench.until(lambda: poll.rounds == 2)
    once = [
        f"{inv_no:02X} 47 {comno} 0000" for inv_no in (10, 11, 12) for comno in ("FC90", "FD01")
    ]
    assert bench.sent()[:12] == once * 2


def test_what_was_read_stands_with_its_drive(program: LoadedProgram) -> None:
    def answer(request: Request) -> Answer:
        return Answer(request.inv_no if request.comno == FC90 else 0x100 + request.inv_no)

    bench = LineBench(program, answer)
    poll = polling(bench)
    bench.until(lambda: poll.rounds == 1)
    for place in range(1, 6):
        drive = poll.drives[place]
        assert (drive.valid, drive.lost, drive.tripped) == (True, False, False)
        assert (drive.tripCode, drive.statusWord) == (9 + place, 0x109 + place)


def test_a_drive_that_does_not_answer_is_lost_and_the_others_go_on(program: LoadedProgram) -> None:
    bench = LineBench(program, lambda request: Answer(status=0x8401 * (request.inv_no == 11)))
    poll = polling(bench, count=3)
    bench.until(lambda: poll.rounds == 1)
    assert [poll.drives[place].lost for place in (1, 2, 3)] == [False, True, False]
    assert [poll.drives[place].valid for place in (1, 2, 3)] == [True, False, True]
    assert [str(request)[:7] for request in bench.requests].count("0B 47 F") == 1
    bench.answer = lambda request: Answer()
    bench.until(lambda: poll.rounds == 2)
    assert (poll.drives[2].lost, poll.drives[2].valid) == (False, True)


def test_a_tripped_drive_is_marked(program: LoadedProgram) -> None:
    bench = LineBench(program, lambda request: Answer(0x18, tripped=request.inv_no == 12))
    poll = polling(bench, count=3)
    bench.until(lambda: poll.rounds == 1)
    assert [poll.drives[place].tripped for place in (1, 2, 3)] == [False, False, True]


@pytest.mark.parametrize("inputs", [{"enable": False}, {"count": 0}])
def test_switched_off_or_without_drives_nothing_is_read(
    program: LoadedProgram, inputs: dict[str, bool | int]
) -> None:
    bench = LineBench(program)
    poll = polling(bench)
    bench.give(poll, **inputs)
    bench.cycles(50)
    assert bench.requests == []
    assert bench.owner == 0


def test_a_poll_that_is_switched_off_finishes_its_telegram_and_gives_the_line_back(
    program: LoadedProgram,
) -> None:
    bench = LineBench(program)
    poll = polling(bench)
    bench.cycle()
    bench.give(poll, enable=False)
    bench.cycles(10)
    assert len(bench.requests) == 1
    assert bench.owner == 0


def test_a_command_waits_for_one_poll_telegram_at_most(program: LoadedProgram) -> None:
    bench = LineBench(program)
    stop = bench.add("TOS_Seq_stop", execute=False, invNo=11)
    polling(bench)
    for _ in range(20):
        bench.cycle()
        asked = len(bench.requests)
        bench.give(stop, execute=True)
        bench.until(lambda: bool(stop.done))
        slots = [request.slot for request in bench.requests[asked:]]
        assert 1 in slots
        assert slots.index(1) <= 1
        bench.give(stop, execute=False)
        bench.cycles(3)


def test_users_that_all_want_the_line_get_it_in_turn(program: LoadedProgram) -> None:
    bench = LineBench(program)
    readers = [
        bench.add("TOS_Seq_read_current", execute=True, invNo=number) for number in range(1, 5)
    ]
    polling(bench)
    for _ in range(400):
        bench.cycle()
        for reader in readers:
            bench.give(reader, execute=not reader.done)
    turns = [request.slot for request in bench.requests]
    assert len(turns) > 60
    counts = [turns.count(slot) for slot in range(1, 6)]
    assert max(counts) - min(counts) <= 2, counts


def test_the_steps_of_two_sequences_alternate(program: LoadedProgram) -> None:
    bench = LineBench(program)
    for number in (1, 2):
        bench.add(
            "TOS_Seq_start_forward", execute=True, invNo=number, frequency=1.0, maxFrequency=50.0
        )
    bench.until(lambda: all(user.done for user in bench.users))
    assert [request.slot for request in bench.requests] == [1, 2, 1, 2]


def test_only_the_owner_of_the_line_sees_a_reply(program: LoadedProgram) -> None:
    bench = LineBench(program, lambda request: Answer(100 * request.inv_no))
    for number in (1, 2, 3):
        bench.add("TOS_Seq_read_current", execute=True, invNo=number)
    bench.until(lambda: all(user.done for user in bench.users))
    assert [user.current for user in bench.users] == [1.0, 2.0, 3.0]
