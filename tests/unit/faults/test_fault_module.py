"""A communication module that does not answer the CPU: its line goes on, its program is told."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from harness.faults import FAULTS, Fault, FaultSettings, Target
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_S

EXAMPLE = Path(__file__).parents[3] / "examples" / "serial" / "plant.yaml"


@pytest.fixture
def plant() -> Installation:
    installation = build_plant(
        load_plant(EXAMPLE, load_catalog()), load_catalog(), PlantSetup(seed=1)
    )
    installation.start()
    installation.run_for(NS_PER_S)
    return installation


def failed(plant: Installation) -> Fault:
    return FAULTS["module_failed"].make(plant, "line1", FaultSettings())


def told(plant: Installation, what: str) -> object:
    return plant.cpu.engine.global_value(f"TOS_Plant.line1.{what}")


def test_its_places_are_the_serial_lines_of_the_plant(plant: Installation) -> None:
    assert set(Target.MODULE.places(plant)) == {"line1"}


def test_the_program_is_told_until_it_answers_again(plant: Installation) -> None:
    fault = failed(plant)
    assert told(plant, "line.online") is True
    fault.inject()
    plant.run_for(NS_PER_S)
    assert told(plant, "line.online") is False
    assert told(plant, "line.portStatus") == 0x8282
    assert told(plant, "pump.polled.lost") is True
    fault.clear()
    plant.run_for(NS_PER_S)
    assert told(plant, "line.online") is True
    assert told(plant, "pump.polled.lost") is False


def test_two_of_them_end_with_the_later_one(plant: Installation) -> None:
    module = plant.devices.modules["line1"]
    first, second = failed(plant), failed(plant)
    first.inject()
    second.inject()
    first.clear()
    assert not module.available
    second.clear()
    assert module.available
