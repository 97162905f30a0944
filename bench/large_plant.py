"""One PLC with ten gateways and fifty drives, all polled: how much faster than the plant itself.

The five drives of `examples/five_drives` ten times, on one PROFIBUS. 20 times real time is 50 ms.
"""

from collections.abc import Iterator
from pathlib import Path

from bench.measuring import Figure, measure
from fbgen.catalog import load_catalog
from fbgen.plant import PlantGateway, load_plant
from harness.installation import PlantSetup, build_plant
from harness.kernel import NS_PER_S

_PLANT = Path(__file__).parents[1] / "examples" / "five_drives" / "plant.yaml"
_GATEWAYS = 10
_BYTES_APART = 16
_WARM_UP_NS = 3 * NS_PER_S


def figures() -> Iterator[Figure]:
    """How long a second of the large plant takes."""
    catalog = load_catalog()
    plan = load_plant(_PLANT, catalog)
    (gateway,) = plan.gateways
    gateways = tuple(_copy(gateway, number) for number in range(_GATEWAYS))
    large = plan.model_copy(update={"gateways": gateways})
    installation = build_plant(large, catalog, PlantSetup())
    installation.start()
    installation.run_for(_WARM_UP_NS)
    second = measure("", lambda: installation.run_for(NS_PER_S), windows=50)
    limit = f"{1 / second.seconds:.0f} times real time, at least 20"
    yield Figure("1 s of 10 gateways with 50 drives", second.seconds, second.turns, limit)


def _copy(gateway: PlantGateway, number: int) -> PlantGateway:
    drives = tuple(
        drive.model_copy(update={"name": f"{drive.name}_{number}"}) for drive in gateway.drives
    )
    shifted = _BYTES_APART * number
    return gateway.model_copy(
        update={
            "name": f"gw{number}",
            "profibus_address": gateway.profibus_address + number,
            "input_address": (gateway.input_address or 0) + shifted,
            "output_address": (gateway.output_address or 0) + shifted,
            "drives": drives,
        }
    )
