"""The MAC ID of a drive is doubled: another node had it first when the option was switched on.

The option begins anew and finds its MAC ID taken, so it stays off the network (DEV003Z-1 manual
E6581737, page 8: NS red). When the other node is gone, the option is switched off and on.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.option_restart import reset_when_over
from harness.installation import Installation
from harness.installation.holds import attribute, switched


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    option = plant.options[on]
    network = next(one for one in plant.networks.values() if on in one.options)

    def restart() -> None:
        if option.powered:
            option.node.restart()

    return Holding(
        plant,
        attribute(network.strangers[on].port, "plugged", True),
        switched(option, "begins beside it", restart, lambda: None),
        reset_when_over(option),
    )


FAULT = FaultType(
    "devicenet_mac_doubled",
    "Another node on the DeviceNet network has the MAC ID of a drive",
    Target.OPTION,
    _make,
)
