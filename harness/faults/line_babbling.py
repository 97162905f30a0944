"""Something on the line behind a gateway sends unasked: bytes at random times, seeded."""

from typing import Annotated

from pydantic import Field

from fbgen.catalog.scalars import Count
from harness.durations import PositiveDurationNs
from harness.faults.fault import FaultSettings, FaultType, Target
from harness.faults.line_pairs import Direction, pairs
from harness.installation.field_level import FieldLevel
from harness.kernel import NS_PER_MS, Event
from harness.line import DRIVE_FORMAT


class BabblingSettings(FaultSettings):
    """After a pause of up to twice `pause` come up to `longest` bytes, in this `direction`."""

    pause: PositiveDurationNs = Field(
        default=50 * NS_PER_MS, json_schema_extra={"default": "50 ms"}
    )
    longest: Annotated[Count, Field(ge=1, le=256)] = 16
    direction: Direction = "from_drives"


class LineBabbling:
    """Each of several such faults is a sender of its own."""

    def __init__(self, plant: FieldLevel, on: str, settings: FaultSettings) -> None:
        assert isinstance(settings, BabblingSettings)
        self._kernel = plant.kernel
        self._pairs = pairs(plant, on, settings.direction)
        self._settings = settings
        self._event: Event | None = None

    def inject(self) -> None:
        """It begins to send."""
        self._wait()

    def clear(self) -> None:
        """It is taken off the line."""
        if self._event is not None:
            self._kernel.cancel(self._event)
            self._event = None

    def _wait(self) -> None:
        pause_ns = self._kernel.random.randrange(2 * self._settings.pause) + 1
        self._event = self._kernel.after(pause_ns, self._send)

    def _send(self) -> None:
        random = self._kernel.random
        data = random.randbytes(random.randrange(self._settings.longest) + 1)
        sent = [pair.inject(data, DRIVE_FORMAT) for pair in dict.fromkeys(self._pairs)]
        pause_ns = random.randrange(2 * self._settings.pause) + 1
        self._event = self._kernel.at(sent[0].end_ns + pause_ns, self._send)


FAULT = FaultType(
    "line_babbling",
    "Something on the line behind a gateway sends without being asked",
    Target.LINE,
    LineBabbling,
    BabblingSettings,
)
