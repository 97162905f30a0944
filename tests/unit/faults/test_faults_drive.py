"""What faults of a drive do, as the drive, the line and the PLC show it."""

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import Plant
from fbgen.wire.toshiba import ErrorCode
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import Transmission
from tests.unit.faults.fault_plant import all_is_well, fault, five_drives, polled, started


@pytest.fixture(scope="module")
def plan() -> Plant:
    return five_drives()


@pytest.fixture
def plant(plan: Plant) -> Installation:
    return started(plan)


@pytest.fixture
def replies(plant: Installation) -> list[Transmission]:
    """What drive3 sends."""
    sent: list[Transmission] = []
    port = plant.drives["drive3"].communication.port
    plant.lines["gw1"].taps.append(lambda item: sent.append(item) if item.sender is port else None)
    return sent


TRIPS = [trip.display for trip in load_catalog().drive("vf-s11").trips if trip.code]


@pytest.mark.parametrize("display", TRIPS)
def test_each_trip_of_the_catalogue_can_be_had(plant: Installation, display: str) -> None:
    drive = plant.drives["drive3"]
    fault(plant, "drive_tripped", {"display": display}).inject()
    assert drive.trip_display == display
    assert drive.read_word("FC90") == drive.trips.code_of(display)


def test_a_trip_stays_when_its_cause_is_gone_until_it_is_reset(plant: Installation) -> None:
    drive = plant.drives["drive3"]
    made = fault(plant, "drive_tripped", {"display": "OL2"})
    made.inject()
    made.clear()
    plant.run_for(100 * NS_PER_MS)
    assert drive.trip_display == "OL2"
    drive.reset()
    assert not drive.tripped


def test_with_the_emergency_stop_open_no_reset_and_no_power_cycle_helps(
    plant: Installation,
) -> None:
    drive = plant.drives["drive3"]
    made = fault(plant, "drive_emergency_stop")
    made.inject()
    assert drive.trip_display == "E"
    drive.reset()
    assert drive.trip_display == "E"
    drive.power_off()
    drive.power_on()
    assert drive.trip_display == "E"
    made.clear()
    assert drive.trip_display == "E", "it stays until it is reset"
    drive.reset()
    assert not drive.tripped


def test_locked_parameters_refuse_writes_and_obey_commands(plant: Installation) -> None:
    drive = plant.drives["drive3"]
    fault(plant, "drive_parameters_locked").inject()
    acceleration, set_point = 0x0009, 0xFA01
    assert drive.write_ram(acceleration, 50) is ErrorCode.CANNOT_EXECUTE
    assert drive.write_eeprom(acceleration, 50) is ErrorCode.CANNOT_EXECUTE
    assert drive.write_ram(set_point, 1000) is None
    with pytest.raises(DiagnosticError):
        drive.set_parameter("acceleration_time", 3.0)


def test_a_worn_eeprom_refuses_what_should_stay_and_takes_what_need_not(
    plant: Installation,
) -> None:
    drive = plant.drives["drive3"]
    fault(plant, "drive_eeprom_worn").inject()
    assert drive.write_eeprom(0x0009, 50) is ErrorCode.CANNOT_EXECUTE
    assert drive.write_ram(0x0009, 50) is None
    assert drive.read_parameter("acceleration_time") == 5.0


def test_a_slow_drive_takes_this_time_for_each_reply(
    plant: Installation, replies: list[Transmission]
) -> None:
    recorder = plant.record_telegrams()["gw1"]
    fault(plant, "drive_slow", {"reply_time": "18 ms"}).inject()
    plant.run_for(5 * NS_PER_S)
    asked = [
        item.frames
        for item in recorder.records
        if len(item.frames) == 2 and item.frames[0].data[1] == 3
    ]
    assert len(asked) > 3
    assert {answer.start_ns - request.end_ns for request, answer in asked[1:]} == {18 * NS_PER_MS}


def test_a_late_reply_is_not_taken_for_that_of_another(
    plant: Installation, replies: list[Transmission]
) -> None:
    fault(plant, "drive_answers_late", {"delay": "150 ms", "probability": 0.5}).inject()
    plant.drives["drive3"].trip("OL1")
    plant.run_for(5 * NS_PER_S)
    assert replies
    trips = {name: polled(plant, name, "tripCode") for name in plant.drives}
    assert {name for name, code in trips.items() if code} <= {"drive3"}


def test_a_drive_that_answers_for_another_is_missed_and_never_taken_for_it(
    plant: Installation, replies: list[Transmission]
) -> None:
    plant.drives["drive3"].trip("OL1")
    fault(plant, "drive_answers_for_another", {"other": "drive1"}).inject()
    plant.run_for(100 * NS_PER_MS)
    replies.clear()
    plant.run_for(3 * NS_PER_S)
    assert {item.data[1] for item in replies} == {1}
    assert polled(plant, "drive3", "lost") is True
    assert polled(plant, "drive1", "lost") is False
    assert polled(plant, "drive1", "tripCode") == 0


def test_of_two_drives_with_one_number_both_answer_and_one_number_is_missing(
    plant: Installation,
) -> None:
    made = fault(plant, "drive_number_doubled", {"other": "drive1"})
    collided: list[Transmission] = []
    plant.lines["gw1"].taps.append(lambda item: collided.append(item) if item.collided else None)
    made.inject()
    plant.run_for(3 * NS_PER_S)
    assert collided
    assert polled(plant, "drive3", "lost") is True
    made.clear()
    plant.run_for(3 * NS_PER_S)
    assert all_is_well(plant)
