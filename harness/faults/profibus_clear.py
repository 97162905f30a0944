"""The master stays in CLEAR although the CPU is in RUN: every slave gets zeros.

So a master with Auto_Clear does when one of its slaves has failed (EN 50170 volume 2).
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.master, "clear_forced", True))


FAULT = FaultType(
    "profibus_clear", "The DP master sends zeros (CLEAR) with the CPU in RUN", Target.WHOLE, _make
)
