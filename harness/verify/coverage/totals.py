"""How much of something was reached."""

from typing import NamedTuple


class Count(NamedTuple):
    """How many of how many were reached."""

    reached: int
    total: int

    @property
    def percent(self) -> float:
        """All of nothing is 100 %."""
        return 100 * self.reached / self.total if self.total else 100.0

    @property
    def shown(self) -> str:
        """In whole percent, rounded down: only what is complete shows 100 %."""
        return f"{int(self.percent)} %" if self.total else "-"

    def plus(self, other: "Count") -> "Count":
        """Both together."""
        return Count(self.reached + other.reached, self.total + other.total)


class Totals(NamedTuple):
    """The three kinds of coverage, in the order of `items.KINDS`."""

    statement: Count = Count(0, 0)
    branch: Count = Count(0, 0)
    mcdc: Count = Count(0, 0)

    def plus(self, other: "Totals") -> "Totals":
        """Both together."""
        return Totals(*(one.plus(more) for one, more in zip(self, other, strict=True)))
