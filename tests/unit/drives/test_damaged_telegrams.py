"""Every bit flip and every truncation of every kind of frame, sent to an inverter.

Nothing may make it fail, and no value may be taken that was not sent, unless the check sum of the
damaged frame is right by chance: then the codec takes the frame, too, and no inverter can know.
"""

from collections.abc import Iterator
from itertools import combinations

import pytest
from drive_bench import Bench

from fbgen.wire import modbus, modbus_rtu, toshiba_block
from fbgen.wire.toshiba import BadRequest
from harness.drives import Inverter
from harness.kernel import NS_PER_MS
from tests.frames import ASCII_CHECKED, MODBUS, TOSHIBA_BINARY

BLOCK = {"block_write_1": 1.0, "block_write_2": 3.0, "block_read_1": 1.0}
LONGEST_WAIT_NS = 1_200 * NS_PER_MS
"""Longer than any frame may take, any reply, and the time-out of a block."""

REQUESTS = {
    "toshiba": [frame for name, frame in TOSHIBA_BINARY.items() if "repl" not in name],
    "ascii": list(ASCII_CHECKED.values()),
    "modbus": list(MODBUS.values()),
}


def _bench(series: str, kind: str, inv_no: int) -> tuple[Bench, Inverter]:
    parameters = BLOCK | ({"protocol_selection": 1.0} if kind == "modbus" else {})
    bench = Bench(series=series)
    return bench, bench.add(inv_no, parameters)


def _flips(frame: bytes) -> Iterator[bytes]:
    for bit in range(8 * len(frame)):
        damaged = bytearray(frame)
        damaged[bit >> 3] ^= 1 << (bit & 7)
        yield bytes(damaged)


def _send(bench: Bench, frame: bytes) -> None:
    bench.port.transmit(frame)
    bench.kernel.run_for(LONGEST_WAIT_NS)


@pytest.mark.parametrize("kind", list(REQUESTS))
@pytest.mark.parametrize("series", ["vf-s11", "vf-s15"])
def test_no_single_flip_and_no_truncation_makes_an_inverter_take_a_wrong_value(
    series: str, kind: str
) -> None:
    inv_no = 1 if kind == "modbus" else 11
    bench, drive = _bench(series, kind, inv_no)
    before = dict(drive.registers.ram)
    tried = 0
    for frame in REQUESTS[kind]:
        truncated = (frame[:size] for size in range(len(frame)))
        for damaged in (*_flips(frame), *truncated):
            _send(bench, damaged)
            tried += 1
            assert drive.registers.ram == before, damaged.hex(" ")
    assert tried > 500
    probe = modbus.seal(b"\x01\x03\xfc\x90\x00\x01") if kind == "modbus" else b"(11RFC90)\r"
    assert len(bench.send(probe)) == 1, "it still answers"


def _double_flips(frame: bytes) -> Iterator[bytes]:
    for first, second in combinations(range(8 * len(frame)), 2):
        damaged = bytearray(frame)
        damaged[first >> 3] ^= 1 << (first & 7)
        damaged[second >> 3] ^= 1 << (second & 7)
        yield bytes(damaged)


def test_of_all_double_flips_those_are_taken_whose_sum_collides_and_no_others() -> None:
    """P without parity: 65 of 2016 pass the sum, as docs/reference/protocols.md says."""
    bench, drive = _bench("vf-s11", "toshiba", 11)
    frame = TOSHIBA_BINARY["rs485.g.row1.request"]
    before = dict(drive.registers.ram)
    collided = taken = 0
    for damaged in _double_flips(frame):
        message = toshiba_block.parse_request(damaged)
        collides = message is not None and not isinstance(message, BadRequest)
        collided += collides
        _send(bench, damaged)
        if not collides:
            assert drive.registers.ram == before, damaged.hex(" ")
        elif drive.registers.ram != before:
            taken += 1
            drive.power_off()
            drive.power_on()
            bench.wait(1)
    assert (collided, taken) == (65, 15), "the others change nothing: number, ComNo or command"


def test_of_all_double_flips_of_a_modbus_frame_none_is_taken() -> None:
    bench, drive = _bench("vf-s15", "modbus", 1)
    frame = MODBUS["write"]
    before = dict(drive.registers.ram)
    for damaged in _double_flips(frame):
        assert modbus_rtu.parse_request(damaged) is None
        _send(bench, damaged)
    assert drive.registers.ram == before


@pytest.mark.parametrize("kind", ["toshiba", "modbus"])
def test_two_inverters_that_answer_at_once_are_not_understood_and_go_on(kind: str) -> None:
    bench, first = _bench("vf-s15", kind, 1)
    second = bench.add(1, {"protocol_selection": 1.0} if kind == "modbus" else {})
    read = "01 03 FC 90 00 01" if kind == "modbus" else "01 47 FC 90 00 00"
    ask = bench.ask_modbus if kind == "modbus" else bench.ask
    frame = modbus.seal(bytes.fromhex(read))
    if kind == "toshiba":
        frame = b"(01RFC90)\r"
    assert len(bench.send(frame)) == 2
    assert all(heard.marks is not None for heard in bench.heard)
    second.power_off()
    assert ask(read) != ""
    assert not first.tripped
