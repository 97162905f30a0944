"""A campaign of drives on DeviceNet, with jobs in their parameter channels."""

from pathlib import Path

import pytest

from harness.verify.campaign.files import campaign_settings
from harness.verify.campaign.trials import drawn, try_seeds

PLANT = Path(__file__).parents[3] / "scenarios" / "devicenet" / "two_channels.yaml"
SETTINGS = campaign_settings([PLANT], [])


def test_cables_have_no_directions_and_what_is_bus_off_gets_its_supply_back() -> None:
    faults = [fault for seed in range(120) for fault in drawn(SETTINGS, seed)["faults"]]
    assert [fault for fault in faults if fault["inject"] == "drive_disconnected"]
    assert not [fault for fault in faults if "direction" in fault.get("settings", {})]
    for seed in range(120):
        found = drawn(SETTINGS, seed)["faults"]
        bus_off = [fault["on"] for fault in found if fault["inject"] == "devicenet_bus_off"]
        away = [fault["on"] for fault in found if fault["inject"] == "drive_unpowered"]
        assert all(away.count(name) >= bus_off.count(name) for name in bus_off)


def test_parameters_are_read_and_written_meanwhile() -> None:
    asked = [str(step) for seed in range(20) for step in drawn(SETTINGS, seed)["steps"]]
    for what in ("'plc.TOS_Plant.net1.belt.parameter.mode': 2", "fan.parameter.abort': True"):
        assert [step for step in asked if what in step], what


def test_seeds_of_the_shipped_blocks_hold_all_rules_and_recover() -> None:
    assert try_seeds(SETTINGS, 9, 10).failures == ()


@pytest.mark.slow
@pytest.mark.parametrize("first", range(0, 200, 20))
def test_many_seeds_of_the_shipped_blocks_hold_all_rules_and_recover(first: int) -> None:
    assert try_seeds(SETTINGS, first, first + 20).failures == ()
