"""TOS_Seq_*: each shipped sequence sends the right telegrams, in order, and stops at an error.

Sources: TOSPBDP001 manual v1.1, 8 G (C400, FA01, FE03, C200); PBDP-110 manual July 2004, 9.1 (C600,
C000, E000); VF-AS1 RS485 manual E6581315, 8.1 (reset without reply, emergency stop bit 12).
"""

from typing import Any

import pytest

from harness import LoadedProgram
from tests.unit.blocks.channel_bench import Answer, ChannelBench, Request, echo
from tests.unit.blocks.vectors import telegrams_of_the_example, vector

SHIPPED: dict[str, tuple[dict[str, float | bool], list[str]]] = {
    "start_forward": ({"frequency": 50.0}, ["0B 50 FA01 1388", "0B 50 FA00 C400"]),
    "start_reverse": ({"frequency": 25.0}, ["0B 50 FA01 09C4", "0B 50 FA00 C600"]),
    "set_frequency": ({"frequency": 12.34}, ["0B 50 FA01 04D2"]),
    "stop": ({"reverse": False}, ["0B 50 FA00 C000"]),
    "read_current": ({}, ["0B 47 FE03 0000"]),
    "read_status": ({}, ["0B 47 FC90 0000"]),
    "fault_reset": ({}, ["0B 50 FA00 E000", "0B 50 FA00 C000"]),
    "emergency_stop": ({}, ["0B 50 FA00 D000"]),
    "manual_example": (
        {"pause": 100},
        ["0B 50 FA00 C400", "0B 50 FA01 1388", "0B 47 FE03 0000", "0B 50 FA00 C200"],
    ),
}
WITH_SET_POINT = ("start_forward", "start_reverse", "set_frequency")


def started(bench: ChannelBench, name: str, **inputs: float | bool) -> Any:
    """A sequence for drive 11 on its channel, with a rising edge of execute."""
    limit = {"maxFrequency": 50.0} if name in WITH_SET_POINT else {}
    given = SHIPPED[name][0] | limit | inputs
    sequence = bench.add(f"TOS_Seq_{name}", execute=True, invNo=11, **given)
    bench.cycle()
    return sequence


@pytest.mark.parametrize("name", SHIPPED)
def test_a_sequence_sends_its_telegrams_in_order_and_is_done(
    program: LoadedProgram, name: str
) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, name)
    assert (sequence.busy, sequence.status, sequence.active) == (True, 0x7001, True)
    bench.until(lambda: not sequence.busy)
    assert bench.sent() == SHIPPED[name][1]
    assert (sequence.done, sequence.error, sequence.status) == (True, False, 0)
    assert bench.user == 0


def test_the_manuals_example_sends_what_the_manual_prints(program: LoadedProgram) -> None:
    current = int(vector("tos.g.current")["word"], 16)
    bench = ChannelBench(
        program, lambda request: Answer(current) if request.comno == 0xFE03 else echo(request)
    )
    sequence = started(bench, "manual_example")
    bench.until(lambda: not sequence.busy)
    for row, request in zip(telegrams_of_the_example(), bench.requests, strict=True):
        octets = str(request).replace(" ", "")
        printed = row["send"].replace(" ", "")[6:]
        assert all(a in ("x", b) for a, b in zip(printed, octets, strict=True)), (row, request)
    assert sequence.current == pytest.approx(float(vector("tos.g.current")["value"]))


@pytest.mark.parametrize(
    ("name", "step"),
    [(name, step) for name, (_, sent) in SHIPPED.items() for step in range(len(sent))],
)
def test_an_error_stops_the_sequence_at_its_step(
    program: LoadedProgram, name: str, step: int
) -> None:
    bench = ChannelBench(program)

    def answer(request: Request) -> Answer:
        return Answer(status=0x8401) if len(bench.requests) > step else echo(request)

    bench.answer = answer
    sequence = started(bench, name)
    bench.until(lambda: not sequence.busy)
    assert (sequence.error, sequence.done, sequence.status) == (True, False, 0x8401)
    assert bench.sent() == SHIPPED[name][1][: step + 1]
    delays_before = {"fault_reset": (0, 1), "manual_example": (0, 0, 1, 1)}
    assert sequence.failedStep == step + 1 + delays_before.get(name, (0,) * 9)[step]
    assert bench.user == 0


def test_after_an_error_an_edge_starts_from_the_first_step(program: LoadedProgram) -> None:
    bench = ChannelBench(program, lambda request: Answer(status=0x8402))
    sequence = started(bench, "start_forward")
    bench.until(lambda: not sequence.busy)
    bench.cycles(3)
    assert sequence.error
    bench.answer = echo
    bench.give(sequence, execute=False)
    bench.cycle()
    assert (sequence.error, sequence.status, sequence.active) == (False, 0x7000, False)
    bench.give(sequence, execute=True)
    bench.cycle()
    assert (sequence.busy, sequence.failedStep) == (True, 0)
    bench.until(lambda: not sequence.busy)
    assert sequence.done
    assert bench.sent()[1:] == SHIPPED["start_forward"][1]


