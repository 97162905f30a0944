"""How much of a block, or of everything, was reached."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.masking import shown_by
from harness.verify.coverage.model import DecisionPlace

KINDS = ("statement", "branch", "mcdc")
"""The kinds of coverage of PLC text."""


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
    """The three kinds of coverage."""

    statement: Count = Count(0, 0)
    branch: Count = Count(0, 0)
    mcdc: Count = Count(0, 0)

    def plus(self, other: "Totals") -> "Totals":
        """Both together."""
        return Totals(*(one.plus(more) for one, more in zip(self, other, strict=True)))


def totals_of(block: BlockCounts) -> Totals:
    """The coverage of a block. What is excluded does not count."""
    branches = [
        hits > 0
        for branching, taken in block.branchings()
        for outcome, hits in zip(branching.outcomes, taken, strict=True)
        if not outcome.excluded
    ]
    conditions = [
        is_shown
        for place, vectors in block.decisions()
        for condition, is_shown in zip(place.conditions, shown(place, vectors), strict=True)
        if not condition.excluded
    ]
    return Totals(
        Count(sum(hits > 0 for hits in block.statement_hits), len(block.statement_hits)),
        Count(sum(branches), len(branches)),
        Count(sum(conditions), len(conditions)),
    )


def shown(place: DecisionPlace, vectors: Iterable[int]) -> Sequence[bool]:
    """For each condition of a decision whether the vectors show that it decides."""
    count = len(place.conditions)
    seen = list(vectors)
    return [shown_by(place.tree, number, count, seen) is not None for number in range(count)]


def together(blocks: Iterable[BlockCounts]) -> Totals:
    """The coverage of several blocks."""
    total = Totals()
    for block in blocks:
        total = total.plus(totals_of(block))
    return total
