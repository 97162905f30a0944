"""Transfers between CPU and DP master are torn between configuration identifiers, seeded.

Nothing is broken then: beyond one identifier no consistency is promised. Only the process image and
transfers of several identifiers at once can be torn this way.
"""

from harness.faults.fault import Fault, FaultSettings, FaultType, Probability, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute


class TearSettings(FaultSettings):
    """`probability` that a transfer that can be torn is torn."""

    probability: Probability = 1.0


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, TearSettings)
    return Holding(plant, attribute(plant.cpu.link, "tear_probability", settings.probability))


FAULT = FaultType(
    "transfers_torn",
    "Transfers between CPU and master are torn between identifiers",
    Target.WHOLE,
    _make,
    TearSettings,
)