@pytest.mark.parametrize("name", ["start_forward", "start_reverse"])
def test_a_start_writes_the_set_point_before_the_run_command(
    program: LoadedProgram, name: str
) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, name)
    bench.until(lambda: not sequence.busy)
    assert [request.comno for request in bench.requests] == [0xFA01, 0xFA00]


def test_a_start_whose_set_point_is_refused_does_not_run(program: LoadedProgram) -> None:
    bench = ChannelBench(program, lambda request: Answer(status=0x8402))
    sequence = started(bench, "start_forward")
    bench.until(lambda: not sequence.busy)
    assert 0xFA00 not in [request.comno for request in bench.requests]


@pytest.mark.parametrize(("reverse", "word"), [(False, 0xC000), (True, 0xC200)])
def test_a_stop_keeps_the_direction_bit(program: LoadedProgram, reverse: bool, word: int) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, "stop", reverse=reverse)
    bench.until(lambda: not sequence.busy)
    assert [request.data for request in bench.requests] == [word]


def test_a_set_point_above_the_limit_of_the_drive_is_limited(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, "set_frequency", frequency=60.0)
    bench.until(lambda: not sequence.busy)
    assert [request.data for request in bench.requests] == [5000]


def test_inputs_are_latched_at_the_edge(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, "start_forward", frequency=10.0)
    bench.give(sequence, frequency=40.0)
    bench.until(lambda: not sequence.busy)
    assert bench.requests[0].data == 1000


def test_a_reset_expects_no_reply_waits_two_seconds_and_takes_control_again(
    program: LoadedProgram,
) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, "fault_reset")
    bench.until(lambda: sequence.stepNumber == 2)
    assert [request.reply_expected for request in bench.requests] == [False]
    cycles = bench.until(lambda: len(bench.requests) == 2)
    assert 2000 <= cycles * 10 <= 2060
    bench.until(lambda: not sequence.busy)
    assert sequence.done
    assert (bench.requests[1].data, bench.requests[1].reply_expected) == (0xC000, True)


def test_a_second_reset_waits_as_long_as_the_first(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, "fault_reset")
    first = bench.until(lambda: not sequence.busy)
    bench.give(sequence, execute=False)
    bench.cycle()
    bench.give(sequence, execute=True)
    bench.cycle()
    assert bench.until(lambda: not sequence.busy) == first


def test_while_a_reset_waits_others_may_use_the_line(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    reset = started(bench, "fault_reset")
    bench.until(lambda: reset.stepNumber == 2)
    stop = started(bench, "stop")
    assert bench.until(lambda: not stop.busy) < 10
    assert stop.done
    assert reset.busy


@pytest.mark.parametrize(("word", "percent"), [(0, 0.0), (4328, 43.28), (0xFFFF, 655.35)])
def test_a_reading_is_scaled(program: LoadedProgram, word: int, percent: float) -> None:
    bench = ChannelBench(program, lambda request: Answer(word))
    sequence = started(bench, "read_current")
    bench.until(lambda: not sequence.busy)
    assert sequence.current == pytest.approx(percent)


def test_a_trip_code_is_passed_on_as_a_word(program: LoadedProgram) -> None:
    bench = ChannelBench(program, lambda request: Answer(0x18, tripped=True))
    sequence = started(bench, "read_status")
    bench.until(lambda: not sequence.busy)
    assert sequence.trip_code == 0x18


def test_done_lasts_one_call_when_execute_was_taken_back(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    sequence = started(bench, "stop")
    bench.give(sequence, execute=False)
    bench.until(lambda: not sequence.busy)
    assert (sequence.done, sequence.active) == (True, True)
    bench.cycle()
    assert (sequence.done, sequence.status, sequence.active) == (False, 0x7000, False)


def test_the_steps_of_two_sequences_alternate(program: LoadedProgram) -> None:
    bench = ChannelBench(program)
    for name in ("start_forward", "start_reverse"):
        bench.add(f"TOS_Seq_{name}", execute=True, invNo=1, frequency=1.0, maxFrequency=50.0)
    bench.until(lambda: all(user.done for user in bench.users))
    assert [request.slot for request in bench.requests] == [1, 2, 1, 2]


def test_only_the_user_of_the_channel_sees_a_reply(program: LoadedProgram) -> None:
    bench = ChannelBench(program, lambda request: Answer(100 * request.inv_no))
    for number in (1, 2, 3):
        bench.add("TOS_Seq_read_current", execute=True, invNo=number)
    bench.until(lambda: all(user.done for user in bench.users))
    assert [user.current for user in bench.users] == [1.0, 2.0, 3.0]
