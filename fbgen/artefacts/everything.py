"""All files beside the PLC text of a plant."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from fbgen.artefacts.alarm_lists import alarm_lists
from fbgen.artefacts.hmi_tags import hmi_tags
from fbgen.artefacts.memory import too_large, work_memory
from fbgen.artefacts.parameter_sheets import parameter_sheets
from fbgen.artefacts.plc_tags import plc_tags
from fbgen.artefacts.readme import readme
from fbgen.artefacts.view import PlantLists
from fbgen.artefacts.watch_tables import watch_tables
from fbgen.blocks.texts import texts_in
from fbgen.catalog import Catalog
from fbgen.emit.generated import GeneratedSet
from fbgen.lang.collector import collector_at_rest
from fbgen.plant import Plant


@collector_at_rest()
def with_artefacts(
    generated: GeneratedSet, plant: Plant, catalog: Catalog, templates: Sequence[Path] = ()
) -> GeneratedSet:
    """What `fbgen.emit.generate` has made of a plant, with the files beside it."""
    texts = texts_in(plant.language, templates)
    lists = PlantLists(plant, texts.in_catalog(catalog), generated, plant.language, texts)
    memory = work_memory(lists)
    found = [
        *plc_tags(lists),
        *hmi_tags(lists),
        *alarm_lists(lists),
        *watch_tables(lists),
        *parameter_sheets(lists),
    ]
    found.append(readme(lists, memory, found, templates))
    warnings = (*generated.warnings, *too_large(lists, memory))
    return replace(generated, artefacts=tuple(found), warnings=warnings)
