"""Heartbeat, bus faults, CLEAR, address switches, lamps (TOSPBDP001 manual, 3, 7, 8 C)."""

from itertools import pairwise

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.wire.toshiba import seal
from harness.fieldbus import Parameters, watchdog_factors
from harness.gateways.tospbdp001 import Fault, Light, OfflineOutputs, SubnetErrorLed
from harness.kernel import NS_PER_MS

START = "0B50FA00C400"
HEARTBEAT = b"(**P08800001)\r"


@pytest.mark.fact("tos.hb")
def test_a_safety_telegram_in_ascii_goes_to_all_drives_every_500_ms(bench):
    bench.run_ms(2_500)
    sent = [item for item in bench.on_line if item.data == HEARTBEAT]
    gaps_ns = {later.start_ns - earlier.start_ns for earlier, later in pairwise(sent)}
    assert gaps_ns == {500 * NS_PER_MS}
    assert len(sent) == 5


@pytest.mark.fact("tos.hb")
@pytest.mark.parametrize("answer", [b"(00P08800001)\r", b"(00p08800001)\r", b"(00N0002)\r"])
def test_neither_heartbeat_nor_its_answer_reach_profibus(bench, answer):
    before = bytes(bench.station.inputs)
    bench.run_ms(500)
    bench.noise(answer)
    assert bytes(bench.station.inputs) == before


@pytest.mark.fact("tos.hb")
def test_the_frame_of_the_heartbeat_is_an_option(settings_of, make_bench):
    bench = make_bench(settings_of("gsd10", heartbeat_frame="(**PFA008400)"))
    bench.run_ms(600)
    assert bench.inverter.heard[0][1] == b"(**PFA008400)\r"


@pytest.mark.fact("tos.hb.busfault")
@pytest.mark.fact("C2-4")
def test_a_bus_fault_silences_telegrams_and_heartbeat_after_the_watchdog_time(bench):
    bench.run_ms(300)
    bench.master.connected = False
    bench.run_ms(99)
    assert bench.gateway.slave.online
    bench.run_ms(3_000)
    assert not bench.gateway.slave.online
    assert bench.inverter.heard == []


@pytest.mark.fact("tos.hb.busfault")
def test_a_telegram_that_waits_when_the_bus_fails_is_dropped(bench_of):
    bench = bench_of(processing_ns=150 * NS_PER_MS)
    bench.send(0, 1, START)
    bench.run_ms(10)
    bench.master.connected = False
    bench.run_ms(1_000)
    assert bench.inverter.heard == []
    bench.master.connected = True
    bench.run_ms(20)
    bench.send(0, 2, START)
    bench.run_ms(300)
    assert bench.inverter.frames == [seal(bytes.fromhex(START))]
    assert bench.gateway.overwritten == 0


@pytest.mark.fact("tos.hb.busfault")
def test_heartbeat_and_telegrams_come_back_with_the_bus(bench):
    bench.master.connected = False
    bench.run_ms(1_000)
    bench.master.connected = True
    bench.run_ms(20)
    bench.send(0, 1, START)
    bench.run_ms(600)
    assert len(bench.inverter.heartbeats) == 1
    assert bench.inverter.frames == [seal(bytes.fromhex(START))]


def test_a_trigger_that_stands_where_it_stood_before_the_bus_fault_sends_nothing(bench):
    bench.send(0, 1, START)
    bench.run_ms(60)
    bench.master.connected = False
    bench.run_ms(1_000)
    bench.master.connected = True
    bench.run_ms(100)
    assert len(bench.inverter.frames) == 1


@pytest.mark.fact("dp.nowd")
def test_without_watchdog_the_gateway_never_notices_that_the_master_is_gone(
    make_bench, settings_of
):
    bench = make_bench(settings_of("gsd10"), watchdog_ns=None)
    bench.master.stop()
    bench.run_ms(10_000)
    assert bench.gateway.leds.fieldbus_online is Light.GREEN
    assert len(bench.inverter.heartbeats) == 20


