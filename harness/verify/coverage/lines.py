"""Coverage by lines, as reports for CI servers have it: each part of a template once.

Such reports know files and lines only, and add up what they have. So what several texts of one
block have in common stands in the one with most statements, with the counts of all of them; the
others have only what none before them has.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.items import BRANCH, STATEMENT, items_of
from harness.verify.coverage.model import FileKey
from harness.verify.coverage.uniting import ItemKey, fullest_first, kin_of


class Way(NamedTuple):
    """A way on from a branching; `hits` None if the branching itself was never reached."""

    name: str
    hits: int | None


class LineCounts(NamedTuple):
    """How often a line ran, and the ways on from the branchings that begin on it."""

    number: int
    hits: int
    branchings: Sequence[Sequence[Way]]


class BlockLines(NamedTuple):
    """The lines of a block that count in one of its texts; `calls`: how often it was called."""

    name: str
    first_line: int
    calls: int
    lines: Sequence[LineCounts]


def lines_by_file(coverage: Coverage) -> dict[FileKey, list[BlockLines]]:
    """The blocks of all files in which something counts, in the order of their texts."""
    kin: dict[tuple[str, ...], list[BlockCounts]] = {}
    for counts in coverage.files.values():
        for block in counts.of_blocks():
            kin.setdefault(kin_of(block), []).append(block)
    found: dict[FileKey, list[BlockLines]] = {}
    for texts in kin.values():
        for text, lines in _lines_of_texts(fullest_first(texts)):
            if lines:
                calls = text.statement_hits[0] if text.statement_hits else 0
                places = text.places
                block_lines = BlockLines(places.name, places.place.line, calls, lines)
                found.setdefault(text.file, []).append(block_lines)
    for blocks in found.values():
        blocks.sort(key=lambda one: one.first_line)
    return found


def _lines_of_texts(
    texts: Sequence[BlockCounts],
) -> Iterator[tuple[BlockCounts, Sequence[LineCounts]]]:
    total: Counter[ItemKey] = Counter()
    for text in texts:
        for key, hits in zip(_keys(text), _hits(text), strict=True):
            total[key] += hits
    known: set[ItemKey] = set()
    for text in texts:
        keys = _keys(text)
        count = len(text.statement_hits)
        all_hits = [total[key] for key in keys]
        everywhere = text._replace(statement_hits=all_hits[:count], outcome_hits=all_hits[count:])
        yield everywhere, _lines(everywhere, [key not in known for key in keys])
        known.update(keys)


def _keys(text: BlockCounts) -> list[ItemKey]:
    """Those of the statements, then those of the outcomes."""
    items = (item for item in items_of(text) if item.kind in (STATEMENT, BRANCH))
    return [ItemKey(item.kind, item.key) for item in items]


def _hits(text: BlockCounts) -> Sequence[int]:
    return (*text.statement_hits, *text.outcome_hits)


def _lines(block: BlockCounts, counts: Sequence[bool]) -> list[LineCounts]:
    """The lines of a block with something that `counts`. What cannot be taken is left out."""
    marked = iter(counts)
    hits: dict[int, int] = {}
    reached: dict[tuple[int, int], int] = {}
    shown: set[int] = set()
    for place, count in block.statements():
        hits[place.line] = max(hits.get(place.line, 0), count)
        start = place.line, place.column
        reached[start] = max(reached.get(start, 0), count)
        if next(marked):
            shown.add(place.line)
    branchings: dict[int, list[list[Way]]] = {}
    for branching, taken in block.branchings():
        line, column = branching.place.line, branching.place.column
        was_reached = reached.get((line, column), 1)
        ways = [
            Way(outcome.name, count if was_reached else None)
            for outcome, count, is_counted in zip(branching.outcomes, taken, marked, strict=False)
            if is_counted and not outcome.excluded
        ]
        if ways:
            branchings.setdefault(line, []).append(ways)
            shown.add(line)
    return [
        LineCounts(line, count, branchings.get(line, []))
        for line, count in hits.items()
        if line in shown
    ]
