"""TOS_Line: whose telegram is next, the emergency stop, the loss of the gateway.

Sources: TOSPBDP001 manual v1.1, 9 (one telegram at a time); VF-AS1 RS485 manual E6581315, 8.1
(emergency stop, bit 12, always enabled).
"""

from itertools import pairwise

import pytest

from harness import LoadedProgram
from tests.unit.blocks.line_bench import DRIVES, GAP_MS, POLL, TIMEOUT_MS, LineBench
from tests.unit.blocks.telegram_bench import CYCLE_MS, READ, WRITE

STOP = "FA00 D000"
BROADCAST = f"FF 50 {STOP}"
IN_A_ROW = 8
DONE = (True, False, 0)


def test_a_request_is_sent_and_gets_its_reply(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.run(3)
    bench.until(lambda: bench.reply(3) == DONE)
    assert bench.sent == ["0D 50 FA00 C400"]
    assert not bench.channels[3]["request"]["execute"]


def test_drives_that_all_want_the_line_get_it_in_turn(program: LoadedProgram) -> None:
    bench = LineBench(program)
    for turn in range(60):
        for number in range(1, DRIVES + 1):
            if not bench.channels[number]["request"]["execute"]:
                bench.ask(number, WRITE, 0xFA01, turn)
        asked = len(bench.sent)
        bench.until(lambda asked=asked: len(bench.sent) > asked)  # type: ignore[misc]
    order = [int(text[:2], 16) - 11 for text in bench.sent]
    assert order == [number % DRIVES for number in range(len(order))]


def test_a_command_goes_before_the_poll(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.ask(POLL, READ, 0xFC90)
    bench.run(4)
    bench.until(lambda: bench.reply(POLL) == DONE)
    assert [text[:5] for text in bench.sent] == ["0E 50", "0B 47"]


def test_the_poll_has_its_turn_while_commands_wait(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.ask(POLL, READ, 0xFC90)
    for turn in range(IN_A_ROW + 1):
        for number in range(1, DRIVES + 1):
            bench.ask(number, WRITE, 0xFA01, turn)
        asked = len(bench.sent)
        bench.until(lambda asked=asked: len(bench.sent) > asked)  # type: ignore[misc]
    assert [text[3:5] for text in bench.sent] == ["50"] * IN_A_ROW + ["47"]


def test_a_drive_that_does_not_answer_keeps_the_others_waiting_no_longer_than_stated(
    program: LoadedProgram,
) -> None:
    bench = LineBench(program)
    bench.answers = lambda inv_no: inv_no == 15
    for number in range(1, DRIVES):
        bench.ask(number, READ, 0xFE03, timeout=TIMEOUT_MS)
    bench.call()
    bench.run(5)
    start = bench.now_ms
    bench.until(lambda: bench.reply(5) == DONE)
    assert bench.now_ms - start <= DRIVES * (4 * TIMEOUT_MS + 6 * CYCLE_MS)
    assert [bench.reply(number)[2] for number in range(1, DRIVES)] == [0x8401] * 4


# --- emergency stop -------------------------------------------------------------------------------


def test_the_emergency_stop_goes_to_all_and_then_to_each(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.call(emergencyStop=True)
    assert bench.block.stopping
    bench.until(lambda: bool(bench.block.stopped))
    assert bench.sent == [BROADCAST, *(f"{10 + number:02X} 50 {STOP}" for number in range(1, 6))]
    assert (bench.block.stopping, bench.block.unreached) == (False, 0)
    bench.cycles(100)
    assert len(bench.sent) == DRIVES + 1


def test_it_ends_the_wait_for_a_reply_and_goes_one_gap_later(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.answers = lambda inv_no: inv_no != 12
    bench.ask(2, READ, 0xFE03, timeout=60_000)
    bench.cycles(3)
    bench.call(emergencyStop=True)
    start = bench.now_ms
    bench.until(lambda: BROADCAST in bench.sent)
    assert GAP_MS <= bench.now_ms - start <= GAP_MS + 3 * CYCLE_MS
    assert bench.reply(2) == (False, True, 0x8405)


def test_what_waited_before_it_is_never_sent(program: LoadedProgram) -> None:
    bench = LineBench(program)
    for number in range(1, DRIVES + 1):
        bench.run(number)
    bench.cycles(2)
    bench.call(emergencyStop=True)
    bench.call(emergencyStop=False)
    bench.run(1)
    bench.until(lambda: bool(bench.block.stopped))
    bench.cycles(100)
    assert bench.sent.count("0B 50 FA00 C400") == 1
    assert [text for text in bench.sent if "C400" in text] == ["0B 50 FA00 C400"]
    assert [bench.reply(number) for number in range(2, 6)] == [(False, True, 0x8406)] * 4
    assert bench.reply(1)[1:] in ((True, 0x8405), (True, 0x8406))


def test_while_it_is_on_commands_are_refused_and_values_are_read(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.call(emergencyStop=True)
    bench.until(lambda: bool(bench.block.stopped))
    bench.run(1)
    bench.ask(2, READ, 0xFE03)
    bench.until(lambda: bench.reply(2) == DONE)
    assert bench.reply(1) == (False, True, 0x8406)
    bench.call(emergencyStop=False)
    bench.run(1)
    bench.until(lambda: bench.reply(1) == DONE)


def test_a_drive_that_does_not_acknowledge_it_is_counted(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.answers = lambda inv_no: inv_no not in (12, 14)
    bench.call(emergencyStop=True)
    bench.until(lambda: not bench.block.stopping)
    assert (bench.block.stopped, bench.block.unreached) == (False, 2)
    bench.call(emergencyStop=False)
    bench.answers = lambda inv_no: True
    bench.call(emergencyStop=True)
    bench.until(lambda: bool(bench.block.stopped))
    assert bench.block.unreached == 0


def test_on_a_free_line_it_goes_in_the_same_call(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.call(emergencyStop=True)
    assert bench.sent == [BROADCAST]


def test_a_gateway_that_comes_back_gets_it_again_while_it_is_on(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.call(ioError=True)
    bench.call(emergencyStop=True)
    bench.until(lambda: not bench.block.stopping)
    assert (bench.block.stopped, bench.block.unreached, bench.sent) == (False, DRIVES, [])
    bench.call(ioError=False)
    bench.until(lambda: bool(bench.block.stopped))
    assert bench.sent[:2] == ["05 47 FC90 0000", BROADCAST]
    assert len(bench.sent) == DRIVES + 2
    bench.call(ioError=True)
    bench.call(ioError=False)
    bench.cycles(100)
    assert bench.sent[DRIVES + 2 :] == ["0F 47 FC90 0000"]


def test_a_second_edge_begins_again(program: LoadedProgram) -> None:
    bench = LineBench(program)
    bench.call(emergencyStop=True)
    bench.until(lambda: len(bench.sent) == 3)
    bench.call(emergencyStop=False)
    bench.call(emergencyStop=True)
    bench.until(lambda: bool(bench.block.stopped))
    writes = [text for text in bench.sent[3:] if text[3:5] == "50"]
    assert bench.sent[3] == BROADCAST
    assert writes == [BROADCAST, *(f"{10 + number:02X} 50 {STOP}" for number in range(1, 6))]


# --- loss of the gateway --------------------------------------------------------------------------


@pytest.mark.parametrize("loss", ["ioError", "restart"])
def test_no_command_from_before_a_loss_is_sent_after_it(program: LoadedProgram, loss: str) -> None:
    bench = LineBench(program)
    for number in range(1, DRIVES + 1):
        bench.run(number)
    bench.cycles(2)
    bench.call(**{loss: True})
    assert not bench.block.online
    bench.call(**{loss: False})
    bench.cycles(100)
    assert bench.sent == ["0B 50 FA00 C400", "0B 47 FC90 0000"]
    assert [bench.reply(number) for number in range(1, 6)] == [(False, True, 0x8404)] * 5
    assert bench.block.online


@pytest.mark.fact("tos.t.gap")
def test_after_a_loss_another_drive_than_the_read_waits_too(program: LoadedProgram) -> None:
    bench = LineBench(program, apart=200)
    bench.cycles_to_reply = 1
    bench.run(1)
    bench.until(lambda: bench.reply(1) == DONE)
    bench.run(2)  # is refused before it has gone out
    bench.call(ioError=True)
    bench.call(ioError=False)
    bench.run(2)
    bench.until(lambda: bench.reply(2) == DONE)
    assert bench.sent == ["0B 50 FA00 C400", "0B 47 FC90 0000", "0C 50 FA00 C400"]
    assert bench.times[2] - bench.times[1] >= 200


@pytest.mark.fact("tos.t.gap")
@pytest.mark.parametrize("apart_ms", [0, 80, 120])
def test_another_drive_waits_for_the_time_that_lies_between_drives(
    program: LoadedProgram, apart_ms: int
) -> None:
    bench = LineBench(program, apart=apart_ms)
    bench.cycles_to_reply = 1
    for number in (1, 2, 3):
        bench.run(number)
    bench.until(lambda: bench.reply(3) == DONE)
    assert [text[:2] for text in bench.sent] == ["0B", "0C", "0D"]
    distances = [after - before for before, after in pairwise(bench.times)]
    natural_ms = 4 * CYCLE_MS
    assert all(max(apart_ms, natural_ms) <= one <= max(apart_ms, natural_ms) + 2 * CYCLE_MS
               for one in distances), distances  # fmt: skip


def test_the_same_drive_does_not_wait(program: LoadedProgram) -> None:
    bench = LineBench(program, apart=500)
    bench.cycles_to_reply = 1
    bench.ask(1, WRITE, 0xFA01, 1)
    bench.until(lambda: bench.reply(1) == DONE)
    bench.ask(1, WRITE, 0xFA01, 2)
    bench.until(lambda: bench.reply(1) == DONE)
    before, after = bench.times[0], bench.times[-1]
    assert after - before < 200


def test_a_command_that_comes_while_a_poll_waits_goes_first(program: LoadedProgram) -> None:
    bench = LineBench(program, apart=200)
    bench.cycles_to_reply = 1
    bench.run(2)
    bench.until(lambda: bench.reply(2) == DONE)
    bench.ask(POLL, READ, 0xFC90)
    bench.cycles(3)
    bench.run(3)
    bench.until(lambda: bench.reply(POLL) == DONE)
    assert [text[:5] for text in bench.sent] == ["0C 50", "0D 50", "0B 47"]


def test_the_broadcast_of_an_emergency_stop_does_not_wait(program: LoadedProgram) -> None:
    bench = LineBench(program, apart=500)
    bench.cycles_to_reply = 1
    bench.run(2)
    bench.until(lambda: bench.reply(2) == DONE)
    sent_at = bench.times[-1]
    bench.call(emergencyStop=True)
    bench.until(lambda: bench.sent[-1] == BROADCAST)
    assert bench.times[-1] - sent_at < 200
