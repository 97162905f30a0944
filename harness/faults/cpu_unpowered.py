"""The CPU has no supply, and the DP master with it: silence on the bus. Then a warm restart."""

from harness.faults.cpu_rest import Rest, cpu_at_rest
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, cpu_at_rest(plant, Rest.UNPOWERED))


FAULT = FaultType("cpu_unpowered", "The CPU has no supply", Target.WHOLE, _make)
