"""Every request with its reply that the manuals print, answered by inverters byte by byte."""

from collections.abc import Mapping
from dataclasses import field

import pytest
from drive_bench import FIXED_REPLY, Bench

from fbgen.dataclass import dataclass
from fbgen.wire import modbus
from harness.drives import InverterSettings, Load, Motor, set_for_line
from tests.vectors.reading import entries

FRAMES = {
    name: entry for name, entry in entries("toshiba_frames").items() if entry["kind"] == "frame"
}
PAIRS = [(str(entry["reply_to"]), name) for name, entry in FRAMES.items() if "reply_to" in entry]

_TO_60_HZ = 60.0 / 0.9469
"""Base frequency at which 60 Hz are 94.69 % of the voltage."""


@dataclass(frozen=True, slots=True)
class Prepared:
    """The inverter that a frame was printed for: what is asked before the frame, and how long ago.

    `before` are payloads in the protocol that `parameters` choose.
    """

    inv_no: int = 11
    parameters: Mapping[str, float] = field(default_factory=dict)
    before: tuple[bytes, ...] = ()
    load: Load = field(default_factory=Load)
    motor: Motor = field(default_factory=Motor)
    trip: str = ""
    series: tuple[str, ...] = ("vf-s11", "vf-as1", "vf-s15")


_MODBUS = {"protocol_selection": 1.0, "acceleration_time": 0.1}
_BLOCK = {"block_write_1": 1.0, "block_write_2": 3.0}
_READ = {f"block_read_{place}": float(place) for place in range(1, 6)}
_RUN_11 = (bytes.fromhex("2F 0B 50 FA 00 C4 00 48"), bytes.fromhex("2F 0B 50 FA 01 13 88 20"))
_QUICK = {"acceleration_time": 0.1}
_S15 = ("vf-s15", "vf-mb1")
_RUN_60 = tuple(map(modbus.seal, map(bytes.fromhex, ("01 06 FA 00 C4 00", "01 06 FA 01 17 70"))))

PREPARED: Mapping[str, Prepared] = {
    "rs485.g.row1.request": Prepared(),
    "rs485.g.row2.request": Prepared(),
    "rs485.g.row3.request": Prepared(parameters=_QUICK, before=_RUN_11, load=Load(32.7)),
    "rs485.g.row4.request": Prepared(before=_RUN_11[:1]),
    "tip.block.request": Prepared(
        parameters=_QUICK | _BLOCK | _READ,
        before=(bytes.fromhex("2F 58 02 05 C4 00 17 70 D9"),),
        load=Load(63.9),
        motor=Motor(base_frequency_hz=_TO_60_HZ),
    ),
    "tip.block.bad_sum": Prepared(parameters=_BLOCK),
    "tip.trip.request": Prepared(trip="Err5"),
    "tip.ascii.read_current": Prepared(
        parameters=_QUICK, before=_RUN_11, motor=Motor(no_load_current_percent=19.15)
    ),
    "modbus.read": Prepared(1, _MODBUS, _RUN_60, series=("vf-s11", *_S15)),
    "modbus.read_two": Prepared(1, _MODBUS, series=("vf-s11", *_S15)),
    "modbus.write_multiple": Prepared(1, _MODBUS, series=_S15),
    "modbus.block": Prepared(1, _MODBUS | _BLOCK, series=_S15),
    "modbus.block.bad_address": Prepared(1, _MODBUS | _BLOCK, series=_S15),
    "modbus.block.bad_count": Prepared(1, _MODBUS | _BLOCK, series=_S15),
    "modbus.identify": Prepared(1, _MODBUS, series=_S15),
}
REFUSED_BLOCK = "modbus.block.refused"
"""The other reply to a block: of an inverter whose F870 and F871 are 0."""


def _bytes(name: str) -> bytes:
    entry = FRAMES[name]
    if "text" in entry:
        return str(entry["text"]).encode("ascii")
    return bytes.fromhex(str(entry["bytes"]).replace("xx xx xx", "00 00 82"))


