"""A gateway reports a diagnosis of its own (Ext_Diag) and goes on exchanging data."""

from functools import partial

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import switched


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    slave = plant.stations[on].slave
    begin, end = partial(slave.set_ext_diag, True), partial(slave.set_ext_diag, False)
    return Holding(plant, switched(slave, "diagnosis", begin, end))


FAULT = FaultType(
    "gateway_diagnosis",
    "A gateway reports a diagnosis of its own and goes on exchanging data",
    Target.TELEGRAMS,
    _make,
)
