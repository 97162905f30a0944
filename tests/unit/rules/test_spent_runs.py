"""On lines a run that is over comes again only after `run` was FALSE, wherever they end."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from tests.unit.rules.watched import WatchedPlant

ROOT = Path(__file__).parents[3]
CATALOG = load_catalog()
PLANTS = {
    "examples/serial/plant.yaml": "line1.fan",
    "examples/five_drives/plant.yaml": "gw1.drive1",
}
RELEASE = ("ELSIF NOT #tempWanted THEN", "ELSE")
"""The inhibition goes with its cause."""


class Watched(WatchedPlant):
    """A drive that runs, with what breaks the rule."""

    def __init__(self, plant: str, *changes: tuple[str, str]) -> None:
        rules = ("lost_is_told", "no_run_again")
        super().__init__(load_plant(ROOT / plant, CATALOG), CATALOG, rules, changes)
        self._base = f"TOS_Plant.{PLANTS[plant]}"
        self.drive = self.plant.drives[PLANTS[plant].split(".")[1]]
        self.run_ms(1500)
        self.set("control.frequency", 20.0)
        self.set("control.enable", True)
        self.run_ms(500)
        self.set("control.run", True)
        self.run_ms(1000)
        assert self.drive.running

    def set(self, name: str, value: object) -> None:
        self.plant.cpu.engine.set_global(f"{self._base}.{name}", value)

    def trip_and_reset(self) -> None:
        self.drive.trip("OC1")
        self.run_ms(2000)
        self.set("control.reset", True)
        self.run_ms(4000)

    def start_the_cpu_again(self) -> None:
        self.plant.cpu.stop()
        self.run_ms(1000)
        self.set("control.run", True)
        self.plant.cpu.start()
        self.set("control.run", True)
        self.set("control.enable", True)
        self.run_ms(2000)


@pytest.mark.parametrize("plant", PLANTS)
def test_the_generated_blocks_keep_it(plant: str) -> None:
    watched = Watched(plant)
    watched.trip_and_reset()
    assert not watched.drive.tripped
    assert not watched.drive.running, "it does not start by itself"
    watched.set("control.run", False)
    watched.run_ms(500)
    watched.set("control.run", True)
    watched.run_ms(2000)
    assert watched.drive.running
    watched.drive.power_off()
    watched.run_ms(4000)
    watched.drive.power_on()
    watched.run_ms(4000)
    assert not watched.drive.running
    assert watched.broken == {}


@pytest.mark.parametrize("plant", PLANTS)
def test_a_drive_that_starts_again_behind_its_trip_is_told(plant: str) -> None:
    watched = Watched(plant, RELEASE)
    watched.trip_and_reset()
    assert watched.drive.running
    assert "is told to run again (C400)" in watched.broken["no_run_again"][0]


@pytest.mark.parametrize("plant", PLANTS)
def test_a_drive_that_starts_again_with_the_cpu_is_told(plant: str) -> None:
    watched = Watched(plant, RELEASE)
    watched.start_the_cpu_again()
    assert watched.drive.running
    assert "is told to run again (C400)" in watched.broken["no_run_again"][0]


@pytest.mark.parametrize("plant", PLANTS)
def test_a_drive_that_is_enabled_no_more_is_shown_as_running_until_it_stands(plant: str) -> None:
    """Seed 107 of a campaign of serial lines: it was shown as running for ever."""
    watched = Watched(plant)
    watched.run_ms(3000)
    watched.set("control.enable", False)
    watched.run_ms(300)
    read = watched.plant.cpu.engine.reader([f"TOS_Plant.{PLANTS[plant]}.state.running"])
    assert watched.drive.running
    assert tuple(read()) == (True,)
    watched.drive.trip("OC1")
    watched.run_ms(3000)
    assert tuple(read()) == (False,)
    assert watched.broken == {}
