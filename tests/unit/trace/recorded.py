"""Plants of the tests, recorded."""

from collections.abc import Callable

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS
from harness.trace import Recorder, Trace
from tests.unit.scenario.scenario_files import PLANT

CATALOG = load_catalog()
START = "TOS_Plant.gw1.pump.start_forward"


def one_drive(seed: int = 0, engine: str = "compiled") -> Installation:
    """Gateway gw1 with the drive pump, switched off."""
    return build_plant(load_plant(PLANT, CATALOG), CATALOG, PlantSetup(seed, engine))


def started(plant: Installation, recorder: Recorder) -> None:
    """On, and after 100 ms the drive is started with 40 Hz, which takes 300 ms."""
    plant.start()
    plant.run_for(100 * NS_PER_MS)
    plant.cpu.engine.set_global(f"{START}.frequency", 40.0)
    plant.cpu.engine.set_global(f"{START}.execute", True)
    recorder.variables_written()
    plant.run_for(300 * NS_PER_MS)


def traced(
    does: Callable[[Installation, Recorder], None] = started,
    seed: int = 0,
    engine: str = "compiled",
) -> Trace:
    """What is left of a run of the plant with one drive."""
    plant = one_drive(seed, engine)
    recorder = plant.record()
    does(plant, recorder)
    return recorder.finish("Start forward", "start.scenario.yaml")
