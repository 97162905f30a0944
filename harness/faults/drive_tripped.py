"""A drive trips. Clearing it takes the cause away; the trip stays until it is reset."""

from fbgen.catalog.scalars import Text
from harness.faults.fault import FaultSettings, FaultType, Target
from harness.installation import Installation


class TripSettings(FaultSettings):
    """`display` is what the panel shows, such as OC1."""

    display: Text = "OC1"


class DriveTripped:
    """A trip of one drive. FB7102 for a display that its series does not have."""

    def __init__(self, plant: Installation, on: str, settings: FaultSettings) -> None:
        assert isinstance(settings, TripSettings)
        self._drive = plant.drives[on]
        self._display = settings.display
        self._drive.trips.code_of(settings.display)

    def inject(self) -> None:
        """The trip comes."""
        self._drive.trip(self._display)

    def clear(self) -> None:
        """The cause is gone; a trip is latched, so nothing else changes."""


FAULT = FaultType(
    "drive_tripped",
    "A drive trips, by what its panel shows",
    Target.DRIVE,
    DriveTripped,
    TripSettings,
)
