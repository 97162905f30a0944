"""A gateway reports a diagnosis of its own (Ext_Diag) and goes on exchanging data."""

from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class GatewayDiagnosis:
    """A gateway reports a diagnosis of its own and goes on exchanging data."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._slave = plant.gateways[on].slave

    def inject(self) -> None:
        """It begins."""
        self._slave.set_ext_diag(True)

    def clear(self) -> None:
        """It ends."""
        self._slave.set_ext_diag(False)


FAULT = FaultType(
    "gateway_diagnosis",
    "A gateway reports a diagnosis of its own and goes on exchanging data",
    Target.GATEWAY,
    GatewayDiagnosis,
)
