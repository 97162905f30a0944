"""What an inverter remembers of its trips.

A trip stays until a reset or power off. While it lasts the FExx monitors keep the values of the
instant at which it came; FE10 to FE13 tell the last four trips and outlive a restart (VF-AS1 RS485
manual E6581315, appendix 1, "trip data held").
"""

from collections.abc import Mapping

from fbgen.catalog import Drive
from fbgen.diagnostics import error

PAST_TRIPS = 4


class TripLog:
    """The present trip, 0 for none, with the frozen monitors; and the past ones, latest first."""

    __slots__ = ("_by_display", "_codes", "code", "frozen", "past")

    def __init__(self, series: Drive) -> None:
        self._by_display = {trip.display: trip.code for trip in series.trips if trip.code}
        self._codes = {trip.code: trip.display for trip in series.trips}
        self.code = 0
        self.frozen: Mapping[int, int] = {}
        self.past = [0] * PAST_TRIPS

    def latch(self, code: int, frozen: Mapping[int, int]) -> None:
        """A trip comes. Only the first of several counts until it is reset."""
        if self.code:
            return
        self.code = code
        self.frozen = frozen
        self.past[:] = [code, *self.past[:-1]]

    def reset(self) -> None:
        """No trip any more; the past ones stay."""
        self.code = 0
        self.frozen = {}

    def code_of(self, display: str) -> int:
        """The code of a trip that the panel shows as `display`, such as Err5. FB7102 if unknown."""
        if display in self._by_display:
            return self._by_display[display]
        raise error(
            "FB7102",
            f"no trip is displayed as '{display}'",
            help="known trips: " + ", ".join(sorted(self._by_display)),
        )

    @property
    def display(self) -> str:
        """What the panel shows of the present trip; empty without one."""
        return self._codes.get(self.code, f"code {self.code:04X}") if self.code else ""
