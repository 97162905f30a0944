"""A DeviceNet network is interrupted: nothing passes between scanner and drives."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.networks[on].trunk, "plugged", False, min))


FAULT = FaultType(
    "devicenet_interrupted",
    "A DeviceNet network is interrupted: nothing passes between scanner and drives",
    Target.NETWORK,
    _make,
)
