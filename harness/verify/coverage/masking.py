"""Masking MC/DC: which vectors show that a condition decides, alone.

A condition is shown by two vectors if it is TRUE in one and FALSE in the other, if in both of them
it is not masked, and if the result differs because of it. It is masked where another side of AND is
FALSE, or another side of OR is TRUE. Other conditions may differ as long as what they are joined to
stays the same on the way from the condition to the result (FAA CAST-6, 2001, masking MC/DC). A pair
in which no other condition differs is "unique cause", and is preferred.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from harness.engine.compiled.expressions.decisions import (
    Condition,
    Join,
    Not,
    Tree,
    conditions_in,
    result,
)


class Pair(NamedTuple):
    """Two vectors that show a condition; `unique` if no other condition differs."""

    true: int
    false: int
    unique: bool


class _Step(NamedTuple):
    """An operator on the way from the result to a condition, and both its sides."""

    operator: str
    own: Tree
    other: Tree
    is_first: bool


def way_to(tree: Tree, number: int) -> Sequence[_Step]:
    """The operators that join a condition to the others, from the outside in."""
    steps: list[_Step] = []
    while not isinstance(tree, Condition):
        if isinstance(tree, Not):
            tree = tree.operand
            continue
        assert isinstance(tree, Join), "a way leads to a condition"
        in_left = number in conditions_in(tree.left)
        own, other = (tree.left, tree.right) if in_left else (tree.right, tree.left)
        steps.append(_Step(tree.operator, own, other, in_left))
        tree = own
    return steps


def deciding(way: Iterable[_Step], vector: int) -> tuple[bool, ...] | None:
    """What a condition is joined to by XOR, = and <> where it decides; None where it is masked."""
    joined: list[bool] = []
    for operator, own, other, is_first in way:
        if operator in ("XOR", "=", "<>"):
            joined.append(result(other, vector))
            continue
        neutral = operator in ("AND", "AND_THEN")
        was_alone = is_first and operator in ("AND_THEN", "OR_ELSE")
        if was_alone and result(own, vector) != neutral:
            continue  # the other side was not even evaluated
        if result(other, vector) != neutral:
            return None
    return tuple(joined)


def was_evaluated(number: int, count: int, vector: int) -> bool:
    """False for a condition that AND_THEN or OR_ELSE left out; `count` conditions there are."""
    return not vector >> (count + number) & 1


def shown_by(tree: Tree, number: int, count: int, vectors: Iterable[int]) -> Pair | None:
    """A pair of vectors that shows a condition, with as little difference as there is."""
    way = way_to(tree, number)
    sides: dict[tuple[bool, ...], tuple[list[int], list[int]]] = {}
    for vector in vectors:
        if was_evaluated(number, count, vector):
            key = deciding(way, vector)
            if key is not None:
                sides.setdefault(key, ([], []))[vector >> number & 1].append(vector)
    pairs = (
        (_others(number, count, true, false), true, false)
        for falses, trues in sides.values()
        for true in trues
        for false in falses
    )
    best = min(pairs, default=None)
    return None if best is None else Pair(best[1], best[2], best[0] == 0)


def decided_as(tree: Tree, number: int, count: int, vectors: Iterable[int]) -> set[bool]:
    """The values with which a condition has been seen deciding."""
    way = way_to(tree, number)
    return {
        bool(vector >> number & 1)
        for vector in vectors
        if was_evaluated(number, count, vector) and deciding(way, vector) is not None
    }


def _others(number: int, count: int, one: int, other: int) -> int:
    """How many other conditions differ, of those that were evaluated both times."""
    left_out = (one | other) >> count
    differing = (one ^ other) & ~left_out & (1 << count) - 1 & ~(1 << number)
    return differing.bit_count()
