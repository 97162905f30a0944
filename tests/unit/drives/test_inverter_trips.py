"""Trips: time-out, latching, frozen monitors, what a reset does."""

import pytest
from drive_bench import GATEWAY_SETTINGS, Bench

from fbgen.diagnostics import DiagnosticError
from harness.drives import Inverter, InverterSettings, Panel

HEARTBEAT = b"(**P08800001)\r"


def running(parameters: dict[str, float] | None = None) -> tuple[Bench, Inverter]:
    bench = Bench()
    drive = bench.add(parameters=parameters)
    drive.set_panel(Panel(run=True, frequency_hz=30.0))
    bench.wait(20)
    return bench, drive


@pytest.mark.fact("tos.f803")
def test_no_telegram_within_f803_trips_err5() -> None:
    bench, drive = running({"communication_timeout": 1})
    bench.ask("0B 47 FC 90 00 00")
    bench.wait(0.95)
    assert (drive.tripped, drive.running) == (False, True)
    bench.wait(0.05)
    assert (drive.trip_display, drive.trip_code, drive.running) == ("Err5", 0x18, False)
    assert bench.ask("0B 47 FC 90 00 00") == "0B 67 FC 90 00 18"


@pytest.mark.fact("tos.hb")
def test_heartbeat_keeps_the_time_out_from_coming() -> None:
    bench, drive = running({"communication_timeout": 1})
    for _ in range(10):
        bench.send(HEARTBEAT)
        bench.wait(0.46)
    assert not drive.tripped
    bench.wait(1)
    assert drive.tripped


def test_telegram_at_the_very_end_of_the_time_is_in_time() -> None:
    bench, drive = running({"communication_timeout": 1})
    for _ in range(3):
        bench.port.transmit(HEARTBEAT)
        bench.wait(1)
    bench.wait(0.001)
    assert not drive.tripped


def test_time_out_stored_in_the_eeprom_starts_with_the_first_telegram_after_power_on() -> None:
    bench, drive = running({"communication_timeout": 1})
    bench.wait(100)
    assert not drive.tripped
    bench.ask("0B 47 FC 90 00 00")
    bench.wait(1.1)
    assert drive.tripped


def test_time_out_that_was_just_set_starts_with_the_next_telegram() -> None:
    bench, drive = running()
    bench.ask("0B 50 08 03 00 01")
    bench.wait(10)
    assert not drive.tripped
    bench.ask("0B 47 FC 90 00 00")
    bench.wait(1.1)
    assert drive.tripped


def test_shorter_time_out_counts_from_the_telegram_after_it_was_set() -> None:
    bench, drive = running({"communication_timeout": 100})
    bench.ask("0B 47 FC 90 00 00")
    drive.set_parameter("communication_timeout", 2)
    bench.ask("0B 47 FC 90 00 00")
    bench.wait(2.1)
    assert drive.tripped


@pytest.mark.parametrize(
    "frame",
    [
        "2F 0C 50 00 09 00 32 C6",
        "2F 0B 50 00 09 00 32 00",
        "2F 0B 51 00 09 00 32 C6",
    ],
)
def test_foreign_damaged_and_unknown_telegrams_do_not_restart_the_time_out(frame: str) -> None:
    bench, drive = running({"communication_timeout": 1})
    bench.ask("0B 47 FC 90 00 00")
    for _ in range(4):
        bench.wait(0.25)
        bench.send(bytes.fromhex(frame))
    assert drive.tripped


@pytest.mark.parametrize(("choice", "trips"), [("any_answered", False), ("writes", True)])
def test_whether_reads_restart_the_time_out_is_an_option(choice: str, trips: bool) -> None:
    bench = Bench()
    parameters = GATEWAY_SETTINGS | {"inverter_number": 11, "communication_timeout": 1}
    settings = (
        InverterSettings(parameters=parameters, timeout_restart="writes")
        if choice == "writes"
        else InverterSettings(parameters=parameters)
    )
    drive = bench.add(settings=settings)
    bench.ask("0B 50 00 09 00 32")
    for _ in range(4):
        bench.wait(0.4)
        bench.ask("0B 47 FC 90 00 00")
    assert drive.tripped is trips


