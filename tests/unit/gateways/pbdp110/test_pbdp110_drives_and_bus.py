"""Searching, online and offline, supply, global control, watchdog, diagnosis, switches, lamps."""

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.fieldbus import ControlCommand
from harness.kernel import NS_PER_MS


@pytest.mark.fact("pb.autoscan")
@pytest.mark.parametrize("baud", [1200, 2400, 4800, 9600, 19200])
@pytest.mark.parametrize("parity", ["even", "odd", "none"])
def test_a_drive_is_found_whatever_its_speed_and_parity(bench, baud, parity):
    bench.drive("a", baud, parity)
    bench.start(run_ms=8000)
    assert bench.online("a")
    assert not bench.online("b")


@pytest.mark.fact("pb.online")
def test_while_a_drive_is_offline_its_online_bit_and_all_its_inputs_are_0(bench):
    drive = bench.drive("a")
    bench.start()
    bench.send(500, a_command=0xC400, a_frequency=3000, b_command=0xC400, b_number=0x1234)
    assert bench.online("a")
    assert bench.inputs[24:] == bytes(24)
    drive.communication.port.receive_open = True
    bench.run_ms(1500)
    assert bench.inputs == bytes(48)


@pytest.mark.fact("pb.online")
def test_a_drive_that_comes_back_is_online_again_and_follows_the_command(bench):
    drive = bench.drive("a")
    bench.start()
    bench.send(500, a_command=0xC400, a_frequency=3000)
    drive.power_off()
    bench.run_ms(1500)
    assert not bench.online("a")
    drive.power_on()
    bench.run_ms(3500)
    assert bench.online("a")
    assert drive.running


@pytest.mark.fact("pb.power")
def test_the_interface_lives_on_the_supply_of_drive_a(bench):
    bench.drive("a")
    bench.drive("b")
    bench.start()
    bench.device.supply("b", True)
    assert bench.device.powered
    bench.device.supply("a", False)
    bench.run_ms(10)
    assert not bench.slave.powered
    assert bench.inputs == bytes(48)
    telegrams = bench.device.telegrams
    bench.run_ms(500)
    assert bench.device.telegrams == telegrams
    bench.start()
    assert bench.online("a")


@pytest.mark.fact("pb.global")
def test_sync_holds_the_outputs_until_the_next_sync_or_unsync(bench):
    drive = bench.drive("a")
    bench.start()
    bench.slave.global_control(ControlCommand.SYNC, 0)
    bench.send(500, a_command=0xC400, a_frequency=3000)
    assert not drive.running
    bench.slave.global_control(ControlCommand.SYNC, 0)
    bench.run_ms(500)
    assert drive.running
    bench.send(500, a_command=0xC000)
    assert drive.running
    bench.slave.global_control(ControlCommand.UNSYNC, 0)
    bench.run_ms(500)
    assert not drive.running


@pytest.mark.fact("pb.global")
def test_freeze_holds_the_inputs_until_the_next_freeze_or_unfreeze(bench):
    drive = bench.script("a")
    drive.cells = {0xFD00: 1000}
    bench.start()
    bench.slave.global_control(ControlCommand.FREEZE, 0)
    drive.cells[0xFD00] = 2000
    bench.run_ms(400)
    assert bench.word("a_frequency") == 1000
    bench.slave.global_control(ControlCommand.FREEZE, 0)
    bench.run_ms(0)
    assert bench.word("a_frequency") == 2000
    drive.cells[0xFD00] = 3000
    bench.run_ms(400)
    bench.slave.global_control(ControlCommand.UNFREEZE, 0)
    bench.run_ms(0)
    assert bench.word("a_frequency") == 3000


@pytest.mark.fact("pb.global")
def test_clear_data_sets_all_outputs_to_0_so_the_drive_is_left_to_itself(bench):
    drive = bench.drive("a")
    bench.start()
    bench.send(500, a_command=0xC400, a_frequency=3000)
    bench.slave.global_control(ControlCommand.CLEAR_DATA, 0)
    bench.run_ms(500)
    assert not drive.network_command
    assert not drive.running


