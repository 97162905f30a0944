"""The parameters of a drive are locked: writes are refused with 0000, commands are obeyed.

VF-AS1 RS485 manual E6581315, page 20: impossible to execute.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.drives[on].registers, "locked", True))


FAULT = FaultType(
    "drive_parameters_locked", "The parameters of a drive are locked", Target.DRIVE, _make
)
