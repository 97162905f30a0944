"""A drive answers with the number of another one in its replies."""

from fbgen.catalog.scalars import Text
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.neighbours import neighbour
from harness.faults.on_a_line import require_telegrams
from harness.installation.field_level import FieldLevel
from harness.installation.holds import Hold


class AnotherSettings(FaultSettings):
    """`other` is the drive whose number it gives; the first other one of its line if not said."""

    other: Text | None = None


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    """FB7520 if there is no such drive on its line, FB7522 on DeviceNet."""
    assert isinstance(settings, AnotherSettings)
    require_telegrams(plant, on, "drives have no inverter numbers")
    number: int | None = neighbour(plant, on, settings.other).inv_no
    port = plant.drives[on].communication

    def present() -> int | None:
        return port.reply_number

    def put(given: int | None) -> None:
        port.reply_number = given

    return Holding(plant, Hold((port, "reply_number"), number, present, put))


FAULT = FaultType(
    "drive_answers_for_another",
    "A drive answers with the number of another",
    Target.DRIVE,
    _make,
    AnotherSettings,
)