@pytest.mark.fact("pb.wd")
@pytest.mark.parametrize(
    ("watchdog", "bus_lost", "commanded"),
    [((1, 10), "local", False), ((1, 10), "hold", True), (None, "local", True)],
)
def test_with_a_watchdog_the_drives_are_given_back_when_the_master_is_lost(
    make_bench, watchdog, bus_lost, commanded
):
    bench = make_bench(2, {"bus_lost": bus_lost})
    drive = bench.drive("a")
    bench.start(watchdog)
    bench.send(500, a_command=0xC400, a_frequency=3000)
    bench.slave.polling_ended(bench.kernel.now_ns)
    bench.run_ms(1000)
    assert drive.network_command is commanded
    assert drive.running is commanded
    assert bench.slave.online is (watchdog is None)


@pytest.mark.fact("pb.diag")
@pytest.mark.parametrize(("channel", "byte"), [("a", 0x01), ("b", 0x10)])
def test_a_trip_is_told_in_the_diagnosis_byte_and_so_is_its_end(bench, channel, byte):
    """Which bits these are is from other copies of the manual than the one at hand."""
    drives = {name: bench.drive(name) for name in "ab"}
    bench.start()
    assert not bench.slave.ext_diag
    drives[channel].trip("OC1")
    bench.run_ms(300)
    assert bench.slave.ext_diag
    assert bench.slave.slave_diag()[6:] == bytes((2, byte))
    bench.slave.diagnosis_fetched()
    drives[channel].reset()
    bench.run_ms(6000)
    assert not bench.slave.ext_diag
    assert bench.slave.diagnosis_waiting, "the end of the trip is an update of its own"
    assert bench.slave.slave_diag()[6:] == bytes((2, 0))


@pytest.mark.fact("pb.diag")
def test_two_trips_stand_in_one_byte(bench):
    drives = [bench.drive(name) for name in "ab"]
    bench.start()
    for drive in drives:
        drive.trip("OC1")
    bench.run_ms(300)
    assert bench.slave.slave_diag()[6:] == b"\x02\x11"


@pytest.mark.fact("pb.layouts")
@pytest.mark.parametrize("module", [1, 2, 3, 4])
def test_the_master_chooses_the_module(make_bench, module):
    bench = make_bench(module)
    bench.drive("a")
    bench.start()
    assert len(bench.inputs) == bench.layout.input_length
    assert bench.online("a")


@pytest.mark.fact("pb.addr")
def test_the_switches_are_read_at_power_on_only(bench):
    bench.start()
    bench.device.set_switches(77)
    assert bench.slave.address == 5
    bench.device.supply("a", False)
    bench.device.supply("a", True)
    assert bench.slave.address == 77
    with pytest.raises(DiagnosticError) as raised:
        bench.device.set_switches(127)
    assert raised.value.diagnostics[0].code == "FB7301"


@pytest.mark.fact("pb.led")
def test_the_lamps_show_exchange_life_and_the_supply_of_the_drives(bench):
    shown = [light.value for light in bench.device.leds]
    assert shown == ["off", "off", "off", "off"]
    bench.device.supply("a", True)
    shown = [light.value for light in bench.device.leds]
    assert shown == ["off", "green_flashing", "green", "off"]
    bench.parametrise()
    bench.send()
    bench.device.supply("b", True)
    shown = [light.value for light in bench.device.leds]
    assert shown == ["green", "green_flashing", "green", "green"]


def test_it_initialises_as_long_as_its_option_says(make_bench):
    bench = make_bench(2, {"startup_ms": 300})
    bench.device.supply("a", True)
    bench.kernel.run_for(299 * NS_PER_MS)
    assert not bench.slave.powered
    bench.kernel.run_for(1 * NS_PER_MS)
    assert bench.slave.powered
