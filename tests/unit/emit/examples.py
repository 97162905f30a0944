"""The examples as they are generated for a dialect, reached through the process image."""

from functools import cache
from pathlib import Path

from fbgen.catalog import load_catalog
from fbgen.emit.generated import GeneratedFile
from fbgen.emit.generator import generate
from fbgen.plant import in_dialect, load_plant

EXAMPLES = Path(__file__).parents[3] / "examples"


@cache
def generated(example: str, dialect: str) -> tuple[GeneratedFile, ...]:
    """The files of an example, whose access every dialect has."""
    catalog = load_catalog()
    plant = load_plant(EXAMPLES / example / "plant.yaml", catalog)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in plant.gateways)
    changed = plant.model_copy(update={"gateways": gateways})
    return generate(in_dialect(changed, dialect, catalog), catalog).files
