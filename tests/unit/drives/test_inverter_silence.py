"""Telegrams that end by silence: Toshiba's of the VF-S15, and MODBUS, on the virtual clock."""

import pytest
from drive_bench import Bench

from fbgen.wire import modbus
from fbgen.wire.toshiba import seal
from harness.kernel import NS_PER_MS
from harness.line import Disturbance, Topology

CHARACTER_NS = 11 * 1_000_000_000 // 19_200
READ = seal(bytes.fromhex("01 47 FC 90 00 00"))
READ_MODBUS = modbus.seal(bytes.fromhex("01 03 FC 90 00 01"))
MODBUS = {"protocol_selection": 1.0}


def _parts(bench: Bench, first: bytes, gap_characters: float, second: bytes) -> list[bytes]:
    """What comes back when two runs of bytes are sent with a silence between them."""
    bench.heard.clear()
    sent = bench.port.transmit(first)
    bench.kernel.run_until(sent.end_ns + round(gap_characters * CHARACTER_NS))
    bench.port.transmit(second)
    bench.kernel.run_for(60 * NS_PER_MS)
    return [reception.data for reception in bench.heard]


@pytest.mark.fact("tip.mode")
def test_vf_s15_answers_toshiba_telegrams_in_both_forms() -> None:
    bench = Bench(series="vf-s15")
    bench.add(1)
    assert bench.ask("01 47 FC 90 00 00") == "01 47 FC 90 00 00"
    assert bench.send(b"(01RFC90)\r") == [b"(01RFC900000)\r"]
    assert bench.ask("02 47 FC 90 00 00") == ""


def test_reply_time_counts_from_the_last_byte_and_not_from_the_silence() -> None:
    bench = Bench(series="vf-s15")
    bench.add(1)
    asked_ns = bench.kernel.now_ns
    bench.ask("01 47 FC 90 00 00")
    assert bench.heard[0].start_ns - asked_ns == 8 * CHARACTER_NS + 10 * NS_PER_MS


@pytest.mark.parametrize(
    ("parameters", "frame"), [({}, READ), (MODBUS, READ_MODBUS)], ids=["toshiba", "modbus"]
)
def test_two_telegrams_without_silence_between_are_none(
    parameters: dict[str, float], frame: bytes
) -> None:
    bench = Bench(series="vf-s15")
    bench.add(1, parameters)
    assert _parts(bench, frame, 0, frame) == []
    assert _parts(bench, frame, 3.4, frame) == []
    assert len(_parts(bench, frame, 3.6, frame)) == 1, "the second one falls into the reply time"
    assert len(bench.send(frame)) == 1


@pytest.mark.parametrize(
    ("parameters", "frame", "characters", "answered"),
    [
        ({}, READ, 3.4, True),
        ({}, READ, 3.6, False),
        (MODBUS, READ_MODBUS, 1.4, True),
        (MODBUS, READ_MODBUS, 1.6, False),
        (MODBUS, READ_MODBUS, 3.6, False),
    ],
)
@pytest.mark.fact("tip.gap")
def test_silence_inside_of_a_telegram(
    parameters: dict[str, float], frame: bytes, characters: float, answered: bool
) -> None:
    """Toshiba's manuals know none but the 3.5 characters; MODBUS spoils a frame after 1.5."""
    bench = Bench(series="vf-s15")
    bench.add(1, parameters)
    assert bool(_parts(bench, frame[:4], characters, frame[4:])) is answered
    assert len(bench.send(frame)) == 1, "the next telegram is understood"


def test_lost_bytes_leave_a_silence_and_spoil_a_modbus_frame() -> None:
    bench = Bench(series="vf-s15")
    bench.add(1, MODBUS)
    lost = Disturbance(lose=frozenset((3, 4, 5)))
    bench.line.master_pair.interference.disturb_next(lost)
    assert bench.send(READ_MODBUS) == []
    assert len(bench.send(READ_MODBUS)) == 1


def test_after_power_on_the_telegram_that_is_on_its_way_is_not_understood() -> None:
    bench = Bench(series="vf-s15")
    drive = bench.add(1)
    drive.power_off()
    drive.power_on()
    silent_ns = drive.series.times.boot.ns
    bench.kernel.run_for(silent_ns - CHARACTER_NS)
    assert bench.send(READ) == []
    assert len(bench.send(READ)) == 1


def test_replies_of_others_on_two_wires_are_not_taken_for_requests() -> None:
    bench = Bench(series="vf-s15", topology=Topology.TWO_WIRE)
    first, second = bench.add(1), bench.add(2)
    assert bench.ask("01 50 00 09 00 32") == "01 50 00 09 00 32"
    assert (first.read_word("0009"), second.read_word("0009")) == (0x32, 100)


@pytest.mark.parametrize(("gap_characters", "answers"), [(0, 1), (3.4, 1), (3.6, 2)])
def test_behind_a_telegram_that_was_not_heard_there_must_be_silence_too(
    gap_characters: float, answers: int
) -> None:
    bench = Bench(series="vf-s15")
    bench.add(1)
    reply = 8 * 12 * 1_000_000_000 // 19_200
    sent = bench.port.transmit(READ)
    # one while the inverter replies, which it does not hear; the next begins when it is free again
    bench.kernel.run_until(sent.end_ns + 10 * NS_PER_MS + reply // 2)
    unheard = bench.port.transmit(READ)
    bench.kernel.run_until(unheard.end_ns + round(gap_characters * CHARACTER_NS))
    bench.port.transmit(READ)
    bench.kernel.run_for(60 * NS_PER_MS)
    assert len(bench.heard) == answers
