"""Plants of the tests, recorded."""

from collections.abc import Callable, Sequence

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from harness.engine.compiled import ProbeMaker
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS
from harness.trace import Recorder, Trace
from tests.unit.scenario.scenario_files import PLANT

CATALOG = load_catalog()
START = "TOS_Plant.gw1.pump.start_forward"


def one_drive(
    seed: int = 0, engine: str = "compiled", probes: Sequence[ProbeMaker] = (), **changes: object
) -> Installation:
    """Gateway gw1 with the drive pump, switched off; `changes` are those of the gateway."""
    plan = load_plant(PLANT, CATALOG)
    gateway = plan.gateways[0].model_copy(update=changes)
    plan = plan.model_copy(update={"gateways": (gateway,)})
    return build_plant(plan, CATALOG, PlantSetup(seed, engine, probes=probes))


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
