"""Transfers between CPU and DP master are torn between configuration identifiers, seeded.

Nothing is broken then: beyond one identifier no consistency is promised. Only the process image and
transfers of several identifiers at once can be torn this way.
"""

from typing import Annotated

from pydantic import Field

from fbgen.catalog.scalars import Real
from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class TearSettings(FaultSettings):
    """`probability` that a transfer that can be torn is torn."""

    probability: Annotated[Real, Field(gt=0, le=1)] = 1.0


class TransfersTorn:
    """A bus cycle falls between two identifiers of a transfer."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        assert isinstance(settings, TearSettings)
        self._link = plant.cpu.link
        self._probability = settings.probability

    def inject(self) -> None:
        """It begins."""
        self._link.set_tear_probability(self._probability)

    def clear(self) -> None:
        """It ends."""
        self._link.set_tear_probability(0.0)


FAULT = FaultType(
    "transfers_torn",
    "Transfers between CPU and master are torn between identifiers",
    Target.WHOLE,
    TransfersTorn,
    TearSettings,
)
