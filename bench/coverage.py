"""The yardstick plant with statement, branch and MC/DC coverage and the watch on the catalogue."""

from collections.abc import Iterator
from pathlib import Path

from bench.measuring import Figure, measure
from harness.installation import PlantSetup, plant
from harness.kernel import NS_PER_S
from harness.verify.coverage import Coverage, watch

_PLANT = Path(__file__).parents[1] / "examples" / "five_drives" / "plant.yaml"
_WARM_UP_NS = 3 * NS_PER_S


def figures() -> Iterator[Figure]:
    """How long a second of the plant takes with all kinds of coverage."""
    coverage = Coverage()
    installation = plant(_PLANT, PlantSetup(probes=(coverage,)))
    watch(installation, coverage.catalogue)
    installation.start()
    installation.run_for(_WARM_UP_NS)
    second = measure("", lambda: installation.run_for(NS_PER_S), windows=300)
    limit = f"{1 / second.seconds:.0f} times real time, at least 50"
    yield Figure("1 s of the yardstick plant with coverage", second.seconds, second.turns, limit)