@pytest.mark.fact("C2-4")
@pytest.mark.parametrize(
    ("behaviour", "frames", "heartbeats"),
    [("FREEZE", 1, 2), ("CLEAR", 2, 2), ("NO_SCANNING", 1, 0)],
)
def test_what_goes_on_while_profibus_is_down_is_an_option(bench_of, behaviour, frames, heartbeats):
    bench = bench_of(offline_outputs=OfflineOutputs[behaviour])
    bench.send(0, 1, START)
    bench.run_ms(60)
    bench.master.stop()
    bench.run_ms(1_000)
    assert (len(bench.inverter.frames), len(bench.inverter.heartbeats)) == (frames, heartbeats)


@pytest.mark.fact("C2-12")
def test_clear_sends_a_telegram_of_zeros_and_the_heartbeat_goes_on(bench):
    bench.send(0xE000, 1, START)
    bench.run_ms(60)
    bench.master.clear()
    bench.run_ms(2_000)
    assert bench.inverter.frames[1:] == [bytes.fromhex("2F 00 00 00 00 00 00 2F")]
    assert len(bench.inverter.heartbeats) == 4
    assert bench.gateway.leds.fieldbus_online is Light.GREEN


@pytest.mark.fact("C2-12")
def test_clear_with_the_trigger_at_00_sends_nothing(bench):
    bench.master.clear()
    bench.run_ms(100)
    assert bench.inverter.frames == []


@pytest.mark.fact("tos.addr")
def test_the_address_is_b_times_10_plus_a_and_is_read_at_power_on_only(bench):
    bench.gateway.set_switches(37)
    assert (bench.gateway.switch_b, bench.gateway.switch_a) == (3, 7)
    bench.run_ms(100)
    assert bench.station.exchanging
    bench.gateway.power_off()
    bench.gateway.power_on()
    bench.run_ms(100)
    assert bench.gateway.slave.address == 37
    assert bench.station.failed


@pytest.mark.fact("tos.addr")
@pytest.mark.parametrize("address", [-1, 100])
def test_two_rotary_switches_show_0_to_99(bench, address):
    with pytest.raises(DiagnosticError) as caught:
        bench.gateway.set_switches(address)
    assert caught.value.diagnostics[0].code == "FB7301"


def test_a_power_cycle_forgets_everything(bench):
    bench.control(0x4000)
    bench.noise(b"\x00")
    bench.valid_reply()
    bench.noise(b"\x00")
    bench.gateway.power_off()
    bench.run_ms(100)
    assert bytes(bench.station.inputs) == bytes(8)
    bench.control(0)
    bench.gateway.power_on()
    bench.run_ms(100)
    assert bytes(bench.station.inputs) == bytes.fromhex("9F00000000000000")


@pytest.mark.fact("tos.trig")
def test_after_a_power_cycle_a_trigger_other_than_00_sends_at_once(bench):
    bench.send(0, 5, START)
    bench.run_ms(60)
    bench.gateway.power_off()
    bench.run_ms(60)
    bench.gateway.power_on()
    bench.run_ms(60)
    assert len(bench.inverter.frames) == 2


def test_supply_lost_in_the_middle_of_a_frame_cuts_the_frame(bench):
    bench.send(0, 1, START)
    bench.run_ms(9)
    bench.gateway.power_off()
    bench.run_ms(60)
    assert 0 < len(bench.inverter.heard[0][1]) < 8
    assert len(bench.inverter.heard) == 1


def test_a_reply_in_progress_dies_with_the_supply(bench):
    bench.inverter.say(seal(bytes.fromhex("0B47FE031234")))
    bench.run_ms(7)
    bench.gateway.power_off()
    bench.gateway.power_on()
    bench.run_ms(60)
    assert bench.reply == bytes(6)


