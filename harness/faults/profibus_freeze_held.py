"""Global_Control Freeze was sent and Unfreeze does not follow: the inputs of all gateways stay.

A gateway that starts data exchange anew meanwhile is out of it.
"""

from functools import partial

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.fieldbus import ControlCommand
from harness.installation import Installation
from harness.installation.holds import switched


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    command = plant.master.global_control
    begin = partial(command, ControlCommand.FREEZE)
    return Holding(
        plant, switched(plant.master, "freeze", begin, partial(command, ControlCommand.UNFREEZE))
    )


FAULT = FaultType(
    "profibus_freeze_held",
    "The inputs of all gateways are held (Freeze without Unfreeze)",
    Target.WHOLE,
    _make,
)
