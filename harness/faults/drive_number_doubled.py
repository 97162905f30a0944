"""Two drives with one number: this one has that of another on its line, and not its own.

Both obey what is sent to that number and both answer, so their replies may collide; nobody answers
to the number that is missing (TOSPBDP001 manual v1.1, 6: numbers must be unique).
"""

from fbgen.catalog.scalars import Text
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.neighbours import neighbour
from harness.faults.on_a_line import require_telegrams
from harness.installation.field_level import FieldLevel
from harness.installation.holds import Hold


class NumberSettings(FaultSettings):
    """`other` is the drive whose number it has; the first other one of its line if not said."""

    other: Text | None = None


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    """FB7520 if there is no such drive on its line, FB7522 on DeviceNet."""
    assert isinstance(settings, NumberSettings)
    require_telegrams(plant, on, "drives have no inverter numbers")
    number: int | None = neighbour(plant, on, settings.other).inv_no
    port = plant.drives[on].communication

    def present() -> int | None:
        return port.foreign_number

    def put(given: int | None) -> None:
        port.foreign_number = given

    return Holding(plant, Hold((port, "foreign_number"), number, present, put))


FAULT = FaultType(
    "drive_number_doubled",
    "A drive has the number of another one on its line",
    Target.DRIVE,
    _make,
    NumberSettings,
)
