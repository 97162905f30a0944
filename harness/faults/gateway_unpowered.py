"""A gateway has no supply."""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import switched


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    gateway = plant.devices.device(on)
    return Holding(plant, switched(gateway, "supply", gateway.power_off, gateway.power_on))


FAULT = FaultType("gateway_unpowered", "A gateway has no supply", Target.GATEWAY, _make)
