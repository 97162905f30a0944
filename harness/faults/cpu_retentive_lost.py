"""The CPU has no supply and loses its retentive data, as with an empty battery.

Then a warm restart, with initial values everywhere.
"""

from harness.faults.cpu_rest import Rest, cpu_at_rest
from harness.faults.fault import FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation


class RetentiveLost:
    """The supply is a hold like others; the loss happens once, when it begins."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        self._cpu = plant.cpu
        self._unpowered = Holding(plant, cpu_at_rest(plant, Rest.UNPOWERED))

    def inject(self) -> None:
        """The supply goes, the data with it."""
        self._unpowered.inject()
        self._cpu.at_checkpoint(self._cpu.lose_retentive)

    def clear(self) -> None:
        """The supply is back."""
        self._unpowered.clear()


FAULT = FaultType(
    "cpu_retentive_lost",
    "The CPU has no supply and loses its retentive data",
    Target.WHOLE,
    RetentiveLost,
)
