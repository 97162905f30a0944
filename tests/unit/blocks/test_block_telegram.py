"""TOS_Telegram without disturbance. Source: TOSPBDP001 manual v1.1, 8 and 9."""

from collections.abc import Callable

import pytest

from harness import LoadedProgram
from tests.unit.blocks.telegram_bench import (
    LOWER_CASE,
    READ,
    SET_POINT,
    SET_POINT_TRIPPED,
    WRITE,
    WRITE_EEPROM,
    TelegramBench,
)
from tests.unit.blocks.vectors import telegrams_of_the_example, vector

JOBS = [
    (WRITE, 0xFA00, 0xC400),
    (WRITE, 0xFA01, 0x1388),
    (READ, 0xFE03, 0),
    (WRITE, 0xFA00, 0xC200),
]
FC90 = 0xFC90
FD01 = 0xFD01


def matches(sent: str, printed: str) -> bool:
    """Whether bytes are those that the manual prints; xx stands for any byte."""
    pairs = zip(sent.split(), printed.split(), strict=True)
    return all(wanted in ("xx", octet) for octet, wanted in pairs)


def test_the_four_telegrams_of_the_manual_byte_for_byte(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    rows = telegrams_of_the_example()
    assert len(rows) == len(JOBS)
    for row, (cmd, comno, data) in zip(rows, JOBS, strict=True):
        bench.send(row["inverter"], cmd, comno, data)
        assert matches(bench.sent[-1], row["send"]), bench.sent[-1]
        bench.cycles(3)
        assert bench.block.busy
        bench.receive_octets(row["receive"])
        assert bench.block.done
        assert bench.block.replyData == int(row["receive"].replace(" ", "")[-4:], 16)
    assert len(bench.sent) == len(rows)


def test_the_current_that_was_read_is_the_data_of_the_reply(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, 0xFE03)
    bench.receive(11, READ, 0xFE03, int(vector("tos.g.current")["word"], 16))
    assert bench.block.replyData == vector("tos.g.current")["decimal"]


def test_status_says_what_goes_on(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    assert bench.block.status == 0x7000
    bench.send(11, READ, 0xFE03)
    assert (bench.block.status, bench.block.busy) == (0x7001, True)
    bench.call()
    assert (bench.block.status, bench.block.busy) == (0x7002, True)
    bench.receive(11, READ, 0xFE03, 1)
    assert (bench.block.status, bench.block.done) == (0x0000, True)
    bench.call()
    assert (bench.block.status, bench.block.done) == (0x0000, True)
    bench.call(execute=False)
    assert (bench.block.status, bench.block.done) == (0x7000, False)


def test_inputs_are_latched_at_the_edge(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, 0xFE03)
    bench.call(invNo=12, cmd=WRITE, comNo=0xFA00, data=0xC400)
    bench.receive(12, WRITE, 0xFA00, 0xC400)
    assert bench.block.busy
    bench.receive(11, READ, 0xFE03, 7)
    assert (bench.block.done, bench.block.replyData) == (True, 7)
    assert len(bench.sent) == 1


def test_taking_execute_back_does_not_stop_the_job_and_done_then_lasts_one_call(
    program: LoadedProgram,
) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, 0xFE03)
    bench.call(execute=False)
    assert bench.block.busy
    bench.receive(11, READ, 0xFE03, 7)
    assert bench.block.done
    bench.call()
    assert not bench.block.done


def test_an_edge_while_busy_starts_nothing(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, 0xFE03)
    bench.call(execute=False)
    bench.call(execute=True, comNo=0xFA00)
    bench.receive(11, READ, 0xFE03, 7)
    assert bench.block.done
    bench.cycles(3)
    assert len(bench.sent) == 1


def test_a_tripped_drive_answers_in_lower_case_and_that_is_a_reply(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, FC90)
    bench.receive(11, READ | LOWER_CASE, FC90, 0x18)
    assert (bench.block.done, bench.block.tripped, bench.block.replyData) == (True, True, 0x18)
    bench.send(11, READ, 0xFE03)
    bench.receive(11, READ, 0xFE03, 1)
    assert (bench.block.done, bench.block.tripped) == (True, False)


@pytest.mark.parametrize("cmd", [WRITE, WRITE_EEPROM])
def test_the_reply_to_a_write_must_repeat_its_data(program: LoadedProgram, cmd: int) -> None:
    bench = TelegramBench(program)
    bench.send(11, cmd, 0xFA01, 0x1388)
    bench.receive(11, cmd, 0xFA01, 0x1387)
    assert bench.block.busy
    bench.receive(11, cmd, 0xFA01, 0x1388)
    assert bench.block.done


@pytest.mark.parametrize(
    "reply",
    [(12, READ, 0xFE03, 1), (11, WRITE, 0xFE03, 1), (11, READ, 0xFE02, 1), (11, 0x4E, 0xFE03, 1)],
)
def test_another_reply_is_not_taken(program: LoadedProgram, reply: tuple[int, ...]) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, 0xFE03)
    bench.receive(*reply)
    assert bench.block.busy


