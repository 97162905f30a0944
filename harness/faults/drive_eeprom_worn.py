"""The EEPROM of a drive is worn out: writes to it are refused with 0000, those to RAM are not.

VF-AS1 RS485 manual E6581315, page 20: impossible to execute, EEPROM faulty.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.drives[on].registers, "eeprom_faulty", True))


FAULT = FaultType("drive_eeprom_worn", "The EEPROM of a drive is worn out", Target.DRIVE, _make)
