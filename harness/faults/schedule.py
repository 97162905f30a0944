"""A schedule of faults: an explicit list of events, each with its instant, that can be replayed."""

from collections.abc import Iterable
from typing import NamedTuple

from harness.faults.fault import Fault
from harness.installation import Installation

Setting = bool | int | float | str


class FaultEvent(NamedTuple):
    """One fault. `at_ns` counts from the start of the plant; `lasts_ns` None is to the end.

    `on` is "" for the whole plant. `settings` are as they are written in a scenario.
    """

    at_ns: int
    lasts_ns: int | None
    name: str
    on: str
    settings: tuple[tuple[str, Setting], ...] = ()

    @property
    def end_ns(self) -> int:
        """When it is over; the beginning for what has no end."""
        return self.at_ns + (self.lasts_ns or 0)

    def __str__(self) -> str:
        place = f" on {self.on}" if self.on else ""
        lasts = "" if self.lasts_ns is None else f" for {self.lasts_ns / 1e6:g} ms"
        return f"{self.name}{place} at {self.at_ns / 1e6:g} ms{lasts}"


def arm(plant: Installation, events: Iterable[tuple[FaultEvent, Fault]]) -> None:
    """Let the faults come at their instants, counted from now."""
    start_ns = plant.kernel.now_ns
    for event, fault in events:
        plant.kernel.at(start_ns + event.at_ns, fault.inject)
        if event.lasts_ns is not None:
            plant.kernel.at(start_ns + event.end_ns, fault.clear)
