"""The DP master has stopped, as a communication processor in STOP does: it sends nothing.

Its slaves are left to their watchdogs. The CPU goes on and finds no station. Afterwards the master
begins anew with parameters and configuration.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import switched


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    master = plant.master
    return Holding(plant, switched(master, "halted", master.halt, master.resume))


FAULT = FaultType(
    "master_stopped", "The DP master has stopped and sends nothing", Target.WHOLE, _make
)
