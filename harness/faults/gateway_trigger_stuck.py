"""A gateway does not see that the trigger byte changes, so it sends nothing but its heartbeat.

Afterwards it sends what lies there if the trigger is another one than before.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Holding(plant, attribute(plant.gateways[on], "trigger_stuck", True))


FAULT = FaultType(
    "gateway_trigger_stuck", "A gateway does not see the trigger", Target.TELEGRAMS, _make
)