def _replies(name: str, series: str, prepared: Prepared) -> list[bytes]:
    bench = Bench(series=series)
    parameters = set_for_line(bench.series, None, 19_200, "even") | {
        "inverter_number": prepared.inv_no
    }
    wanted = {**parameters, **prepared.parameters}
    drive = bench.add(
        settings=InverterSettings(
            parameters=wanted, load=prepared.load, motor=prepared.motor, reply_time=FIXED_REPLY
        )
    )
    for frame in prepared.before:
        assert bench.send(frame), "the frames before are answered"
    bench.wait(2)
    if prepared.trip:
        drive.trip(prepared.trip)
    return bench.send(_bytes(name))


@pytest.mark.parametrize(("request_name", "reply_name"), PAIRS)
@pytest.mark.fact("tip.cmd")
def test_inverter_answers_with_the_bytes_that_are_printed(
    request_name: str, reply_name: str
) -> None:
    prepared = PREPARED[request_name]
    if reply_name == REFUSED_BLOCK:
        prepared = Prepared(1, _MODBUS, series=_S15)
    for series in prepared.series:
        assert _replies(request_name, series, prepared) == [_bytes(reply_name)], series


def test_every_printed_reply_has_been_played() -> None:
    assert {request for request, _ in PAIRS} == set(PREPARED)


@pytest.mark.parametrize(
    ("name", "request_", "trip", "lock"),
    [
        ("tip.error.inv.0001", "0B 50 00 11 FF FF", "", False),
        ("tip.error.inv.tripped.0002", "0B 47 12 34 00 00", "OC1", False),
        ("tip.error.frame.0000", "57 00 09 00 32", "", True),
    ],
)
@pytest.mark.fact("tip.err.0000")
@pytest.mark.fact("tip.err.ex")
def test_refusals_that_are_printed_without_their_request(
    name: str, request_: str, trip: str, lock: bool
) -> None:
    bench = Bench()
    drive = bench.add(11)
    drive.registers.locked = lock
    if trip:
        drive.trip(trip)
    assert f"2F {bench.ask(request_)}" == str(FRAMES[name]["bytes"])[:-3]


@pytest.mark.parametrize(
    ("name", "comno", "word"),
    [
        ("tip.ascii.write", "0010", 0x0064),
        ("tip.ascii.broadcast", "FA01", 0x1770),
        ("tip.ascii.forward", "FA00", 0x8400),
        ("tip.ascii.reverse", "FA00", 0x8600),
        ("tip.ascii.reverse_with_frequency", "FA00", 0xC600),
    ],
)
@pytest.mark.parametrize("series", ["vf-s11", "vf-as1", "vf-s15", "vf-s9"])
def test_ascii_writes_that_are_printed_are_taken_and_repeated(
    series: str, name: str, comno: str, word: int
) -> None:
    bench = Bench(series=series)
    drive = bench.add(0)
    assert bench.send(_bytes(name)) == [_bytes(name)]
    assert drive.read_word(comno) == word


@pytest.mark.parametrize("series", ["vf-s11", "vf-as1", "vf-s15"])
def test_ascii_reads_that_are_printed_without_their_reply(series: str) -> None:
    bench = Bench(series=series)
    drive = bench.add(11)
    assert bench.send(_bytes("tip.ascii.read_sum")) == [b"(N0002&5E)\r"], "no ComNo 0000 here"
    drive.trip("Err5")
    assert bench.send(_bytes("tip.ascii.read_trip")) == [b"(rFC900018)\r"]


def test_group_read_of_the_manual_is_answered_with_the_own_number() -> None:
    """VF-S11 manual E6581222, 4.1: `(*2R0000)` gives `(02R0000....)`; here it is ComNo 0003."""
    bench = Bench()
    parameters = set_for_line(bench.series, None, 19_200, "even")
    allowed = frozenset({"broadcast_reads"})
    for number in (2, 12, 3):
        settings = InverterSettings(
            parameters=parameters | {"inverter_number": number}, options=allowed
        )
        bench.add(settings=settings)
    assert bench.send(b"(*2R0003)\r") == [b"(02R00030001)\r"]
    assert bench.send(b"(1*R0003)\r") == []
