"""Coverage by lines, as reports for CI servers have it."""

from collections.abc import Sequence
from typing import NamedTuple

from harness.verify.coverage.counts import BlockCounts


class Way(NamedTuple):
    """A way on from a branching; `hits` None if the branching itself was never reached."""

    name: str
    hits: int | None


class LineCounts(NamedTuple):
    """How often a line ran, and the ways on from the branchings that begin on it."""

    number: int
    hits: int
    branchings: Sequence[Sequence[Way]]


def lines_of(block: BlockCounts) -> list[LineCounts]:
    """The lines of a block on which statements begin. What cannot be taken is left out."""
    hits: dict[int, int] = {}
    reached: dict[tuple[int, int], int] = {}
    for place, count in block.statements():
        hits[place.line] = max(hits.get(place.line, 0), count)
        start = place.line, place.column
        reached[start] = max(reached.get(start, 0), count)
    branchings: dict[int, list[list[Way]]] = {}
    for branching, taken in block.branchings():
        was_reached = reached.get((branching.place.line, branching.place.column), 1)
        ways = [
            Way(outcome.name, count if was_reached else None)
            for outcome, count in zip(branching.outcomes, taken, strict=True)
            if not outcome.excluded
        ]
        if ways:
            branchings.setdefault(branching.place.line, []).append(ways)
    return [LineCounts(line, count, branchings.get(line, [])) for line, count in hits.items()]
