"""A fault that holds parts of the plant away from their healthy values while it lasts."""

from collections.abc import Callable
from typing import Any

from harness.installation.field_level import FieldLevel
from harness.installation.holds import Hold


class Holding:
    """Several of them at once, at one place or at different ones, get along with each other."""

    def __init__(self, plant: FieldLevel, *holds: Hold[Any]) -> None:
        self._plant = plant
        self._holds = tuple({hold.key: hold for hold in holds}.values())

    def inject(self) -> None:
        """It begins."""
        for hold in self._holds:
            self._plant.holds.take(self, hold)

    def clear(self) -> None:
        """It ends."""
        for hold in self._holds:
            self._plant.holds.release(self, hold)


class Event:
    """A fault that happens at an instant and is over; what it has left behind stays."""

    def __init__(self, happen: Callable[[], None]) -> None:
        self._happen = happen

    def inject(self) -> None:
        """It happens."""
        self._happen()

    def clear(self) -> None:
        """Nothing to be ended."""
