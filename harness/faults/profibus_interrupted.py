"""PROFIBUS is interrupted: nothing passes between master and slaves."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.master, "connected", False, min))


FAULT = FaultType(
    "profibus_interrupted",
    "PROFIBUS is interrupted: nothing passes between master and slaves",
    Target.WHOLE,
    _make,
)
