"""Blocks in all their texts: what several plants and dialects make of one template counts once.

Each part of a template, in each of its expansions, is an item (`kinship`). It is reached if any of
the texts that have it was reached there, and excluded only where no text can reach it. What stands
in one of the texts only counts like everything else. Blocks that a person wrote have one text each.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from harness.engine.compiled.expressions.decisions import Results, Tree
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.items import KINDS, STATEMENT, Item, items_of
from harness.verify.coverage.totals import Count, Totals


class ItemKey(NamedTuple):
    """An item of a block, in whichever text."""

    kind: str
    key: str


class UnitedBlock(NamedTuple):
    """A block in its texts, those with most statements first.

    The counts of a text are its own; only vectors of decisions are those of all texts that have the
    same decision. `reached` are the items that any text has reached.
    """

    name: str
    texts: Sequence[BlockCounts]
    reached: frozenset[ItemKey]
    totals: Totals

    @property
    def dialects(self) -> Sequence[str]:
        """The dialects of the texts."""
        return sorted({text.file.dialect for text in self.texts})

    def missing_in(self, text: BlockCounts) -> list[Item]:
        """What no text has reached and this one has, in the order of the text."""
        found = [
            item
            for item in items_of(text)
            if not item.excluded and ItemKey(item.kind, item.key) not in self.reached
        ]
        return sorted(found, key=lambda one: (one.place, KINDS.index(one.kind)))

    def lines_not_run(self, text: BlockCounts) -> Sequence[int]:
        """The lines of a text with statements of which none has run in any text."""
        run: dict[int, bool] = {}
        for item in items_of(text):
            if item.kind == STATEMENT:
                line = item.place.line
                run[line] = run.get(line, False) or ItemKey(STATEMENT, item.key) in self.reached
        return [line for line, has_run in run.items() if not has_run]


def united(coverage: Coverage) -> list[UnitedBlock]:
    """All blocks by name."""
    groups: dict[tuple[str, ...], list[BlockCounts]] = {}
    for block in coverage.blocks():
        groups.setdefault(kin_of(block), []).append(block)
    return [_united(group) for _, group in sorted(groups.items())]


def kin_of(block: BlockCounts) -> tuple[str, ...]:
    """Equal for the texts of one block."""
    template = block.places.made_from.template
    return (block.places.name, template) if template else (block.places.name, "", *block.file)


def fullest_first(texts: Iterable[BlockCounts]) -> list[BlockCounts]:
    """The texts with most statements first, otherwise in the order of their files."""
    return sorted(texts, key=lambda one: (-len(one.places.statements), one.file))


def totals_of(block: BlockCounts) -> Totals:
    """The coverage of one text. What is excluded does not count."""
    return _united([block]).totals


def together(blocks: Iterable[UnitedBlock]) -> Totals:
    """The coverage of several blocks."""
    total = Totals()
    for block in blocks:
        total = total.plus(block.totals)
    return total


def _united(group: Sequence[BlockCounts]) -> UnitedBlock:
    texts = fullest_first(_with_all_vectors(group))
    counted: set[ItemKey] = set()
    reached: set[ItemKey] = set()
    for text in texts:
        for item in items_of(text):
            if not item.excluded:
                key = ItemKey(item.kind, item.key)
                counted.add(key)
                if not item.missing:
                    reached.add(key)
    counts = (
        Count(sum(key.kind == kind for key in reached), sum(key.kind == kind for key in counted))
        for kind in KINDS
    )
    return UnitedBlock(group[0].places.name, texts, frozenset(reached), Totals(*counts))


def _with_all_vectors(group: Sequence[BlockCounts]) -> Sequence[BlockCounts]:
    """The texts with the vectors that the same decisions have had in any of them."""
    if len(group) == 1:
        return group
    known: dict[tuple[str, Tree], Results] = {}
    for text in group:
        for key, vectors in zip(_decision_keys(text), text.vectors, strict=True):
            before = known.get(key)
            known[key] = vectors if before is None else before.plus(vectors)
    return [text._replace(vectors=[known[key] for key in _decision_keys(text)]) for text in group]


def _decision_keys(text: BlockCounts) -> Iterator[tuple[str, Tree]]:
    """A decision is known by its first condition and by how its conditions are joined."""
    conditions = iter(text.places.made_from.conditions)
    for decision in text.places.decisions:
        first, *_ = [next(conditions) for _ in decision.conditions]
        yield first, decision.tree
