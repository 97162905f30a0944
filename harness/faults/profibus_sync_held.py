"""Global_Control Sync was sent and Unsync does not follow: the outputs of all gateways stay.

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
    begin = partial(command, ControlCommand.SYNC)
    return Holding(
        plant, switched(plant.master, "sync", begin, partial(command, ControlCommand.UNSYNC))
    )


FAULT = FaultType(
    "profibus_sync_held",
    "The outputs of all gateways are held (Sync without Unsync)",
    Target.WHOLE,
    _make,
)
