"""The slave's states, its watchdog, its diagnosis (EN 50170 volume 2)."""

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.fieldbus import ControlCommand, SlaveState, StationState, watchdog_factors
from harness.kernel import NS_PER_MS


@pytest.mark.fact("dp.state")
def test_a_slave_goes_from_parameters_over_configuration_to_data_exchange(make_bus):
    bus = make_bus()
    bus.slave.power_on(7)
    states = []
    bus.master.start()
    for _ in range(5):
        states.append(bus.slave.state)
        bus.run_ms(2)
    assert states == [
        SlaveState.WAIT_PRM,
        SlaveState.WAIT_PRM,
        SlaveState.WAIT_CFG,
        SlaveState.DATA_EXCHANGE,
        SlaveState.DATA_EXCHANGE,
    ]
    assert bus.device.told == ["started", "0000000000"]


@pytest.mark.fact("dp.state")
def test_a_wrong_ident_number_is_a_parameter_fault(make_bus):
    bus = make_bus(ident_number=0x4321).running()
    assert bus.slave.prm_fault
    assert bus.slave.state is SlaveState.WAIT_PRM
    assert bus.station.state is StationState.REFUSED
    assert bus.slave.slave_diag()[0] == 0x42


@pytest.mark.fact("dp.state")
def test_another_configuration_is_refused(make_bus):
    bus = make_bus(configuration=bytes.fromhex("A3 91 30 30")).running()
    assert bus.slave.cfg_fault
    assert bus.slave.state is SlaveState.WAIT_PRM
    assert bus.slave.slave_diag()[0] == 0x06


@pytest.mark.fact("dp.state")
def test_data_exchange_in_another_state_is_not_activated(make_bus):
    bus = make_bus()
    bus.slave.power_on(7)
    assert bus.slave.data_exchange(bytes(5)) is None


@pytest.mark.fact("dp.diag0")
@pytest.mark.fact("dp.diag1")
@pytest.mark.fact("dp.diag2")
def test_the_six_bytes_of_diagnosis(bus):
    assert bus.slave.slave_diag() == bytes.fromhex("00 0C 00 01 12 34")
    bus.slave.power_off()
    bus.slave.power_on(7)
    assert bus.slave.slave_diag() == bytes.fromhex("02 05 00 FF 12 34")


@pytest.mark.fact("dp.wd")
@pytest.mark.parametrize(
    ("milliseconds", "factors"),
    [(10, (1, 1)), (95, (1, 10)), (2550, (1, 255)), (650_250, (255, 255))],
)
def test_the_watchdog_time_is_10_ms_times_two_factors(milliseconds, factors):
    assert watchdog_factors(milliseconds * NS_PER_MS) == factors


@pytest.mark.parametrize("milliseconds", [0, 650_251])
def test_a_watchdog_time_that_no_factors_can_say_is_refused(milliseconds):
    with pytest.raises(DiagnosticError) as caught:
        watchdog_factors(milliseconds * NS_PER_MS)
    assert caught.value.diagnostics[0].code == "FB7202"


@pytest.mark.fact("dp.wd")
@pytest.mark.fact("dp.state")
def test_the_watchdog_expires_one_watchdog_time_after_the_last_cycle(bus):
    bus.run_ms(1)
    bus.master.stop()
    bus.run_ms(500)
    assert bus.device.events == [(120.0, "lost")]
    assert bus.slave.state is SlaveState.WAIT_PRM
    assert bus.slave.outputs == bytes(5)
    assert bus.slave.slave_diag() == bytes.fromhex("02 05 00 FF 12 34")


def test_a_gap_shorter_than_the_watchdog_time_goes_unnoticed_until_the_master_begins_anew(bus):
    bus.station.plugged = False
    bus.run_ms(1)
    bus.station.plugged = True
    bus.run_ms(500)
    assert bus.device.told == []
    assert bus.station.exchanging


@pytest.mark.fact("dp.nowd")
def test_without_watchdog_a_slave_stays_in_data_exchange_for_ever(make_bus):
    bus = make_bus(watchdog_ms=None).running()
    bus.station.write(0, b"\x01")
    bus.run_ms(10)
    bus.master.connected = False
    bus.run_ms(60_000)
    assert bus.slave.state is SlaveState.DATA_EXCHANGE
    assert bus.slave.outputs[0] == 1
    assert bus.device.told == ["0100000000"]


@pytest.mark.fact("dp.sync")
def test_sync_holds_the_outputs_until_the_next_sync_or_unsync(bus):
    bus.master.global_control(ControlCommand.SYNC)
    bus.station.write(0, b"\x01")
    bus.run_ms(4)
    assert bus.device.told == []
    bus.master.global_control(ControlCommand.SYNC)
    assert bus.device.told == ["0100000000"]
    bus.station.write(0, b"\x02")
    bus.run_ms(4)
    bus.master.global_control(ControlCommand.UNSYNC)
    bus.station.write(0, b"\x03")
    bus.run_ms(4)
    assert bus.device.told == ["0100000000", "0200000000", "0300000000"]


@pytest.mark.fact("dp.sync")
def test_freeze_holds_the_inputs_until_the_next_freeze_or_unfreeze(bus):
    bus.master.global_control(ControlCommand.FREEZE)
    bus.slave.set_inputs(b"\x01\x00\x00")
    bus.run_ms(4)
    assert bus.station.inputs == bytes(3)
    bus.master.global_control(ControlCommand.FREEZE)
    bus.slave.set_inputs(b"\x02\x00\x00")
    bus.run_ms(4)
    assert bus.station.inputs == b"\x01\x00\x00"
    bus.master.global_control(ControlCommand.UNFREEZE)
    bus.run_ms(4)
    assert bus.station.inputs == b"\x02\x00\x00"


@pytest.mark.fact("dp.sync")
def test_unsync_wins_over_sync_in_one_telegram(bus):
    bus.master.global_control(ControlCommand.SYNC | ControlCommand.UNSYNC)
    assert not bus.slave.sync


@pytest.mark.fact("dp.gc")
@pytest.mark.parametrize(("groups", "meant"), [(0x00, True), (0x06, True), (0x08, False)])
def test_global_control_reaches_all_or_the_members_of_its_groups(make_bus, groups, meant):
    bus = make_bus(group=0x02).running()
    bus.master.global_control(ControlCommand.SYNC, groups)
    assert bus.slave.sync is meant


@pytest.mark.fact("dp.gc")
def test_clear_data_clears_the_outputs_even_in_sync(bus):
    bus.station.write(0, b"\x01")
    bus.run_ms(4)
    bus.master.global_control(ControlCommand.SYNC)
    bus.master.global_control(ControlCommand.CLEAR_DATA)
    assert bus.slave.outputs == bytes(5)
