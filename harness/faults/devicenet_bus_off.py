"""The option of a drive goes off the bus: its CAN chip has counted too many errors.

It stays off until its supply was away, unless attribute 3 of the DeviceNet object says otherwise.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Event
from harness.installation import Installation


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    return Event(plant.options[on].node.bus_off)


FAULT = FaultType(
    "devicenet_bus_off", "The option of a drive on DeviceNet goes bus-off", Target.OPTION, _make
)
