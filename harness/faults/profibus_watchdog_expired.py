"""The DP watchdog of a gateway expires although the master polls it.

Telegrams were lost for longer than the watchdog time. The gateway clears its outputs and is offline
until the master has sent parameters and configuration again, which it does at once.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Event
from harness.installation import Installation


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Event(plant.stations[on].slave.let_watchdog_expire)


FAULT = FaultType(
    "profibus_watchdog_expired", "The DP watchdog of a gateway expires", Target.GATEWAY, _make
)
