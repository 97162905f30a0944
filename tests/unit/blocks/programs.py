"""The generated text of small plants, loaded into an engine, and frames as bytes."""

from functools import cache
from pathlib import Path
from typing import Any

from fbgen.catalog import Catalog, load_catalog
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.plant import read_plant
from fbgen.source import Source
from harness import LoadedProgram, load_program

EXAMPLES = Path(__file__).parents[3] / "examples"

FIVE_DRIVES = (EXAMPLES / "five_drives" / "plant.yaml").read_text("utf-8")
MANUAL_EXAMPLE = (EXAMPLES / "manual_example" / "plant.yaml").read_text("utf-8")
ALL_SEQUENCES = FIVE_DRIVES.replace("sequences:\n", "sequences:\n  - manual_example\n")
"""The plant with five drives, and the manual's example among its sequences."""


@cache
def shipped_catalog() -> Catalog:
    """The catalogue as shipped, read once."""
    return load_catalog()


@cache
def generated(plant_text: str) -> GeneratedSet:
    """What is generated for a plant file of this text."""
    plant = read_plant(Source("plant.yaml", plant_text), shipped_catalog())
    return generate(plant, shipped_catalog())


@cache
def loaded(plant_text: str, engine: str) -> LoadedProgram:
    """The generated text on an engine. Tests share it: each makes instances of its own."""
    files = generated(plant_text).files
    return load_program([Source(file.name, file.text) for file in files], engine=engine)


def block(program: LoadedProgram, name: str) -> Any:
    """A block with its own state. Its variables have the types of the PLC text."""
    return program.instance(name)


def octets(*fields: tuple[int, int]) -> str:
    """Fields (value, number of bytes) as the manuals print them: `E0 00 01 0B`."""
    return b"".join(value.to_bytes(size, "big") for value, size in fields).hex(" ").upper()
