"""A drive trips. Clearing it takes the cause away; the trip stays until it is reset."""

from functools import partial

from fbgen.catalog.scalars import Text
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Event
from harness.installation.field_level import FieldLevel


class TripSettings(FaultSettings):
    """`display` is what the panel shows, such as OC1."""

    display: Text = "OC1"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    """FB7102 for a display that the series of the drive does not have."""
    assert isinstance(settings, TripSettings)
    drive = plant.drives[on]
    drive.trips.code_of(settings.display)
    return Event(partial(drive.trip, settings.display))


FAULT = FaultType(
    "drive_tripped",
    "A drive trips, by what its panel shows",
    Target.DRIVE,
    _make,
    TripSettings,
)
