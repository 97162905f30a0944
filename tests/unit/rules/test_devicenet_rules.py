"""The rules on DeviceNet: the generated blocks keep them, and without a piece of a block each tells
what it forbids."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import Plant, load_plant
from harness.rules.run_commands import run_bits_of
from tests.unit.rules.watched import WatchedPlant

ROOT = Path(__file__).parents[3]
CATALOG = load_catalog()
RULES = ("jobs_answered", "lost_is_told", "no_command_unasked", "no_run_again")


@pytest.fixture(scope="module")
def plan() -> Plant:
    return load_plant(ROOT / "tests" / "scenarios" / "devicenet" / "two_channels.yaml", CATALOG)


class Watched(WatchedPlant):
    """Two drives, of which the belt is run, with what breaks the rules."""

    def __init__(self, plan: Plant, *changes: tuple[str, str]) -> None:
        super().__init__(plan, CATALOG, RULES, changes)
        self.run_ms(3500)
        self.set("control.frequency", 30.0)
        self.set("control.enable", True)
        self.run_ms(700)

    def set(self, name: str, value: object) -> None:
        self.plant.cpu.engine.set_global(f"TOS_Plant.net1.belt.{name}", value)

    def run_and_lose_the_drive(self) -> None:
        self.set("control.run", True)
        self.run_ms(1000)
        assert self.plant.drives["belt"].running
        self.plant.drives["belt"].power_off()
        self.run_ms(1000)
        self.plant.drives["belt"].power_on()
        self.run_ms(4000)

    def job(self, mode: int = 1, value: int = 0) -> None:
        self.set("parameter.mode", mode)
        self.set("parameter.number", 0x0009)
        self.set("parameter.value", value)
        self.set("parameter.execute", True)
        self.run_ms(500)
        self.set("parameter.execute", False)
        self.run_ms(100)


def test_the_generated_blocks_keep_all_of_them(plan: Plant) -> None:
    watched = Watched(plan)
    watched.run_and_lose_the_drive()
    assert not watched.plant.drives["belt"].running, "it does not start by itself"
    watched.job()
    watched.job(2, 50)
    assert watched.plant.drives["belt"].read_word("acceleration_time") == 50
    watched.set("control.run", False)
    watched.run_ms(100)
    watched.set("control.run", True)
    watched.run_ms(500)
    assert watched.plant.drives["belt"].running
    watched.plant.drives["belt"].trip("OC1")
    watched.run_ms(500)
    watched.set("control.reset", True)
    watched.run_ms(4000)
    assert not watched.plant.drives["belt"].tripped
    assert not watched.plant.drives["belt"].running
    assert watched.broken == {}


@pytest.mark.parametrize(
    "changes",
    [
        # the inhibition goes with its cause
        [("ELSIF NOT #tempWanted THEN", "ELSE")],
        # a drive that is gone goes on being told to run
        [("IF NOT #drive.state.online\n", "IF FALSE\n"), ("OR NOT #tempReady\n", "\n")],
    ],
)
def test_a_drive_that_would_start_by_itself_is_told(
    plan: Plant, changes: list[tuple[str, str]]
) -> None:
    watched = Watched(plan, *changes)
    watched.run_and_lose_the_drive()
    assert "belt is told to run again (0061)" in watched.broken["no_run_again"][0]


def test_a_run_command_without_run_is_told(plan: Plant) -> None:
    wanted, release = "#tempWanted := #drive.control.run;", "ELSIF NOT #tempWanted THEN"
    watched = Watched(plan, (wanted, "#tempWanted := TRUE;"), (release, "ELSE"))
    assert "a run command (0061) went out to belt, unasked" in watched.broken["no_command_unasked"]


def test_a_lost_drive_that_is_shown_as_running_is_told(plan: Plant) -> None:
    running = "#drive.state.running := #drive.state.online AND NOT #tempTripped AND #tempRuns;"
    watched = Watched(plan, (running, "#drive.state.running := #drive.control.run;"))
    watched.set("control.run", True)
    watched.plant.networks["net1"].drops["belt"].plugged = False
    watched.run_ms(1000)
    assert "belt is shown as running, and it is lost" in watched.broken["lost_is_told"]


def test_a_job_that_nobody_answered_is_told(plan: Plant) -> None:
    watched = Watched(plan, ("#result := #frameIn.data;", "#result := 16#1234;"))
    watched.job()
    assert "a job for 0009 gives 1234" in watched.broken["jobs_answered"][0]


@pytest.mark.parametrize(
    ("drive", "place"),
    [
        ("basic", (0, 0x0001)),
        ("extended", (0, 0x0003)),
        ("words", (0, 0x0400)),
        ("channel", (0, 0x0003)),
        ("chosen", (0, 0x0400)),
        ("both", (8, 0x0400)),
    ],
)
def test_run_bits_stand_where_the_assembly_has_them(drive: str, place: tuple[int, int]) -> None:
    plan = load_plant(ROOT / "tests" / "scenarios" / "devicenet" / "all_assemblies.yaml", CATALOG)
    watched = WatchedPlant(plan, CATALOG, (), ())
    assert run_bits_of(watched.plant.options[drive]) == place