def test_replies_of_a_tripped_inverter_are_lower_case() -> None:
    bench, drive = running()
    drive.trip("OC1")
    assert bench.ask("0B 47 FC 90 00 00") == "0B 67 FC 90 00 01"
    assert bench.ask("0B 50 00 09 00 64") == "0B 70 00 09 00 64"
    assert bench.ask("0B 57 00 09 00 64") == "0B 77 00 09 00 64"
    assert bench.ask("0B 47 12 34 00 00") == "0B 6E 00 02"
    assert bench.send(b"(11RFC90)\r") == [b"(11rFC900001)\r"]
    assert bench.send(b"(11XFC90)\r") == [b"(11n0003)\r"]


def test_trip_freezes_the_held_monitors_and_not_the_present_ones() -> None:
    bench, drive = running()
    drive.trip("OL1")
    bench.wait(10)
    assert [drive.read_word(key) for key in ("FD00", "FD03", "FD05")] == [0, 0, 0]
    assert [drive.read_word(key) for key in ("FE00", "FE03", "FE05")] == [3000, 3000, 6000]
    assert drive.read_word("FE01") == 0x6400
    assert drive.read_word("FD01") == 0x0003


def test_first_trip_stays_until_the_reset_and_run_is_ignored_meanwhile() -> None:
    bench, drive = running()
    drive.trip("OL1")
    drive.trip("OC1")
    assert drive.trip_display == "OL1"
    drive.set_panel(Panel(run=True, frequency_hz=10.0))
    bench.ask("0B 50 FA 00 C4 00")
    bench.wait(10)
    assert not drive.running


def test_last_four_trips_are_kept_over_power_off() -> None:
    _, drive = running()
    for display in ("OC1", "OC2", "OC3", "OL1", "OL2"):
        drive.trip(display)
        drive.reset()
    drive.power_off()
    drive.power_on()
    assert [drive.read_word(f"FE1{place}") for place in range(4)] == [0x0E, 0x0D, 0x03, 0x02]
    assert not drive.tripped


def test_reset_is_not_answered_and_the_inverter_is_gone_for_two_seconds() -> None:
    bench, drive = running()
    drive.trip("OC1")
    assert bench.ask("0B 50 FA 00 20 00") == ""
    assert not drive.tripped
    bench.wait(1.9)
    assert bench.ask("0B 47 FC 90 00 00") == ""
    bench.wait(0.1)
    assert bench.ask("0B 47 FC 90 00 00") == "0B 47 FC 90 00 00"


@pytest.mark.fact("as1.cw.latch")
def test_reset_takes_network_control_away_and_stops() -> None:
    bench = Bench()
    drive = bench.add()
    bench.ask("0B 50 FA 01 13 88")
    bench.ask("0B 50 FA 00 C4 00")
    bench.wait(10)
    assert (drive.network_command, drive.running) == (True, True)
    bench.ask("0B 50 FA 00 E4 00")
    assert (drive.network_command, drive.network_frequency, drive.running) == (False,) * 3
    assert (drive.read_word("FA00"), drive.read_word("FA01")) == (0, 0)
    assert drive.shaft_hz > 0


def test_broadcast_reset_resets_all_without_an_answer() -> None:
    # TOSPBDP001 manual, section 7
    bench = Bench()
    drives = [bench.add(number) for number in (0, 1, 2)]
    for drive in drives:
        drive.trip("OL2")
    assert bench.ask("FF 50 FA 00 20 00") == ""
    assert [drive.tripped for drive in drives] == [False] * 3


def test_after_a_reset_the_time_out_waits_for_the_first_telegram() -> None:
    bench, drive = running({"communication_timeout": 1})
    bench.ask("0B 47 FC 90 00 00")
    bench.wait(1)
    bench.ask("0B 50 FA 00 20 00")
    bench.wait(10)
    assert not drive.tripped


def test_inverter_without_power_does_not_trip() -> None:
    bench, drive = running({"communication_timeout": 1})
    bench.ask("0B 47 FC 90 00 00")
    drive.power_off()
    drive.trip("OC1")
    drive.reset()
    bench.wait(10)
    assert (drive.tripped, drive.running, drive.powered) == (False, False, False)


def test_unknown_trip_is_told_with_the_known_ones() -> None:
    _, drive = running()
    with pytest.raises(DiagnosticError, match="Err5") as caught:
        drive.trip("ERR5")
    assert [finding.code for finding in caught.value.diagnostics] == ["FB7102"]


def test_reset_key_does_nothing_without_a_trip() -> None:
    bench, drive = running()
    drive.reset()
    assert drive.running
    assert bench.ask("0B 47 FC 90 00 00") == "0B 47 FC 90 00 00"
