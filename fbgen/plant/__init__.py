"""The plant file: what the user has, and which blocks are wanted for it."""

from fbgen.plant.commented import write_commented_plant
from fbgen.plant.families import FAMILIES, PLANT_DIALECTS, Family, PlantDialect, PlcFamily
from fbgen.plant.loading import load_plant, read_plant
from fbgen.plant.plant import Plant, PlantDrive, PlantGateway

__all__ = [
    "FAMILIES",
    "Family",
    "Plant",
    "PLANT_DIALECTS",
    "PlantDialect",
    "PlantDrive",
    "PlantGateway",
    "PlcFamily",
    "load_plant",
    "read_plant",
    "write_commented_plant",
]
