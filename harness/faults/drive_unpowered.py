"""A drive has no supply."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation.field_level import FieldLevel
from harness.installation.holds import switched


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    drive = plant.drives[on]
    return Holding(plant, switched(drive, "supply", drive.power_off, drive.power_on))


FAULT = FaultType("drive_unpowered", "A drive has no supply", Target.DRIVE, _make)
