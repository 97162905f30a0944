"""The whole simulated plant, from a plant file and PLC text.

Switched on, two seconds later:

    installation = plant("plant.yaml", PlantSetup(seed=1))
    installation.start()
    installation.run_for(2 * NS_PER_S)
    assert installation.drives["pump"].running
"""

from harness.installation.building import build_plant, plant
from harness.installation.conditions import without_effect
from harness.installation.devices import FieldDevices, build_devices
from harness.installation.plant import Installation
from harness.installation.programs import generated_program, generated_sources
from harness.installation.setup import DriveConditions, PlantSetup

__all__ = [
    "DriveConditions",
    "FieldDevices",
    "Installation",
    "PlantSetup",
    "build_devices",
    "build_plant",
    "generated_program",
    "generated_sources",
    "plant",
    "without_effect",
]
