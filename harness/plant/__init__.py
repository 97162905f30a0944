"""The whole simulated plant, from a plant file and PLC text.

installation = plant("plant.yaml", PlantSetup(seed=1))
installation.start()
installation.run_for(2 * NS_PER_S)
assert installation.drives["pump"].running
"""

from harness.plant.building import build_plant, plant
from harness.plant.installation import Installation
from harness.plant.programs import generated_program, generated_sources
from harness.plant.setup import DriveConditions, PlantSetup

__all__ = [
    "DriveConditions",
    "Installation",
    "PlantSetup",
    "build_plant",
    "generated_program",
    "generated_sources",
    "plant",
]
