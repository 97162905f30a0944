"""What the inverter makes of the command word."""

import pytest
from drive_bench import SERIES, Bench

from harness.drives import Mode, Panel

COMMAND = SERIES.command_word
NETWORK = ["network_command", "network_frequency"]
FIFTY_HZ = "0B 50 FA 01 13 88"


def write(*bits: str) -> str:
    """The payload that writes the named bits into the command word of drive 11."""
    return f"0B 50 FA 00 {COMMAND.encode(list(bits)):04X}"


def run(*more: str) -> str:
    return write(*NETWORK, "run", *more)


@pytest.mark.fact("tos.com")
@pytest.mark.fact("as1.cw.prio")
def test_example_of_the_manual_runs_forward_at_50_hz_and_stops() -> None:
    bench = Bench()
    drive = bench.add()
    assert bench.ask("0B 50 FA 00 C4 00") == "0B 50 FA 00 C4 00"
    assert bench.ask(FIFTY_HZ) == FIFTY_HZ
    bench.wait(10)
    assert (drive.frequency_hz, drive.direction, drive.running) == (50.0, "forward", True)
    assert bench.ask("0B 50 FA 00 C2 00") == "0B 50 FA 00 C2 00"
    bench.wait(10)
    assert (drive.frequency_hz, drive.running) == (0.0, False)
    assert drive.direction == "reverse"


def test_acceleration_time_counts_from_0_to_the_maximum_frequency() -> None:
    bench = Bench()
    drive = bench.add(parameters={"acceleration_time": 8.0, "maximum_frequency": 80.0})
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    start_hz = drive.frequency_hz
    bench.wait(1)
    assert drive.frequency_hz - start_hz == pytest.approx(10.0)


def test_deceleration_time_counts_on_the_way_down() -> None:
    bench = Bench()
    drive = bench.add(parameters={"acceleration_time": 0.0, "deceleration_time": 16.0})
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    bench.ask(write(*NETWORK))
    start_hz = drive.frequency_hz
    bench.wait(1)
    assert start_hz - drive.frequency_hz == pytest.approx(5.0)
    assert drive.running


def test_pattern_2_has_its_own_ramp_times() -> None:
    bench = Bench()
    drive = bench.add(parameters={"acceleration_time": 80.0, "acceleration_time_2": 8.0})
    bench.ask(FIFTY_HZ)
    bench.ask(run("pattern_2"))
    start_hz = drive.frequency_hz
    bench.wait(1)
    assert drive.frequency_hz - start_hz == pytest.approx(10.0)


def test_ramp_time_can_change_on_the_way() -> None:
    bench = Bench()
    drive = bench.add(parameters={"acceleration_time": 80.0})
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    bench.wait(1)
    drive.set_parameter("acceleration_time", 8.0)
    start_hz = drive.frequency_hz
    bench.wait(1)
    assert drive.frequency_hz - start_hz == pytest.approx(10.0)


def test_reverse_at_speed_goes_through_zero() -> None:
    bench = Bench()
    drive = bench.add(parameters={"acceleration_time": 8.0, "deceleration_time": 8.0})
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    bench.wait(10)
    bench.ask(run("reverse"))
    seen = [drive.direction]
    bench.wait(5)
    seen.append(drive.direction)
    assert seen == ["forward", "reverse"]
    assert drive.running
    bench.wait(5)
    assert (drive.frequency_hz, drive.shaft_hz) == (50.0, -50.0)


def test_run_without_command_priority_does_nothing() -> None:
    bench = Bench()
    drive = bench.add()
    bench.ask(FIFTY_HZ)
    bench.ask(write("network_frequency", "run"))
    bench.wait(1)
    assert (drive.running, drive.network_command) == (False, False)


def test_without_frequency_priority_the_panel_sets_the_frequency() -> None:
    bench = Bench()
    drive = bench.add()
    drive.set_panel(Panel(frequency_hz=12.5))
    bench.ask(FIFTY_HZ)
    bench.ask(write("network_command", "run"))
    bench.wait(10)
    assert (drive.frequency_hz, drive.set_point_hz) == (12.5, 12.5)


@pytest.mark.fact("as1.cw.latch")
def test_priority_stays_until_it_is_written_off() -> None:
    bench = Bench()
    drive = bench.add()
    bench.ask(run())
    bench.wait(100)
    assert (drive.network_command, drive.network_frequency) == (True, True)
    bench.ask(write())
    assert (drive.network_command, drive.network_frequency) == (False, False)


def test_losing_priority_hands_over_to_the_panel() -> None:
    bench = Bench()
    drive = bench.add()
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    bench.wait(10)
    drive.set_panel(Panel(run=True, reverse=True, frequency_hz=20.0))
    assert drive.direction == "forward"
    bench.ask(write())
    bench.wait(20)
    assert (drive.frequency_hz, drive.direction) == (20.0, "reverse")


