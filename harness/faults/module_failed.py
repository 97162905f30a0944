"""The communication module of a serial line does not answer the CPU; what it hears, it keeps."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.devices.modules[on], "failed", True))


FAULT = FaultType(
    "module_failed",
    "The communication module of a serial line does not answer the CPU",
    Target.MODULE,
    _make,
)
