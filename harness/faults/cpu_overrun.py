"""Each scan of the CPU takes longer than its cycle.

A scan that takes longer than the cycle monitoring time, 150 ms, stops the CPU, or calls its OB80.
"""

from pydantic import Field

from harness.durations import PositiveDurationNs
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import setting
from harness.kernel import NS_PER_MS


class OverrunSettings(FaultSettings):
    """`execution_time` of each scan."""

    execution_time: PositiveDurationNs = Field(
        default=50 * NS_PER_MS, json_schema_extra={"default": "50 ms"}
    )


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, OverrunSettings)
    return Holding(plant, setting(plant.cpu, "execution_ns", settings.execution_time))


FAULT = FaultType(
    "cpu_overrun", "The scans of the CPU are too long", Target.WHOLE, _make, OverrunSettings
)