@pytest.mark.fact("tos.led.1")
@pytest.mark.fact("tos.led.2")
def test_leds_1_and_2_say_whether_the_fieldbus_is_online(bench):
    assert bench.gateway.leds[:2] == (Light.GREEN, Light.OFF)
    bench.station.plugged = False
    bench.run_ms(200)
    assert bench.gateway.leds[:2] == (Light.OFF, Light.RED)
    bench.gateway.power_off()
    assert bench.gateway.leds[:2] == (Light.OFF, Light.OFF)


@pytest.mark.fact("tos.led.3")
def test_led_3_is_never_lit(bench):
    seen = {bench.gateway.leds.unused}
    bench.station.plugged = False
    bench.run_ms(200)
    seen.add(bench.gateway.leds.unused)
    for fault in Fault:
        bench.gateway.fail(fault)
        seen.add(bench.gateway.leds.unused)
    assert seen == {Light.OFF}


@pytest.mark.fact("tos.led.4")
def test_led_4_tells_configuration_and_parameter_errors(make_bench, settings_of):
    settings = settings_of("gsd10")
    right = Parameters(0x1803, watchdog_factors(100 * NS_PER_MS))
    bench = make_bench(settings)
    assert bench.gateway.leds.fieldbus_diagnosis is Light.OFF
    bench = make_bench(settings, configuration=bytes.fromhex("30302030307070"))
    assert bench.gateway.leds.fieldbus_diagnosis is Light.RED_1HZ
    assert not bench.gateway.slave.online
    bench = make_bench(settings, parameters=Parameters(0x1803, right.watchdog_factors, 0, b"\1"))
    assert bench.gateway.leds.fieldbus_diagnosis is Light.RED_2HZ
    bench.gateway.fail(Fault.INITIALISATION)
    assert bench.gateway.leds.fieldbus_diagnosis is Light.RED_4HZ


@pytest.mark.fact("tos.led.5")
def test_led_5_is_off_then_flashes_then_stays_green(bench_of):
    bench = bench_of(startup_ns=500 * NS_PER_MS)
    assert bench.gateway.leds.subnet_status is Light.GREEN_FLASHING
    assert not bench.gateway.slave.online
    bench.run_ms(500)
    assert bench.gateway.leds.subnet_status is Light.GREEN
    bench.gateway.power_off()
    assert bench.gateway.leds.subnet_status is Light.OFF


@pytest.mark.fact("tos.led.6")
def test_led_6_shows_the_device(bench_of):
    bench = bench_of(startup_ns=500 * NS_PER_MS)
    gateway = bench.gateway
    assert gateway.leds.device_status is Light.GREEN
    bench.run_ms(500)
    assert gateway.leds.device_status is Light.GREEN_FLASHING
    bench.noise(b"\x00")
    assert gateway.leds.device_status is Light.RED
    gateway.fail(Fault.CONFIGURATION)
    assert gateway.leds.device_status is Light.RED_GREEN_ALTERNATING
    gateway.fail(Fault.HARDWARE)
    assert gateway.leds.device_status is Light.RED_FLASHING
    gateway.power_off()
    assert gateway.leds.device_status is Light.OFF


@pytest.mark.fact("tos.led.5")
def test_as_an_option_led_5_turns_red_as_on_hms_devices(bench_of):
    bench = bench_of(subnet_error_led=SubnetErrorLed.SUBNET_STATUS)
    bench.noise(b"\x00")
    assert bench.gateway.leds[4:] == (Light.RED, Light.GREEN_FLASHING)


def test_a_broken_device_does_nothing_until_it_is_repaired(bench):
    bench.gateway.fail(Fault.HARDWARE)
    bench.send(0, 1, START)
    bench.run_ms(2_000)
    assert bench.inverter.heard == []
    assert bench.station.failed
    bench.gateway.repair()
    bench.run_ms(60)
    assert bench.station.exchanging
    assert bench.inverter.frames == [seal(bytes.fromhex(START))]
