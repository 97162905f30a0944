"""The CPU is in STOP, so the master sends zeros (CLEAR)."""

from typing import Literal

from harness.faults.cpu_rest import Awakening, Rest, cpu_at_rest
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.plc import Restart


class StopSettings(FaultSettings):
    """How the CPU is started again: `restart` warm or cold, and which `data` it finds then.

    `initial`: initial values, in a warm restart in what is not retentive. `kept`: all as it was at
    the STOP.
    """

    restart: Literal["warm", "cold"] = "warm"
    data: Literal["initial", "kept"] = "initial"


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, StopSettings)
    awakening = Awakening(Restart(settings.restart), settings.data == "kept")
    return Holding(plant, cpu_at_rest(plant, Rest.STOPPED, awakening))


FAULT = FaultType(
    "cpu_stopped",
    "The CPU is in STOP, so the master sends zeros (CLEAR)",
    Target.WHOLE,
    _make,
    StopSettings,
)