def test_with_cmod_at_serial_communication_no_priority_bit_is_needed() -> None:
    bench = Bench()
    drive = bench.add(parameters={"command_mode": 2})
    bench.ask(FIFTY_HZ)
    bench.ask(write("network_frequency", "run"))
    bench.wait(10)
    assert drive.frequency_hz == 50.0


def test_jog_runs_at_its_own_frequency() -> None:
    bench = Bench()
    drive = bench.add(parameters={"jog_frequency": 6.0, "lower_limit_frequency": 10.0})
    bench.ask(FIFTY_HZ)
    bench.ask(run("jog"))
    bench.wait(10)
    assert drive.frequency_hz == 6.0
    assert SERIES.word("status").field("jog").extract(drive.read_word("status")) == 1


@pytest.mark.parametrize("number", range(1, 16))
def test_each_preset_speed_is_chosen_by_its_number(number: int) -> None:
    bench = Bench()
    drive = bench.add(parameters={f"preset_speed_{number}": 10.0 + number})
    bits = [f"preset_speed_{bit + 1}" for bit in range(4) if number >> bit & 1]
    bench.ask(run(*bits))
    bench.wait(10)
    assert drive.frequency_hz == 10.0 + number


def test_coast_stop_switches_the_output_off_and_the_shaft_turns_on() -> None:
    bench = Bench()
    drive = bench.add()
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    bench.wait(10)
    bench.ask(run("coast_stop"))
    assert (drive.running, drive.frequency_hz, drive.current_percent) == (False, 0.0, 0.0)
    assert 45.0 < drive.shaft_hz < 50.0
    bench.wait(5)
    assert drive.shaft_hz == 0.0
    bench.ask(run())
    bench.wait(1)
    assert drive.running


def test_dc_braking_brings_the_shaft_to_rest_with_direct_current() -> None:
    bench = Bench()
    drive = bench.add(parameters={"dc_braking_current": 60})
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    bench.wait(10)
    bench.ask(run("dc_braking"))
    assert (drive.frequency_hz, drive.current_percent) == (0.0, 60.0)
    bench.wait(1)
    assert drive.shaft_hz == 0.0
    bench.ask(write(*NETWORK))
    assert drive.operation.mode is Mode.COAST
    assert drive.current_percent == 0.0


@pytest.mark.fact("as1.cw.estop")
def test_emergency_stop_works_without_priority_and_trips() -> None:
    bench = Bench()
    drive = bench.add()
    drive.set_panel(Panel(run=True, frequency_hz=30.0))
    bench.wait(10)
    reply = bench.ask(write("emergency_stop"))
    assert reply == "0B 70 FA 00 10 00"
    assert (drive.trip_display, drive.running) == ("E", False)
    assert SERIES.word("status").field("emergency_stopped").extract(drive.read_word("FD01")) == 1


def test_set_point_stays_within_ul_and_ll() -> None:
    bench = Bench()
    drive = bench.add(parameters={"upper_limit_frequency": 40.0, "lower_limit_frequency": 10.0})
    bench.ask(FIFTY_HZ)
    assert bench.ask(run()) != ""
    assert drive.set_point_hz == 40.0
    bench.ask("0B 50 FA 01 00 64")
    assert drive.set_point_hz == 10.0


def test_status_word_of_a_running_inverter_is_6400() -> None:
    # VF-AS1 RS485 manual E6581315, p. 19: FD01 at 60 Hz forward
    bench = Bench()
    bench.add()
    assert bench.ask("0B 47 FD 01 00 00") == "0B 47 FD 01 60 00"
    bench.ask(FIFTY_HZ)
    bench.ask(run())
    bench.wait(10)
    assert bench.ask("0B 47 FD 01 00 00") == "0B 47 FD 01 64 00"


def test_status_word_of_reverse_run_is_6600() -> None:
    # DEV003Z-1 manual E6581737, p. 20: assembly 150 while reversing
    bench = Bench()
    bench.add()
    bench.ask(FIFTY_HZ)
    bench.ask(run("reverse"))
    bench.wait(10)
    assert bench.ask("0B 47 FD 01 00 00") == "0B 47 FD 01 66 00"


def test_status_word_tells_what_is_selected() -> None:
    bench = Bench()
    drive = bench.add()
    drive.monitors.alarm = 1
    bench.ask(write(*NETWORK, "coast_stop", "pattern_2", "pi_control_off", "motor_2", "dc_braking"))
    fields = SERIES.word("status").decode(drive.read_word("status"))
    names = {field.field.name for field in fields if field.value}
    assert names == {
        "standby",
        "coast_stopped",
        "pattern_2",
        "pi_control_off",
        "motor_2",
        "alarm",
    }


def test_operation_time_counts_whole_hours_of_running() -> None:
    bench = Bench()
    drive = bench.add()
    bench.wait(3600)
    drive.set_panel(Panel(run=True, frequency_hz=30.0))
    bench.wait(2 * 3600)
    drive.set_panel(Panel())
    bench.wait(3600)
    assert drive.read_parameter("operation_time") == 2
