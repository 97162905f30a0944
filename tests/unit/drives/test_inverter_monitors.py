"""What the monitors show, above all the current."""

import pytest
from drive_bench import Bench, loaded

from harness.drives import Inverter, Load, LoadShape, Panel


def at_50_hz(torque_percent: float) -> tuple[Bench, Inverter]:
    bench = Bench()
    drive = bench.add(settings=loaded(torque_percent))
    drive.set_panel(Panel(run=True, frequency_hz=50.0))
    bench.wait(20)
    return bench, drive


@pytest.mark.fact("tos.cmd.47")
def test_current_of_the_manual_example_is_10e8_with_a_load_of_32_7_percent() -> None:
    bench, drive = at_50_hz(32.7)
    assert bench.ask("0B 47 FE 03 00 00") == "0B 47 FE 03 10 E8"
    assert drive.read_parameter("FE03") == pytest.approx(43.28)


@pytest.mark.parametrize(("torque", "current"), [(0.0, 3000), (50.0, 5635), (100.0, 10000)])
def test_another_load_draws_another_current(torque: float, current: int) -> None:
    _, drive = at_50_hz(torque)
    assert drive.read_word("FD03") == current


def test_load_can_change_while_running() -> None:
    _, drive = at_50_hz(0.0)
    drive.load = Load(100.0, LoadShape.QUADRATIC)
    assert drive.current_percent == pytest.approx(100.0)
    assert drive.read_parameter("FD18") == pytest.approx(100.0)
    assert drive.read_parameter("torque_current") == pytest.approx(95.39)
    assert drive.read_parameter("exciting_current") == pytest.approx(30.0)


def test_stopped_inverter_draws_no_current() -> None:
    bench, drive = at_50_hz(50.0)
    drive.set_panel(Panel())
    bench.wait(20)
    assert [drive.read_word(key) for key in ("FD00", "FD03", "FD05", "FD18", "FD21")] == [0] * 5


def test_frequency_and_voltage_follow_the_ramp() -> None:
    bench = Bench()
    drive = bench.add(parameters={"acceleration_time": 8.0})
    drive.set_panel(Panel(run=True, reverse=True, frequency_hz=50.0))
    bench.wait(2.5)
    assert drive.read_parameter("FD00") == pytest.approx(25.0)
    assert drive.read_parameter("FD02") == pytest.approx(50.0)
    assert drive.read_parameter("FD05") == pytest.approx(50.0)


def test_held_monitors_follow_the_present_ones_without_a_trip() -> None:
    _, drive = at_50_hz(20.0)
    for suffix in ("00", "01", "02", "03", "04", "05", "06", "07"):
        assert drive.read_word(f"FE{suffix}") == drive.read_word(f"FD{suffix}")


def test_terminals_and_alarm_read_as_the_scenario_sets_them() -> None:
    bench, drive = at_50_hz(0.0)
    drive.monitors.alarm = 0x0080
    for terminal in ("f", "s3"):
        drive.switch_terminal(terminal, True)
    drive.monitors.output_terminals = 0x0002
    assert bench.ask("0B 47 FC 91 00 00") == "0B 47 FC 91 00 80"
    assert (drive.read_word("FD06"), drive.read_word("FD07")) == (0x21, 2)
