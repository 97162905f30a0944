"""The emergency stop at the terminals of a drive is open.

It trips with E, and each reset is in vain as long as this lasts. Afterwards the trip stays until it
is reset (TOSPBDP001 manual v1.1, 7: the RES input as inverted EXTN).
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.drives[on], "emergency_terminal", True))


FAULT = FaultType(
    "drive_emergency_stop",
    "The emergency stop at the terminals of a drive is open",
    Target.DRIVE,
    _make,
)
