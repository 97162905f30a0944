"""Faults that a scenario can inject, one file each; each file ends with its `FAULT`."""

from collections.abc import Mapping
from types import MappingProxyType

from harness.faults import (
    cpu_stopped,
    drive_local,
    drive_tripped,
    drive_unpowered,
    gateway_diagnosis,
    gateway_unpowered,
    line_broken,
    line_noise,
    profibus_interrupted,
    transfers_torn,
)
from harness.faults.fault import Fault, FaultSettings, FaultType, Target

__all__ = ["FAULTS", "Fault", "FaultSettings", "FaultType", "Target"]

_MODULES = (
    cpu_stopped,
    drive_local,
    drive_tripped,
    drive_unpowered,
    gateway_diagnosis,
    gateway_unpowered,
    line_broken,
    line_noise,
    profibus_interrupted,
    transfers_torn,
)

FAULTS: Mapping[str, FaultType] = MappingProxyType(
    {item.FAULT.name: item.FAULT for item in _MODULES}
)
"""By the name that scenarios use."""
