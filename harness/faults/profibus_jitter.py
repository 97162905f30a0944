"""The cycle of the DP master jitters: each poll comes up to so much later."""

from dataclasses import replace

from pydantic import Field

from harness.durations import PositiveDurationNs
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute
from harness.kernel import NS_PER_MS


class BusJitterSettings(FaultSettings):
    """`up_to` is the largest delay; it is less than one cycle of the bus."""

    up_to: PositiveDurationNs = Field(default=NS_PER_MS, json_schema_extra={"default": "1 ms"})


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    """FB7201 for a jitter that is not less than one cycle."""
    assert isinstance(settings, BusJitterSettings)
    times = replace(plant.master.times, jitter_ns=settings.up_to)
    return Holding(plant, attribute(plant.master, "jitter_ns", times.jitter_ns))


FAULT = FaultType(
    "profibus_jitter",
    "The cycle of the DP master jitters, drawn by the seed",
    Target.WHOLE,
    _make,
    BusJitterSettings,
)
