"""What faults of the line do, as gateway, drives and PLC show it."""

from collections.abc import Mapping

import pytest

from fbgen.plant import Plant
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import GATEWAY_FORMAT, Reception, Role
from tests.unit.faults.fault_plant import all_is_well, fault, five_drives, polled, started


@pytest.fixture(scope="module")
def plan() -> Plant:
    return five_drives()


@pytest.fixture
def plant(plan: Plant) -> Installation:
    return started(plan)


class Listener:
    """What arrives on a pair."""

    def __init__(self) -> None:
        self.heard: list[Reception] = []

    def receive(self, reception: Reception) -> None:
        self.heard.append(reception)


def listening(plant: Installation) -> Listener:
    """Somebody who hears what the drives send."""
    listener = Listener()
    plant.lines["gw1"].attach(listener, Role.MASTER, GATEWAY_FORMAT)
    return listener


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("line_broken", {}),
        ("line_broken_one_way", {"direction": "to_drives"}),
        ("gateway_unpowered", {}),
    ],
)
def test_drives_that_hear_nothing_trip(
    plant: Installation, name: str, settings: Mapping[str, float | str]
) -> None:
    fault(plant, name, settings).inject()
    plant.run_for(1500 * NS_PER_MS)
    assert {drive.trip_display for drive in plant.drives.values()} == {"Err5"}


def test_with_the_way_back_broken_the_drives_run_on_and_the_plc_misses_them(
    plant: Installation,
) -> None:
    fault(plant, "line_broken_one_way", {"direction": "from_drives"}).inject()
    plant.run_for(3 * NS_PER_S)
    assert not any(drive.tripped for drive in plant.drives.values())
    assert all(polled(plant, drive, "lost") is True for drive in plant.drives)


@pytest.mark.parametrize(
    "name", ["line_noise", "line_bytes_lost", "line_bytes_doubled", "line_babbling"]
)
def test_what_is_no_reply_is_counted_by_the_gateway(plant: Installation, name: str) -> None:
    fault(plant, name).inject()
    codes: set[int] = set()
    for _ in range(300):
        plant.run_for(10 * NS_PER_MS)
        codes.add(plant.gateways["gw1"].status.code)
    assert codes - {0x1F}, "no error in three seconds, until a valid telegram comes again"


@pytest.mark.parametrize(
    ("name", "rate", "more"),
    [
        ("line_bytes_lost", "byte_loss_rate", -1),
        ("line_bytes_doubled", "byte_doubling_rate", 1),
    ],
)
def test_a_lost_byte_is_missing_and_a_doubled_one_comes_twice(
    plan: Plant, name: str, rate: str, more: int
) -> None:
    plant = started(plan)
    listener = listening(plant)
    fault(plant, name, {rate: 0.01, "direction": "from_drives"}).inject()
    plant.run_for(5 * NS_PER_S)
    added = {len(item.data) - len(item.transmission.data) for item in listener.heard}
    assert {0, more} <= added
    assert all(count * more >= 0 for count in added)


def test_the_rest_of_a_delayed_frame_comes_so_much_later(plan: Plant) -> None:
    plant = started(plan)
    listener = listening(plant)
    delay = {"delay": "30 ms", "probability": 1.0, "direction": "from_drives"}
    fault(plant, "line_bytes_delayed", delay).inject()
    plant.run_for(NS_PER_S)
    late = [item for item in listener.heard if item.late_ns and not item.transmission.collided]
    assert late
    for item in late:
        assert item.late_ns == 30 * NS_PER_MS
        assert item.end_ns == item.transmission.end_ns + 30 * NS_PER_MS
        assert item.byte_end_ns(len(item.data) - 1) == item.end_ns
        early = [
            other.data
            for other in listener.heard
            if other.transmission is item.transmission and other is not item
        ]
        assert b"".join(early) + item.data == item.transmission.data


def test_babbling_is_heard_until_it_is_cleared(plan: Plant) -> None:
    plant = started(plan)
    listener = listening(plant)
    made = fault(plant, "line_babbling", {"pause": "20 ms", "longest": 4})
    made.inject()
    plant.run_for(2 * NS_PER_S)
    babble = [item for item in listener.heard if item.transmission.sender is None]
    assert len(babble) > 30
    assert {len(item.transmission.data) for item in babble} == {1, 2, 3, 4}
    made.clear()
    plant.run_for(10 * NS_PER_MS)
    listener.heard.clear()
    plant.run_for(2 * NS_PER_S)
    assert listener.heard
    assert all(item.transmission.sender is not None for item in listener.heard)
    assert all_is_well(plant)


@pytest.mark.parametrize(
    ("direction", "tripped"), [("both", True), ("to_drive", True), ("from_drive", False)]
)
def test_a_broken_stub_is_the_trouble_of_one_drive(
    plant: Installation, direction: str, tripped: bool
) -> None:
    made = fault(plant, "drive_disconnected", {"direction": direction})
    made.inject()
    plant.run_for(3 * NS_PER_S)
    assert {name for name in plant.drives if polled(plant, name, "lost")} == {"drive3"}
    assert plant.drives["drive3"].tripped is tripped
    made.clear()
    plant.run_for(3 * NS_PER_S)
    assert all_is_well(plant)
