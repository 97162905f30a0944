"""The scanner is idle although the CPU runs: it polls without data, as with its mode bit at idle.

Inputs come as before. Drives go on as they were told last, and their connections do not time out.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.networks[on].scanner, "held_idle", True))


FAULT = FaultType(
    "devicenet_scanner_idle",
    "The scanner of a DeviceNet network polls without data",
    Target.NETWORK,
    _make,
)
