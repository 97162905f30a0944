"""The plants that are shipped, whose blocks a site without a plant is about."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Literal

from fbgen.catalog import Catalog, with_own_sequences
from fbgen.docs.program import PlantProgram, read_program
from fbgen.emit.generator import generate
from fbgen.plant import changed, load_plant
from fbgen.resources import shipped

Language = Literal["en", "de"]
"""What comments, titles and trips are written in, as far as they are translated."""
EXAMPLES = ("five_drives", "manual_example", "pbdp110", "serial", "modbus", "devicenet")
"""The first that has a block is the one that its page is about."""


def example_programs(
    catalog: Catalog, templates: Sequence[Path] = (), language: Language = "en"
) -> Iterator[PlantProgram]:
    """Each generated and read. Raises DiagnosticError where one cannot be generated any more, with
    a catalogue or templates of the user's own."""
    for name in EXAMPLES:
        path = shipped("examples") / name / "plant.yaml"
        plant = load_plant(path, with_own_sequences(catalog, path.parent))
        if plant.language != language:
            plant = changed(plant, catalog, language=language)
        yield read_program(plant, generate(plant, catalog, templates))
