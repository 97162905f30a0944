"""Some replies of a drive come late, when nobody waits for them any more, seeded."""

from pydantic import Field

from harness.durations import PositiveDurationNs
from harness.faults.fault import Fault, FaultSettings, FaultType, Probability, Target
from harness.faults.holding import Holding
from harness.faults.on_a_line import require_telegrams
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute
from harness.kernel import NS_PER_MS


class LateSettings(FaultSettings):
    """With this `probability` a reply comes `delay` later than otherwise."""

    delay: PositiveDurationNs = Field(
        default=100 * NS_PER_MS, json_schema_extra={"default": "100 ms"}
    )
    probability: Probability = 0.2


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, LateSettings)
    require_telegrams(plant, on, "no telegrams are answered")
    port = plant.drives[on].communication
    return Holding(
        plant,
        attribute(port, "late_ns", settings.delay),
        attribute(port.late_replies, "probability", settings.probability),
    )


FAULT = FaultType(
    "drive_answers_late", "Some replies of a drive come late", Target.DRIVE, _make, LateSettings
)
