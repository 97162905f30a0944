"""The plant file: what the user has, and which blocks are wanted for it."""

from fbgen.plant.changing import in_dialect, problems_of
from fbgen.plant.commented import write_commented_plant
from fbgen.plant.families import FAMILIES, LANGUAGES, Family, PlantDialect, PlcFamily
from fbgen.plant.loading import load_plant, read_plant
from fbgen.plant.plant import HIGHEST_BLOCK, BlockNumbers, Plant, PlantDrive, PlantGateway

__all__ = [
    "BlockNumbers",
    "FAMILIES",
    "Family",
    "HIGHEST_BLOCK",
    "LANGUAGES",
    "Plant",
    "PlantDialect",
    "PlantDrive",
    "PlantGateway",
    "PlcFamily",
    "in_dialect",
    "load_plant",
    "problems_of",
    "read_plant",
    "write_commented_plant",
]
