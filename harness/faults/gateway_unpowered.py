"""A gateway has no supply."""

from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class GatewayUnpowered:
    """A gateway has no supply."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._plant = plant
        self._on = on

    def inject(self) -> None:
        """It begins."""
        self._plant.gateways[self._on].power_off()

    def clear(self) -> None:
        """It ends."""
        self._plant.gateways[self._on].power_on()


FAULT = FaultType("gateway_unpowered", "A gateway has no supply", Target.GATEWAY, GatewayUnpowered)
