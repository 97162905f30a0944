"""Several outputs by one call do what single writes do, or are left to them."""

import pytest

from harness.engine.interface import Limits
from harness.engine.loading import engine_named
from harness.kernel import NS_PER_MS, NS_PER_US
from harness.plc import Cpu

PLACES = "264:2 256:1 257:1"
VALUES = (0x0708, 0x11, 0x12)

FRAME = """
DATA_BLOCK "Out" STRUCT control : WORD; trigger : BYTE; data : WORD; END_STRUCT; BEGIN
control := W#16#A1A2; trigger := B#16#B1; data := W#16#C1C2; END_DATA_BLOCK
ORGANIZATION_BLOCK "Main"
VAR_TEMP high : BYTE; low : BYTE; END_VAR
BEGIN
%QW264:P := "Out".data;
#high := WORD_TO_BYTE(SHR(IN := "Out".control, N := 8));
#low := WORD_TO_BYTE("Out".control);
%QB256:P := #high;
%QB257:P := #low;
%QB258:P := "Out".trigger;
"Out".trigger := B#16#B2;
END_ORGANIZATION_BLOCK
"""


class Counting:
    """Counts how often the controller is asked to take several outputs and takes them."""

    def __init__(self, cpu: Cpu) -> None:
        self.cpu = cpu
        self.taken: list[bool] = []

    def __getattr__(self, name: str) -> object:
        return getattr(self.cpu, name)

    def write_several(self, places: str, values: tuple[int, ...]) -> bool:
        taken = self.cpu.write_several(places, values)
        self.taken.append(taken)
        return taken


def heard(rig):
    """Instants in milliseconds and outputs of all transfers from now on."""
    transfers: list[tuple[float, str]] = []
    rig.master.taps.append(
        lambda one: transfers.append((one.time_ns / NS_PER_MS, one.outputs.hex()))
    )
    return transfers


def test_the_station_gets_them_and_a_bus_cycle_is_asked_for(make_rig):
    rig = make_rig(process_image=False).start()
    rig.run_ms(4)
    transfers = heard(rig)
    taken: list[bool] = []
    rig.body(lambda: taken.append(rig.cpu.write_several(PLACES, VALUES)))
    rig.run_ms(15)
    assert taken == [True]
    assert [outputs for _, outputs in transfers] == ["11120000000000000708"]


def test_they_take_the_time_of_single_writes(make_rig):
    instants: list[int] = []
    for several in (True, False):
        rig = make_rig(process_image=False, peripheral_ns=300 * NS_PER_US).start()
        rig.run_ms(4)

        def body(rig=rig, several=several) -> None:
            if several:
                assert rig.cpu.write_several(PLACES, VALUES)
            else:
                rig.cpu.write_peripheral(264, 2, VALUES[0])
                rig.cpu.write_peripheral(256, 1, VALUES[1])
                rig.cpu.write_peripheral(257, 1, VALUES[2])
            instants.append(rig.cpu._instant_ns - rig.cpu.now_ns)

        rig.body(body)
        rig.run_ms(10)
    assert instants == [900 * NS_PER_US] * 2


def test_nothing_is_taken_while_the_bus_cycle_that_they_ask_for_falls_between(make_rig):
    rig = make_rig(process_image=False, peripheral_ns=800 * NS_PER_US).start()
    rig.run_ms(4)
    taken: list[bool] = []
    rig.body(lambda: taken.append(rig.cpu.write_several(PLACES, VALUES)))
    rig.run_ms(10)
    assert taken == [False]
    assert not any(rig.station.outputs)


@pytest.mark.parametrize("places", ["255:1 256:1", "264:2 266:2", "300:1 301:1", "256:2 257:1"])
def test_nothing_is_taken_where_no_station_has_each_of_them_once(make_rig, places):
    rig = make_rig(process_image=False).start()
    rig.run_ms(4)
    taken: list[bool] = []
    rig.body(lambda: taken.append(rig.cpu.write_several(places, (1, 2))))
    rig.run_ms(10)
    assert taken == [False]
    assert rig.cpu.access_errors == 0
    assert not any(rig.station.outputs)


def test_nothing_is_taken_for_the_process_image(make_rig):
    rig = make_rig(process_image=True).start()
    rig.run_ms(4)
    taken: list[bool] = []
    rig.body(lambda: taken.append(rig.cpu.write_several("256:1 257:1", (1, 2))))
    rig.run_ms(10)
    assert taken == [False]


def test_nothing_is_taken_by_a_failed_station_or_while_a_transfer_is_to_be_torn(make_rig):
    rig = make_rig(process_image=False).start()
    rig.run_ms(4)
    taken: list[bool] = []
    rig.body(lambda: taken.append(rig.cpu.write_several(PLACES, VALUES)))
    rig.cpu.link.tear_probability = 0.5
    rig.run_ms(10)
    rig.cpu.link.tear_probability = 0
    rig.station.plugged = False
    rig.run_ms(10)
    assert taken == [False, False]


@pytest.mark.parametrize("access_us", [2, 300, 500, 900])
def test_the_bus_hears_the_same_with_both_engines(make_rig, access_us):
    transfers: list[list[tuple[float, str]]] = []
    taken: list[bool] = []
    for name in ("compiled", "reference"):
        rig = make_rig(text=FRAME, process_image=False, peripheral_ns=access_us * NS_PER_US)
        counting = Counting(rig.cpu)
        engine = engine_named(name)(rig.program, counting, Limits())
        rig.start()
        rig.run_ms(4)
        transfers.append(heard(rig))
        rig.body(lambda engine=engine: engine.run_block("Main"))
        rig.run_ms(25)
        taken += counting.taken
    assert transfers[0] == transfers[1] != []
    assert transfers[0][-1][1] == "a1a2b20000000000c1c2"
    assert set(taken) == {access_us < 500}