def test_a_broadcast_is_answered_by_drive_0(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(0xFF, WRITE, 0xFA00, 0xC000)
    bench.receive(0, WRITE, 0xFA00, 0xC000)
    assert bench.block.done


# --- the spacer -----------------------------------------------------------------------------------


@pytest.mark.parametrize(("comno", "spacer"), [(0xFE03, "FC 90"), (FC90, "FD 01"), (FD01, "FC 90")])
def test_a_reply_that_would_look_like_the_old_one_is_preceded_by_another_read(
    program: LoadedProgram, comno: int, spacer: str
) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, comno)
    bench.receive(11, READ, comno, 5)
    bench.send(11, READ, comno)
    assert bench.sent[-1][9:] == f"0B 47 {spacer} 00 00"
    bench.cycles(2)
    assert bench.block.busy
    bench.receive(11, READ, int(spacer.replace(" ", ""), 16), 0)
    assert bench.sent[-1][9:].startswith(f"0B 47 {comno >> 8:02X} {comno & 0xFF:02X}")
    assert bench.block.busy
    bench.receive(11, READ, comno, 5)
    assert (bench.block.done, bench.block.replyData) == (True, 5)
    assert len(bench.sent) == 3


@pytest.mark.parametrize("cycles_to_reply", [0, 1, 5])
def test_the_same_write_twice_goes_out_twice_however_long_the_cycle_is(
    program: LoadedProgram, cycles_to_reply: int
) -> None:
    bench = TelegramBench(program)
    for number in range(2):
        bench.send(11, WRITE, 0xFA00, 0xC400)
        bench.cycles(cycles_to_reply)
        if number > 0:
            bench.receive(11, READ, FC90, 0)
            bench.cycles(1 + cycles_to_reply)
        bench.receive(11, WRITE, 0xFA00, 0xC400)
        assert bench.block.done
    writes = [frame for frame in bench.sent if frame[9:] == "0B 50 FA 00 C4 00"]
    assert len(writes) == 2
    assert len(bench.sent) == 3


def test_another_drive_or_comno_needs_no_spacer(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    for inv_no, comno in ((11, 0xFE03), (12, 0xFE03), (12, 0xFE02), (11, 0xFE02)):
        bench.send(inv_no, READ, comno)
        bench.receive(inv_no, READ, comno, 5)
        assert bench.block.done
    assert len(bench.sent) == 4


# --- no reply expected ----------------------------------------------------------------------------


@pytest.mark.parametrize("cmd", [SET_POINT, SET_POINT_TRIPPED, WRITE])
def test_without_a_reply_the_job_is_done_after_the_gap(program: LoadedProgram, cmd: int) -> None:
    bench = TelegramBench(program)
    bench.send(11, cmd, 0xFA01, 0x1388, replyExpected=False, gap=60)
    cycles = bench.until_finished()
    assert cycles * 10 >= 60
    assert cycles * 10 <= 80
    assert (bench.block.done, bench.block.status) == (True, 0)
    assert len(bench.sent) == 1


def test_without_a_reply_no_spacer_goes_out(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(11, WRITE, 0xFA00, 0xC400)
    bench.receive(11, WRITE, 0xFA00, 0xC400)
    bench.send(11, WRITE, 0xFA00, 0xE000, replyExpected=False)
    assert [frame[9:] for frame in bench.sent] == ["0B 50 FA 00 C4 00", "0B 50 FA 00 E0 00"]


# --- between the jobs -----------------------------------------------------------------------------


@pytest.mark.parametrize("replies", [True, False])
def test_after_a_job_the_frame_holds_a_harmless_read_and_the_trigger_stands(
    program: LoadedProgram, replies: bool
) -> None:
    bench = TelegramBench(program)
    bench.send(11, WRITE, 0xFA00, 0xC400, retries=0)
    if replies:
        bench.receive(11, WRITE, 0xFA00, 0xC400)
    else:
        bench.until_finished()
    assert bench.frame()[6:] == "01 0B 47 FC 90 00 00"
    bench.cycles(50)
    assert bench.frame()[6:] == "01 0B 47 FC 90 00 00"


def test_frame_changed_is_set_in_just_the_calls_that_change_the_frame(
    program: LoadedProgram,
) -> None:
    bench = TelegramBench(program)
    before = bench.frame()
    steps: list[Callable[[], None]] = [
        bench.call,
        lambda: bench.send(11, WRITE, 0xFA00, 0xC400),
        bench.call,
        lambda: bench.receive(11, WRITE, 0xFA00, 0xC400),
        bench.call,
        lambda: bench.call(execute=False),
        lambda: bench.send(11, WRITE, 0xFA01, 0x1388),
    ]
    for step in steps:
        step()
        assert bench.block.frameChanged == (bench.frame() != before)
        before = bench.frame()


def test_without_handshake_the_control_word_stays_0000(program: LoadedProgram) -> None:
    bench = TelegramBench(program, handshake=False)
    bench.send(11, WRITE, 0xFA00, 0xC400)
    assert bench.sent == ["00 00 01 0B 50 FA 00 C4 00"]
    bench.receive(11, WRITE, 0xFA00, 0xC400)
    assert bench.block.done
