"""TOS_Telegram when something goes wrong: refusals, retries, error codes, PLCopen rules."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from harness import LoadedProgram
from harness.engine.loading import ENGINES
from tests.unit.blocks.programs import ALL_SEQUENCES, loaded
from tests.unit.blocks.telegram_bench import (
    CYCLE_MS,
    GAP_MS,
    READ,
    WRITE,
    WRITE_EEPROM,
    TelegramBench,
)

TIMEOUT_MS = 100


def failing(program: LoadedProgram, retries: int = 0) -> TelegramBench:
    """A job that waits for the reply of drive 11."""
    bench = TelegramBench(program)
    bench.send(11, READ, 0xFE03, timeout=TIMEOUT_MS, retries=retries)
    return bench


@pytest.mark.parametrize("inv_no", [0x40, 0x80, 0xFE])
def test_an_inverter_number_that_no_drive_can_have_is_8201(
    program: LoadedProgram, inv_no: int
) -> None:
    bench = TelegramBench(program)
    bench.send(inv_no, READ, 0xFE03)
    assert (bench.block.error, bench.block.status, bench.block.busy) == (True, 0x8201, False)
    assert bench.sent == []


@pytest.mark.parametrize("inv_no", [0x00, 0x3F, 0xFF])
def test_the_first_and_the_last_number_and_the_broadcast_are_sent(
    program: LoadedProgram, inv_no: int
) -> None:
    bench = TelegramBench(program)
    bench.send(inv_no, READ, 0xFE03)
    assert bench.block.busy


@pytest.mark.parametrize("cmd", [0x00, 0x52, 0x4E, 0x67, 0x70, 0x77, 0xFF])
def test_a_command_that_the_gateway_does_not_list_is_8201(program: LoadedProgram, cmd: int) -> None:
    bench = TelegramBench(program)
    bench.send(11, cmd, 0xFE03)
    assert (bench.block.error, bench.block.status, bench.block.busy) == (True, 0x8201, False)
    assert bench.sent == []


def test_after_a_refusal_the_next_edge_sends(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(0x40, READ, 0xFE03)
    bench.send(11, READ, 0xFE03)
    assert (bench.block.busy, bench.block.error) == (True, False)


def test_silence_is_8401_when_the_time_is_over(program: LoadedProgram) -> None:
    bench = failing(program)
    cycles = bench.until_finished()
    assert TIMEOUT_MS <= cycles * 10 <= TIMEOUT_MS + 20
    assert (bench.block.error, bench.block.status) == (True, 0x8401)


def test_silence_with_a_higher_error_counter_is_8402(program: LoadedProgram) -> None:
    bench = failing(program)
    bench.status = 0xDF01
    bench.until_finished()
    assert (bench.block.error, bench.block.status) == (True, 0x8402)
    assert (bench.block.gatewayFault, bench.block.errorCount) == (True, 1)


def test_silence_with_a_fault_of_the_gateway_is_8402(program: LoadedProgram) -> None:
    bench = failing(program)
    bench.status = 0x1E00
    bench.until_finished()
    assert bench.block.status == 0x8402


def test_the_reply_of_another_drive_is_8403(program: LoadedProgram) -> None:
    bench = failing(program)
    bench.receive(12, READ, 0xFE03, 1)
    bench.until_finished()
    assert (bench.block.error, bench.block.status) == (True, 0x8403)


@pytest.mark.parametrize("loss", [{"ioError": True}, {"restart": True}, {}])
def test_without_a_gateway_the_job_ends_at_once_with_8404(
    program: LoadedProgram, loss: dict[str, bool]
) -> None:
    bench = TelegramBench(program)
    bench.send(11, WRITE, 0xFA00, 0xC400, retries=2)
    if not loss:
        bench.status = 0x0000
    bench.call(**loss)
    assert (bench.block.error, bench.block.status) == (True, 0x8404)
    assert (bench.block.online, bench.frame()[9:]) == (False, "0B 47 FC 90 00 00")


@pytest.mark.parametrize("loss", [{"ioError": True}, {}])
def test_while_there_is_no_gateway_nothing_is_sent(
    program: LoadedProgram, loss: dict[str, bool]
) -> None:
    bench = TelegramBench(program)
    bench.send(11, WRITE, 0xFA00, 0xC400, retries=2)
    if not loss:
        bench.status = 0x0000
    bench.call(**loss)
    bench.send(11, WRITE, 0xFA00, 0xC400)
    assert (bench.block.error, bench.block.status) == (True, 0x8404)
    assert len(bench.sent) == 1


@pytest.mark.parametrize("loss", [{"ioError": True}, {"restart": True}])
def test_after_a_loss_a_read_goes_out_first_and_no_command_again(
    program: LoadedProgram, loss: dict[str, bool]
) -> None:
    bench = TelegramBench(program)
    bench.send(11, WRITE, 0xFA00, 0xC400, retries=5)
    bench.call(**loss)
    bench.call(**dict.fromkeys(loss, False))
    bench.cycles(100)
    assert [frame[6:] for frame in bench.sent] == [
        "01 0B 50 FA 00 C4 00",
        "02 0B 47 FC 90 00 00",
    ]
    assert bench.block.online


def test_from_the_loss_on_the_frame_holds_the_read_with_its_trigger(program: LoadedProgram) -> None:
    """What gets through to a gateway that comes back is written over what lies there."""
    bench = TelegramBench(program)
    bench.send(11, WRITE, 0xFA00, 0xC400)
    bench.call()
    for _ in range(5):
        bench.call(ioError=True)
        assert (bench.block.frameChanged, bench.frame()[6:]) == (True, "02 0B 47 FC 90 00 00")
    bench.call(ioError=False)
    assert (bench.block.frameChanged, bench.frame()[6:]) == (True, "02 0B 47 FC 90 00 00")
    bench.call()
    assert not bench.block.frameChanged


def test_a_loss_right_behind_a_command_still_gives_the_read_a_trigger_of_its_own(
    program: LoadedProgram,
) -> None:
    bench = TelegramBench(program)
    bench.send(11, WRITE, 0xFA00, 0xC400)
    bench.call(ioError=True)
    bench.call(ioError=False)
    assert [frame[6:] for frame in bench.sent] == ["01 0B 50 FA 00 C4 00", "02 0B 47 FC 90 00 00"]


def test_behind_a_broadcast_the_read_goes_to_drive_0(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(0xFF, WRITE, 0xFA00, 0xD000, replyExpected=False)
    bench.until_finished()
    bench.call(ioError=True)
    bench.call(ioError=False)
    assert bench.sent[-1][6:] == "02 00 47 FC 90 00 00"


def test_a_job_that_comes_with_the_first_read_follows_it(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.call(ioError=True)
    bench.send(11, WRITE, 0xFA00, 0xC400, ioError=False)
    assert bench.block.busy
    bench.cycles(3)
    assert [frame[9:] for frame in bench.sent] == ["05 47 FC 90 00 00"]
    bench.receive(5, READ, 0xFC90, 0)
    bench.cycles(2)
    assert [frame[9:] for frame in bench.sent] == ["05 47 FC 90 00 00", "0B 50 FA 00 C4 00"]


def test_a_job_does_not_wait_for_ever_for_the_first_read(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.call(ioError=True, firstTimeout=80)
    bench.send(11, WRITE, 0xFA00, 0xC400, ioError=False)
    bench.cycles(80 // CYCLE_MS + 3)
    assert [frame[9:] for frame in bench.sent] == ["05 47 FC 90 00 00", "0B 50 FA 00 C4 00"]


def test_abort_ends_the_job_and_the_next_one_waits_until_a_late_reply_is_over(
    program: LoadedProgram,
) -> None:
    bench = failing(program, retries=2)
    bench.call(abort=True)
    assert (bench.block.error, bench.block.status) == (True, 0x8405)
    bench.send(11, WRITE, 0xFA00, 0xD000, abort=False)
    cycles = 0
    while len(bench.sent) < 2:
        bench.call()
        cycles += 1
    assert GAP_MS <= (cycles + 2) * CYCLE_MS <= GAP_MS + 20
    assert bench.sent[-1][9:] == "0B 50 FA 00 D0 00"


def test_the_same_job_after_one_without_reply_has_two_spacers_in_front(
    program: LoadedProgram,
) -> None:
    bench = failing(program)
    bench.until_finished()
    bench.send(11, READ, 0xFE03)
    for late in range(2):
        bench.receive(11, READ, 0xFE03, late)
    assert bench.block.busy
    for comno in (0xFD01, 0xFC90):
        bench.receive(11, READ, comno, 0)
        bench.cycles(2)
    bench.receive(11, READ, 0xFE03, 2)
    bench.call()
    assert (bench.block.done, bench.block.replyData) == (True, 2)
    asked = [frame[9:20] for frame in bench.sent]
    assert asked == ["0B 47 FE 03", "0B 47 FD 01", "0B 47 FC 90", "0B 47 FE 03"]


def test_while_a_drive_may_still_answer_a_reply_counts_when_two_calls_have_seen_it(
    program: LoadedProgram,
) -> None:
    bench = failing(program)
    bench.until_finished()
    bench.send(12, READ, 0xFE03)
    bench.cycles(2)
    bench.receive_at_once(12, READ, 0xFE03, 1)
    assert bench.block.busy
    bench.receive_at_once(12, READ, 0xFE03, 2)
    assert bench.block.busy
    bench.call()
    assert (bench.block.done, bench.block.replyData) == (True, 2)


def test_a_write_goes_out_once_also_where_the_spacers_have_no_reply(
    program: LoadedProgram,
) -> None:
    bench = TelegramBench(program, timeout=TIMEOUT_MS, retries=1)
    for _ in range(2):
        bench.send(11, WRITE, 0xFA00, 0xC000)
        bench.until_finished()
    assert [frame[9:20] for frame in bench.sent[2:]] == ["0B 47 FD 01"] * 2 + ["0B 50 FA 00"]
    assert (bench.block.error, bench.block.status) == (True, 0x8401)


@pytest.mark.parametrize(
    ("cmd", "comno", "data"), [(WRITE_EEPROM, 0x0009, 50), (WRITE, 0xFA00, 0xE000)]
)
def test_a_write_to_the_eeprom_and_a_reset_are_never_repeated(
    program: LoadedProgram, cmd: int, comno: int, data: int
) -> None:
    bench = TelegramBench(program, timeout=TIMEOUT_MS, retries=2)
    bench.send(11, cmd, comno, data)
    bench.until_finished()
    assert len(bench.sent) == 1
    assert bench.block.status == 0x8401


@pytest.mark.parametrize("answerer", [0x00, 0xFF])
def test_drive_0_answers_a_broadcast_with_its_own_number_or_that_of_the_broadcast(
    program: LoadedProgram, answerer: int
) -> None:
    bench = TelegramBench(program)
    bench.send(0xFF, WRITE, 0xFA00, 0xC000)
    bench.receive(answerer, WRITE, 0xFA00, 0xC000)
    assert bench.block.done


def test_a_status_word_of_zero_alone_is_no_loss(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.receive(11, READ, 0xFC90, 0)
    bench.status = 0x0000
    bench.call()
    assert bench.block.online


@pytest.mark.parametrize("retries", [0, 1, 2, 5])
def test_each_retry_sends_the_same_telegram_with_the_next_trigger(
    program: LoadedProgram, retries: int
) -> None:
    bench = failing(program, retries)
    bench.until_finished()
    assert [frame[6:] for frame in bench.sent] == [
        f"{number:02X} 0B 47 FE 03 00 00" for number in range(1, retries + 2)
    ]
    assert bench.block.status == 0x8401


def test_a_reply_to_the_second_attempt_ends_the_job(program: LoadedProgram) -> None:
    bench = failing(program, retries=2)
    while len(bench.sent) < 2:
        bench.call()
    bench.receive(11, READ, 0xFE03, 9)
    assert (bench.block.done, bench.block.replyData) == (True, 9)
    assert len(bench.sent) == 2


def test_a_lost_spacer_is_tried_again_and_counts_as_an_attempt(program: LoadedProgram) -> None:
    bench = TelegramBench(program)
    bench.send(11, READ, 0xFE03)
    bench.receive(11, READ, 0xFE03, 5)
    bench.send(11, READ, 0xFE03, timeout=TIMEOUT_MS, retries=1)
    bench.until_finished()
    assert [frame[9:] for frame in bench.sent[1:]] == ["0B 47 FC 90 00 00"] * 2
    assert bench.block.status == 0x8401


def test_error_lasts_one_call_when_execute_was_taken_back(program: LoadedProgram) -> None:
    bench = failing(program)
    bench.call(execute=False)
    bench.until_finished()
    assert bench.block.error
    bench.call()
    assert (bench.block.error, bench.block.status) == (False, 0x7000)


def test_after_an_error_the_next_edge_starts_anew(program: LoadedProgram) -> None:
    bench = failing(program)
    bench.until_finished()
    bench.send(11, READ, 0xFE03)
    assert (bench.block.busy, bench.block.error, bench.block.status) == (True, False, 0x7001)


STEP = st.fixed_dictionaries(
    {
        "execute": st.booleans(),
        "invNo": st.sampled_from([0, 11, 0x40, 0xFF]),
        "cmd": st.sampled_from([READ, WRITE, 0x53, 0x52]),
        "comNo": st.sampled_from([0xFA00, 0xFC90, 0xFD01]),
        "data": st.sampled_from([0, 0xC400]),
        "replyExpected": st.booleans(),
        "ioError": st.booleans(),
        "handshake": st.booleans(),
    }
)
REPLY = st.tuples(
    st.sampled_from([0, 11]),
    st.sampled_from([READ, WRITE, READ | 0x20]),
    st.sampled_from([0xFA00, 0xFC90, 0xFD01]),
    st.sampled_from([0, 0xC400]),
)
CYCLE = st.tuples(STEP, st.none() | REPLY, st.sampled_from([0x1F00, 0x9F00, 0x0003]))


@pytest.mark.parametrize("engine", sorted(ENGINES))
@given(cycles=st.lists(CYCLE, min_size=1, max_size=60))
@settings(max_examples=60)
def test_whatever_happens_the_rules_of_plcopen_hold(
    engine: str, cycles: list[tuple[dict[str, int], tuple[int, ...] | None, int]]
) -> None:
    """done, busy and error exclude each other; a job ends once; a trigger means a telegram."""
    bench = TelegramBench(loaded(ALL_SEQUENCES, engine), retries=1, timeout=30)
    block = bench.block
    was_busy, executed, was_online = False, False, True
    for inputs, reply, status in cycles:
        before = len(bench.sent)
        finished = block.done or block.error
        bench.status = status
        if reply is not None:
            bench.reply = (reply[0], reply[1], reply[2], reply[3])
        bench.call(**inputs)
        assert block.busy + block.done + block.error <= 1
        assert len(bench.sent) - before <= 1
        edge = bool(inputs["execute"]) and not executed
        if edge and not was_busy:
            assert block.busy or block.status in (0x8201, 0x8404)
        if not was_busy and not edge:
            assert not block.busy
            assert (block.done or block.error) <= finished
            assert len(bench.sent) - before <= (not was_online)
        if was_busy and not block.busy:
            assert block.done or block.error
        assert block.error == (block.status >= 0x8000)
        assert (block.status in (0x7001, 0x7002)) == block.busy
        if not block.busy:
            assert bench.frame()[12:] == "47 FC 90 00 00"
        assert bench.sent == [] or block.frameOut.trigger != 0
        was_busy, executed = bool(block.busy), bool(inputs["execute"])
        was_online = block.online
