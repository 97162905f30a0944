"""Frames on the line behind a gateway are held up, as a converter or a radio link does, seeded.

From some byte on, drawn for each frame, the rest of it arrives later.
"""

from pydantic import Field

from harness.durations import PositiveDurationNs
from harness.faults.fault import Fault, FaultSettings, FaultType, Probability, Target
from harness.faults.holding import Holding
from harness.faults.line_pairs import Direction, pairs
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute
from harness.kernel import NS_PER_MS


class DelaySettings(FaultSettings):
    """`delay` of the late bytes, with this `probability` for each frame, in this `direction`."""

    delay: PositiveDurationNs = Field(
        default=10 * NS_PER_MS, json_schema_extra={"default": "10 ms"}
    )
    probability: Probability = 0.1
    direction: Direction = "both"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, DelaySettings)
    held = [pair.interference for pair in pairs(plant, on, settings.direction)]
    return Holding(
        plant,
        *(attribute(item, "delay_ns", settings.delay) for item in held),
        *(attribute(item.delays, "probability", settings.probability) for item in held),
    )


FAULT = FaultType(
    "line_bytes_delayed",
    "Bytes arrive late on the line behind a gateway",
    Target.LINE,
    _make,
    DelaySettings,
)
