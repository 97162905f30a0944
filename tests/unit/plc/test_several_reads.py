"""Several inputs by one access give what single accesses give, or are left to them."""

import pytest

from harness.engine.interface import Limits
from harness.engine.loading import engine_named
from harness.kernel import NS_PER_MS, NS_PER_US
from harness.plc import Cpu

INPUTS = bytes.fromhex("01 02 03 04 05 06 07 08")
PLACES = "256:1 257:1 258:2 260:4"

FRAME = """
TYPE "typeFrame" STRUCT status : WORD; number : BYTE; cmd : BYTE; data : DWORD; END_STRUCT; END_TYPE
DATA_BLOCK "Seen" "typeFrame" BEGIN END_DATA_BLOCK
ORGANIZATION_BLOCK "Main"
VAR_TEMP high : BYTE; low : BYTE; END_VAR
BEGIN
#high := %IB256:P;
#low := %IB257:P;
"Seen".status := SHL(IN := BYTE_TO_WORD(#high), N := 8) OR BYTE_TO_WORD(#low);
"Seen".number := %IB258:P;
"Seen".cmd := %IB259:P;
"Seen".data := %ID260:P;
END_ORGANIZATION_BLOCK
"""


class Counting:
    """Counts how often the controller is asked for several inputs and gives them."""

    def __init__(self, cpu: Cpu) -> None:
        self.cpu = cpu
        self.given: list[bool] = []

    def __getattr__(self, name: str) -> object:
        return getattr(self.cpu, name)

    def read_several(self, places: str) -> tuple[int, ...] | None:
        values = self.cpu.read_several(places)
        self.given.append(values is not None)
        return values


def started(make_rig, **settings):
    rig = make_rig(process_image=False, **settings).start()
    rig.slave.set_inputs(INPUTS)
    rig.run_ms(4)
    return rig


def test_the_values_are_those_of_single_reads(make_rig):
    rig = started(make_rig)
    seen: list[object] = []
    rig.body(lambda: seen.append(rig.cpu.read_several(PLACES)))
    rig.run_ms(10)
    assert seen == [(0x01, 0x02, 0x0304, 0x05060708)]


def test_they_come_in_the_order_of_the_reads_and_may_leave_bytes_out(make_rig):
    rig = started(make_rig)
    seen: list[object] = []
    rig.body(lambda: seen.append(rig.cpu.read_several("262:2 256:1 259:1")))
    rig.run_ms(10)
    assert seen == [(0x0708, 0x01, 0x04)]


def test_they_take_the_time_of_single_reads(make_rig):
    rig = started(make_rig, peripheral_ns=300 * NS_PER_US)
    seen: list[object] = []

    def body() -> None:
        assert rig.cpu.read_several("256:1 257:1 258:1") is not None
        seen.append(rig.cpu.read_peripheral(256, 1))  # 1.2 ms after the start of the scan
        rig.cpu.read_peripheral(256, 1)
        rig.cpu.read_peripheral(256, 1)
        seen.append(rig.cpu.read_peripheral(256, 1))  # 2.1 ms

    rig.kernel.at(31 * NS_PER_MS, lambda: rig.slave.set_inputs(b"\x09" + bytes(7)))
    rig.body(body)
    rig.run_ms(13)
    assert seen == [0x01, 0x09]  # the cycle at 32 ms brings what the slave had at 31 ms


def test_nothing_is_given_while_a_bus_cycle_falls_between_the_reads(make_rig):
    rig = started(make_rig, peripheral_ns=800 * NS_PER_US)
    seen: list[object] = []
    rig.kernel.at(31 * NS_PER_MS, lambda: rig.slave.set_inputs(b"\x09" + bytes(7)))
    rig.body(lambda: seen.append(rig.cpu.read_several(PLACES)))
    rig.run_ms(10)
    assert seen == [None]


@pytest.mark.parametrize("places", ["255:1 256:1", "262:2 264:2", "300:1 301:1", "256:2 257:1"])
def test_nothing_is_given_where_no_station_has_each_of_them_once(make_rig, places):
    rig = started(make_rig)
    seen: list[object] = []
    rig.body(lambda: seen.append(rig.cpu.read_several(places)))
    rig.run_ms(10)
    assert seen == [None]
    assert rig.cpu.access_errors == 0


def test_nothing_is_given_by_a_failed_station_or_while_a_transfer_is_to_be_torn(make_rig):
    rig = started(make_rig)
    seen: list[object] = []
    rig.body(lambda: seen.append(rig.cpu.read_several(PLACES)))
    rig.cpu.link.tear_next_read(rig.station, 1)
    rig.run_ms(10)
    rig.cpu.link.tear_probability = 0
    rig.station.plugged = False
    rig.run_ms(10)
    assert seen == [None, None]


@pytest.mark.parametrize(("access_us", "in_one_go"), [(2, True), (400, False)])
def test_a_program_sees_the_same_with_both_engines(make_rig, access_us, in_one_go):
    values: list[object] = []
    asked: list[bool] = []
    for name in ("compiled", "reference"):
        rig = make_rig(text=FRAME, process_image=False, peripheral_ns=access_us * NS_PER_US)
        counting = Counting(rig.cpu)
        engine = engine_named(name)(rig.program, counting, Limits())
        rig.start()
        rig.slave.set_inputs(INPUTS)
        rig.run_ms(4)
        # from 32 ms on the inputs are other ones: between the reads, if these take long enough
        rig.kernel.at(31 * NS_PER_MS, lambda rig=rig: rig.slave.set_inputs(bytes(reversed(INPUTS))))
        rig.body(lambda engine=engine: engine.run_block("Main"))
        rig.run_ms(10)
        members = ("status", "number", "cmd", "data")
        values.append([engine.global_value(f"Seen.{member}") for member in members])
        asked += counting.given
    assert values[0] == values[1]
    assert asked == [in_one_go]
    expected = [0x0102, 3, 4, 0x05060708] if in_one_go else [0x0102, 3, 4, 0x04030201]
    assert values[0] == expected
