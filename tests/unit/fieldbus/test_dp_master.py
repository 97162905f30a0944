"""The master's cycle: its grid, CLEAR, failing and returning stations."""

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.fieldbus import (
    CycleGrid,
    CycleTimes,
    DpSlave,
    MasterMode,
    Parameters,
    SlaveType,
    StationSettings,
    StationState,
)
from harness.kernel import NS_PER_MS, NS_PER_US


def test_outputs_leave_at_the_next_instant_of_the_grid(bus):
    bus.run_ms(0.7)
    bus.station.write(1, b"\xab")
    bus.run_ms(5)
    assert bus.device.events == [(22.0, "00ab000000")]


def test_outputs_written_at_an_instant_of_the_grid_leave_with_the_next_one(bus):
    bus.station.write(1, b"\xab")
    bus.run_ms(5)
    assert bus.device.events == [(22.0, "00ab000000")]


def test_inputs_arrive_at_the_next_instant_of_the_grid(bus):
    bus.run_ms(0.7)
    bus.slave.set_inputs(b"\x01\x02\x03")
    bus.run_ms(1.2)
    assert bus.station.inputs == bytes(3)
    bus.run_ms(0.2)
    assert bus.station.inputs == b"\x01\x02\x03"


def test_two_writes_in_one_cycle_are_one_transfer(bus):
    bus.station.write(0, b"\x01")
    bus.station.write(1, b"\x02")
    bus.run_ms(10)
    assert bus.device.told == ["0102000000"]


def test_a_bus_on_which_nothing_changes_costs_nothing(bus):
    assert bus.kernel.next_event_ns() is None
    bus.run_ms(60_000)
    assert bus.transfers == []


def test_a_change_and_back_within_a_cycle_reaches_nobody(bus):
    bus.station.write(0, b"\x01")
    bus.station.write(0, b"\x00")
    bus.run_ms(10)
    assert bus.device.told == []


def test_period_and_phase_are_settings(make_bus):
    bus = make_bus(CycleTimes(5 * NS_PER_MS, 300 * NS_PER_US)).running()
    bus.run_ms(20)
    bus.station.write(0, b"\x01")
    bus.run_ms(10)
    assert bus.device.events[-1] == (40.3, "0100000000")


def test_jitter_delays_by_less_than_its_limit_and_is_the_same_whenever_somebody_asks(make_bus):
    times = CycleTimes(2 * NS_PER_MS, 0, NS_PER_MS)
    grid = CycleGrid(times, make_bus(seed=3).kernel.random)
    instants, at_ns = [], 0
    for _ in range(200):
        at_ns = grid.after(at_ns)
        instants.append(at_ns)
    delays = [instant % times.period_ns for instant in instants]
    assert all(0 <= delay <= times.jitter_ns for delay in delays)
    assert len(set(delays)) > 100
    assert all(grid.up_to(instant) == instant for instant in instants)
    assert all(grid.after(instant - 1) == instant for instant in instants)
    assert all(grid.up_to(instant - 1) < instant for instant in instants)


@pytest.mark.parametrize("times", [(0, 0, 0), (2_000_000, 0, 2_000_000), (2_000_000, 0, -1)])
def test_impossible_cycles_are_refused(times):
    with pytest.raises(DiagnosticError) as caught:
        CycleTimes(*times)
    assert caught.value.diagnostics[0].code == "FB7201"


@pytest.mark.fact("dp.clear")
def test_clear_sends_zeros_and_the_slave_stays_in_data_exchange(bus):
    bus.station.write(0, b"\x01\x02")
    bus.run_ms(4)
    bus.master.clear()
    bus.run_ms(1_000)
    assert bus.master.mode is MasterMode.CLEAR
    assert bus.device.told == ["0102000000", "0000000000"]
    assert bus.slave.online
    bus.master.operate()
    bus.run_ms(4)
    assert bus.device.told[-1] == "0102000000"


def test_a_station_that_does_not_answer_has_failed_and_its_inputs_are_0(bus):
    reported: list[StationState] = []
    bus.master.observers.append(lambda station: reported.append(station.state))
    bus.slave.set_inputs(b"\x01\x02\x03")
    bus.run_ms(4)
    bus.slave.power_off()
    bus.run_ms(4)
    assert bus.station.failed
    assert bus.station.inputs == bytes(3)
    bus.slave.power_on(7)
    bus.run_ms(20)
    assert bus.station.inputs == b"\x01\x02\x03"
    assert reported == [StationState.FAILED, StationState.EXCHANGE]


def test_a_slave_at_another_address_is_not_found(bus):
    bus.slave.power_off()
    bus.slave.power_on(8)
    bus.run_ms(20)
    assert bus.station.failed


def test_after_a_stop_the_master_begins_with_parameters_again(bus):
    bus.master.stop()
    bus.run_ms(1_000)
    bus.master.start()
    bus.run_ms(20)
    assert bus.device.told == ["lost", "started", "0000000000"]


def test_what_the_cpu_wrote_while_the_station_was_away_goes_out_when_it_is_back(bus):
    bus.master.connected = False
    bus.run_ms(500)
    bus.station.write(0, b"\x55")
    bus.master.connected = True
    bus.run_ms(20)
    assert bus.device.told == ["lost", "started", "5500000000"]


def test_two_stations_cannot_have_one_address(bus):
    other = DpSlave(bus.kernel, bus.device, SlaveType(1, b"\x30"), 7, (1, 1))
    with pytest.raises(DiagnosticError) as caught:
        bus.master.add(StationSettings("x", 7, b"\x30", Parameters(1, None)), other)
    assert caught.value.diagnostics[0].code == "FB7204"


def test_a_configuration_that_cannot_be_read_is_refused(bus):
    other = DpSlave(bus.kernel, bus.device, SlaveType(1, b"\xc0"), 8, (1, 1))
    with pytest.raises(DiagnosticError) as caught:
        bus.master.add(StationSettings("x", 8, b"\xc0\x00", Parameters(1, None)), other)
    assert caught.value.diagnostics[0].code == "FB7203"
