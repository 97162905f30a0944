"""The option of a drive goes off the bus: its CAN chip has counted too many errors.

It stays off until its supply was away, or until somebody resets it, which ends the fault; unless
attribute 3 of the DeviceNet object says otherwise.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.option_restart import reset_when_over
from harness.installation import Installation
from harness.installation.holds import switched


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    option = plant.options[on]
    off = switched(option, "bus off", option.node.bus_off, lambda: None)
    return Holding(plant, off, reset_when_over(option))


FAULT = FaultType(
    "devicenet_bus_off", "The option of a drive on DeviceNet goes bus-off", Target.OPTION, _make
)
