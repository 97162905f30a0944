"""A drive has a cause for an alarm: it shows it (FC91, alarm bit of its status) and goes on."""

from functools import reduce
from operator import or_

from fbgen.catalog.scalars import Text
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation.field_level import FieldLevel
from harness.installation.holds import attribute


class AlarmSettings(FaultSettings):
    """`alarm` is the catalogue's name of a bit of the alarm word."""

    alarm: Text = "overheat"


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    """FB1202 for an alarm that the series of the drive does not have."""
    assert isinstance(settings, AlarmSettings)
    drive = plant.drives[on]
    mask = drive.series.word("alarm").field(settings.alarm).mask
    hold = attribute(drive.monitors, "alarm", mask, lambda masks: reduce(or_, masks))
    return Holding(plant, hold)


FAULT = FaultType(
    "drive_alarm", "A drive shows an alarm and goes on", Target.DRIVE, _make, AlarmSettings
)
"""Several of them are shown together."""
