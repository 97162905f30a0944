"""A gateway takes longer for each telegram, in both directions. Its manual says about 5 ms (9)."""

from pydantic import Field

from harness.durations import PositiveDurationNs
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import setting
from harness.kernel import NS_PER_MS


class SlowSettings(FaultSettings):
    """`processing_time` for each direction."""

    processing_time: PositiveDurationNs = Field(
        default=20 * NS_PER_MS, json_schema_extra={"default": "20 ms"}
    )


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, SlowSettings)
    return Holding(plant, setting(plant.gateways[on], "processing_ns", settings.processing_time))


FAULT = FaultType(
    "gateway_slow", "A gateway takes long for each telegram", Target.TELEGRAMS, _make, SlowSettings
)
