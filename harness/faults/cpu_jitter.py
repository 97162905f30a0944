"""The cycle time of the CPU jitters: each scan takes up to so much longer, drawn by the seed."""

from pydantic import Field

from harness.durations import PositiveDurationNs
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import setting
from harness.kernel import NS_PER_MS


class CpuJitterSettings(FaultSettings):
    """`up_to` is how much longer a scan takes at most."""

    up_to: PositiveDurationNs = Field(default=5 * NS_PER_MS, json_schema_extra={"default": "5 ms"})


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, CpuJitterSettings)
    return Holding(plant, setting(plant.cpu, "execution_jitter_ns", settings.up_to))


FAULT = FaultType(
    "cpu_jitter", "The cycle time of the CPU jitters", Target.WHOLE, _make, CpuJitterSettings
)
