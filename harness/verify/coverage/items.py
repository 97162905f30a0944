"""All that counts in one text of a block: its statements, branches and conditions, one by one."""

from collections.abc import Iterable, Iterator
from itertools import count
from typing import NamedTuple

from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.masking import decided_as, shown_by
from harness.verify.coverage.model import DecisionPlace, Place

STATEMENT, BRANCH, MCDC = KINDS = ("statement", "branch", "mcdc")
"""The kinds of coverage of PLC text."""


class Item(NamedTuple):
    """Something that a test can reach. `key` names it among the items of its kind and block, in all
    texts of one template; `excluded` says why it cannot be reached here, `missing` what no run of
    this text has shown, both "" otherwise."""

    kind: str
    key: str
    place: Place
    excluded: str
    missing: str


def items_of(block: BlockCounts) -> Iterator[Item]:
    """The items of a block: all statements, all branches, all conditions."""
    statements, outcomes, conditions = _keys(block)
    for place, hits in block.statements():
        yield Item(STATEMENT, next(statements), place, "", "" if hits else "never run")
    for branching, taken in block.branchings():
        for outcome, hits in zip(branching.outcomes, taken, strict=True):
            missing = "" if hits else f"never: {outcome.name}"
            yield Item(BRANCH, next(outcomes), outcome.place, outcome.excluded, missing)
    for decision, vectors in block.decisions():
        for number, condition in enumerate(decision.conditions):
            what = "" if condition.excluded else wanted(decision, number, vectors)
            missing = what and f"{condition.text}: {what}"
            yield Item(MCDC, next(conditions), condition.place, condition.excluded, missing)


def _keys(block: BlockCounts) -> tuple[Iterator[str], Iterator[str], Iterator[str]]:
    """The keys of statements, outcomes and conditions; the text of a person has only numbers."""
    known = block.places.made_from
    if not known.template:
        return map(str, count()), map(str, count()), map(str, count())
    return iter(known.statements), iter(known.outcomes), iter(known.conditions)


def wanted(decision: DecisionPlace, number: int, vectors: Iterable[int]) -> str:
    """What is missing for a condition to be shown; "" if it is."""
    total, seen = len(decision.conditions), list(vectors)
    if not seen:
        return "the decision was never made"
    if shown_by(decision.tree, number, total, seen) is not None:
        return ""
    values = decided_as(decision.tree, number, total, seen)
    if len(values) == 2:
        return "never TRUE and FALSE with all else equal"
    if not values:
        return "the other conditions have always decided"
    return f"never {'FALSE' if True in values else 'TRUE'} where it decides"
