"""The bus plug of one gateway is pulled; the others go on."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.stations[on], "plugged", False, min))


FAULT = FaultType(
    "profibus_plug_pulled", "The PROFIBUS plug of a gateway is pulled", Target.GATEWAY, _make
)
