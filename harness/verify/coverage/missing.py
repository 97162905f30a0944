"""What was not reached, in words: for the terminal, for HTML, for messages."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.masking import decided_as, shown_by
from harness.verify.coverage.model import DecisionPlace, Place
from harness.verify.coverage.totals import KINDS


class Missing(NamedTuple):
    """Something that no run has reached, and where it stands."""

    kind: str
    place: Place
    what: str


def missing_in(block: BlockCounts) -> list[Missing]:
    """All of a block, in the order of the text."""
    found = [*_statements(block), *_branches(block), *_conditions(block)]
    return sorted(found, key=lambda one: (one.place, KINDS.index(one.kind)))


def _statements(block: BlockCounts) -> Iterator[Missing]:
    for place, hits in block.statements():
        if not hits:
            yield Missing("statement", place, "never run")


def _branches(block: BlockCounts) -> Iterator[Missing]:
    for branching, taken in block.branchings():
        for outcome, hits in zip(branching.outcomes, taken, strict=True):
            if not hits and not outcome.excluded:
                yield Missing("branch", outcome.place, f"never: {outcome.name}")


def _conditions(block: BlockCounts) -> Iterator[Missing]:
    for decision, vectors in block.decisions():
        for number, condition in enumerate(decision.conditions):
            if not condition.excluded and (what := wanted(decision, number, vectors)):
                yield Missing("mcdc", condition.place, f"{condition.text}: {what}")


def wanted(decision: DecisionPlace, number: int, vectors: Iterable[int]) -> str:
    """What is missing for a condition to be shown; "" if it is."""
    count, seen = len(decision.conditions), list(vectors)
    if not seen:
        return "the decision was never made"
    if shown_by(decision.tree, number, count, seen) is not None:
        return ""
    values = decided_as(decision.tree, number, count, seen)
    if len(values) == 2:
        return "never TRUE and FALSE with all else equal"
    if not values:
        return "the other conditions have always decided"
    return f"never {'FALSE' if True in values else 'TRUE'} where it decides"


def line_ranges(lines: Iterable[int]) -> str:
    """Line numbers for people: `12, 40-43`."""
    ranges: list[list[int]] = []
    for line in sorted(set(lines)):
        if ranges and line == ranges[-1][1] + 1:
            ranges[-1][1] = line
        else:
            ranges.append([line, line])
    return ", ".join(str(first) if first == last else f"{first}-{last}" for first, last in ranges)


def lines_not_run(block: BlockCounts) -> Sequence[int]:
    """The lines with statements of which none has run."""
    run: dict[int, int] = {}
    for place, hits in block.statements():
        run[place.line] = max(run.get(place.line, 0), hits)
    return [line for line, hits in run.items() if not hits]
