"""The rules behind a gateway for process data: the generated blocks keep them, and without a piece
of a block each tells what it forbids."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import Plant, load_plant
from tests.unit.rules.watched import WatchedPlant

ROOT = Path(__file__).parents[3]
CATALOG = load_catalog()
ABOUT_INTERFACES = ("jobs_answered", "lost_is_told", "no_command_unasked", "no_run_again")


@pytest.fixture(scope="module")
def plan() -> Plant:
    return load_plant(ROOT / "tests" / "scenarios" / "pbdp110" / "two_channels.yaml", CATALOG)


class Watched(WatchedPlant):
    """Two drives, of which the fan is run, with what breaks the rules."""

    def __init__(self, plan: Plant, *changes: tuple[str, str]) -> None:
        super().__init__(plan, CATALOG, ABOUT_INTERFACES, changes)
        self.run_ms(1500)
        self.set("control.frequency", 30.0)
        self.set("control.enable", True)
        self.run_ms(700)

    def set(self, name: str, value: object) -> None:
        self.plant.cpu.engine.set_global(f"TOS_Plant.gw1.fan.{name}", value)

    def run_and_lose_the_drive(self) -> None:
        self.set("control.run", True)
        self.run_ms(500)
        self.plant.drives["fan"].power_off()
        self.run_ms(1500)
        self.plant.drives["fan"].power_on()
        self.run_ms(3000)

    def job(self) -> None:
        self.set("parameter.mode", 1)
        self.set("parameter.number", 0x0009)
        self.set("parameter.execute", True)
        self.run_ms(500)


def test_the_generated_blocks_keep_all_of_them(plan: Plant) -> None:
    watched = Watched(plan)
    watched.run_and_lose_the_drive()
    watched.job()
    names = ("parameter.done", "state.inhibited")
    read = watched.plant.cpu.engine.reader([f"TOS_Plant.gw1.fan.{name}" for name in names])
    assert tuple(read()) == (True, True)
    assert watched.broken == {}


@pytest.mark.parametrize(
    "change",
    [
        # the inhibition goes with its cause
        ("ELSIF NOT #tempWanted THEN", "ELSE"),
        # a drive that is gone goes on being told to run
        ("OR NOT #drive.state.online\n", "\n"),
    ],
)
def test_a_drive_that_would_start_by_itself_is_told(plan: Plant, change: tuple[str, str]) -> None:
    watched = Watched(plan, change)
    watched.run_and_lose_the_drive()
    assert "fan is told to run again (C400)" in watched.broken["no_run_again"][0]


def test_a_run_command_without_run_is_told(plan: Plant) -> None:
    watched = Watched(plan, ("AND NOT #drive.state.inhibited THEN", "THEN"))
    watched.set("control.run", True)
    watched.run_ms(200)
    watched.set("control.enable", False)
    watched.run_ms(700)
    assert "went out to fan, unasked" in watched.broken["no_command_unasked"][0]


def test_a_drive_that_is_gone_and_shown_as_ready_is_told(plan: Plant) -> None:
    watched = Watched(plan, ("#drive.state.ready := ", "#drive.state.ready := TRUE OR "))
    watched.run_and_lose_the_drive()
    assert "fan is shown as ready, and it is lost" in watched.broken["lost_is_told"]


def test_a_value_that_no_drive_has_answered_is_told(plan: Plant) -> None:
    watched = Watched(plan, ("#result := #frameIn.data;", "#result := #statNumber;"))
    watched.job()
    assert watched.broken["jobs_answered"] == [
        "fan: a job for 0009 gives 0009, which nobody answered"
    ]
