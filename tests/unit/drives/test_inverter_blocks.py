"""Block transfer X and Y of the Toshiba protocol, and what is heard of unfinished frames."""

import pytest
from drive_bench import Bench

from fbgen.wire.toshiba import seal
from harness.drives import Inverter
from harness.kernel import NS_PER_MS
from tests.vectors.reading import entries

FRAMES = entries("toshiba_frames")
CHOSEN = {
    "block_write_1": 1,
    "block_write_2": 3,
    **{f"block_read_{place}": place for place in range(1, 6)},
    "maximum_frequency": 80.0,
    "acceleration_time": 0.1,
}
ALL_SERIES = pytest.mark.parametrize("series", ["vf-s11", "vf-s15", "vf-as1"])


def _bench(series: str = "vf-s11", **parameters: float) -> tuple[Bench, Inverter]:
    bench = Bench(series=series)
    return bench, bench.add(11, CHOSEN | parameters)


def _frame(name: str) -> bytes:
    return bytes.fromhex(str(FRAMES[name]["bytes"]))


@ALL_SERIES
def test_the_block_of_the_manual_runs_the_motor_and_its_reply_has_the_printed_form(
    series: str,
) -> None:
    bench, drive = _bench(series)
    bench.send(_frame("tip.block.request"))
    bench.wait(1)
    (reply,) = bench.send(_frame("tip.block.request"))
    printed = _frame("tip.block.reply")
    words = [reply[at : at + 2] for at in range(4, 14, 2)]
    assert (len(reply), reply[:4]) == (len(printed), printed[:4])
    assert words[:2] == [printed[4:6], printed[6:8]], "running forward at 60.00 Hz"
    assert words[2:] == [
        drive.read_word(comno).to_bytes(2, "big") for comno in ("FE03", "FE05", "FC91")
    ]
    assert reply == seal(reply[1:-1])


@ALL_SERIES
def test_a_block_with_a_wrong_sum_is_refused_in_the_bytes_of_the_manual(series: str) -> None:
    bench, drive = _bench(series)
    assert bench.send(_frame("tip.block.bad_sum")) == [_frame("tip.block.bad_sum.reply")]
    assert drive.read_word("FA00") == 0


@pytest.mark.parametrize(
    ("payload", "reply"),
    [
        ("0B 58 00 00", "0B 59 00 00"),  # nothing at all
        ("0B 58 01 01 C4 00", "0B 59 01 00 64 00"),  # the first word of each
        ("0B 58 00 06", "0B 59 00 00"),  # six words to read are none
        ("0B 58 03 00 C4 00 17 70 00 00", ""),  # three to write are a format error
        ("FF 58 00 01", ""),  # blocks are for one inverter
        ("0C 58 00 01", ""),  # for another one
        ("0B 58 02 00 C4 00 27 10", "0B 4E 00 01"),  # 100 Hz is more than FH
        ("58 00 05", "59 05 00 60 00 00 00 00 00 00 00 00 00"),
    ],
)
def test_blocks_in_all_their_sizes(payload: str, reply: str) -> None:
    bench, _ = _bench()
    assert bench.ask(payload) == reply


def test_a_word_for_nothing_is_dropped_and_one_of_nothing_is_0() -> None:
    bench, drive = _bench(block_write_1=0, block_read_1=0)
    assert bench.ask("0B 58 02 02 C4 00 17 70") == "0B 59 02 00 00 00 00 00"
    assert (drive.read_word("FA00"), drive.read_word("FA01")) == (0, 0x1770)


def test_a_block_that_resets_has_no_reply_and_a_tripped_inverter_answers_in_lower_case() -> None:
    bench, drive = _bench()
    drive.trip("OC1")
    assert bench.ask("0B 58 00 05").startswith("0B 79 05 00")
    assert bench.ask("0B 58 01 00 20 00") == ""
    assert not drive.tripped


def test_blocks_restart_the_time_out() -> None:
    bench, drive = _bench(communication_timeout=1)
    bench.ask("0B 58 00 01")
    bench.wait(0.9)
    assert not drive.tripped
    bench.wait(0.2)
    assert drive.tripped


@pytest.mark.parametrize(
    ("payload", "pause_ms", "heard"),
    [
        ("0B 47 FC 90 00 00", 480, True),
        ("0B 47 FC 90 00 00", 520, False),
        ("0B 58 00 01", 980, True),
        ("0B 58 00 01", 1020, False),
    ],
)
@pytest.mark.fact("tip.bin.len")
def test_an_unfinished_telegram_is_given_up_after_half_a_second_a_block_after_one(
    payload: str, pause_ms: int, heard: bool
) -> None:
    bench, _ = _bench()
    frame = seal(bytes.fromhex(payload))
    bench.port.transmit(frame[:4])
    bench.kernel.run_for(pause_ms * NS_PER_MS)
    assert bool(bench.send(frame[4:])) is heard
    assert len(bench.send(frame)) == 1, "in step again"


@pytest.mark.fact("tip.bin.start")
def test_a_start_code_behind_rubbish_is_found() -> None:
    bench, _ = _bench()
    frame = seal(bytes.fromhex("0B 47 FC 90 00 00"))
    for rubbish in (b"\x2f", b"\x2f\x2f\x2f", b"\x00\x55\xaa", b"(", b"(11R", b"/\x0b\x99"):
        assert len(bench.send(rubbish + frame)) == 1, rubbish
