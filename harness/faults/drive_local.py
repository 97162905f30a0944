"""A drive is switched to local control at a terminal.

Run and stop come from the panel or the terminals then, whatever the network says. When it is
switched back, the command word is as it was written last.
"""

from functools import partial

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation.field_level import FieldLevel
from harness.installation.holds import switched


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    switch = plant.drives[on].switch_to_local
    hold = switched(plant.drives[on], "local", partial(switch, True), partial(switch, False))
    return Holding(plant, hold)


FAULT = FaultType("drive_local", "A drive is switched to local control", Target.DRIVE, _make)
