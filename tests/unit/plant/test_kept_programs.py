"""The program of a plant and its Python are kept for the next process, and run there as here."""

from collections import OrderedDict
from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from harness.engine.compiled import CompiledEngine, translation
from harness.installation import Installation, PlantSetup, build_plant, programs
from harness.kernel import NS_PER_MS

SCENARIOS = Path(__file__).parents[2] / "scenarios"
PLANT = SCENARIOS / "one_drive.yaml"


def built(plant: Path = PLANT, **settings: int) -> Installation:
    return build_plant(load_plant(plant), load_catalog(), PlantSetup(**settings))


@pytest.fixture
def next_process(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """Forget all programs, as a new process knows none."""

    def forget() -> None:
        monkeypatch.setattr(programs, "_programs", OrderedDict())
        monkeypatch.setattr(programs, "_kept", {})
        monkeypatch.setattr(translation, "_translations", OrderedDict())

    forget()
    return forget


def ran(plant: Installation) -> tuple[object, ...]:
    """What the variables hold after some scans, and the Python that has run."""
    engine = plant.cpu.engine
    assert isinstance(engine, CompiledEngine)
    plant.start()
    plant.kernel.run_for(300 * NS_PER_MS)
    blocks = sorted(block.name for block in engine.program.blocks.values())
    return engine.snapshot(), [engine.python_source(name) for name in blocks]


@pytest.mark.parametrize("plant", [PLANT, SCENARIOS / "one_drive_s7_300.yaml"])
def test_the_next_process_neither_reads_nor_translates_and_runs_the_same(
    next_process: Callable[[], None], monkeypatch: pytest.MonkeyPatch, plant: Path
) -> None:
    first = ran(built(plant))
    next_process()
    monkeypatch.setattr(programs, "read_program", lambda *_: pytest.fail("the program is kept"))
    monkeypatch.setattr(translation, "_translated", lambda *_: pytest.fail("its Python is kept"))
    assert ran(built(plant)) == first


def test_another_kind_of_controller_is_kept_beside_the_first(
    next_process: Callable[[], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    built()
    next_process()
    built(leftovers=1)
    next_process()
    monkeypatch.setattr(translation, "_translated", lambda *_: pytest.fail("both are kept"))
    built()
    built(leftovers=1)


def test_a_program_that_was_not_generated_is_not_kept(
    next_process: Callable[[], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    built()
    program = built().cpu.engine.program
    next_process()
    monkeypatch.setattr(programs.cache, "keep", lambda *_: pytest.fail("it has no key"))
    build_plant(load_plant(PLANT), load_catalog(), PlantSetup(program=program))
