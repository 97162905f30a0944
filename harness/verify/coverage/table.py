"""The table for the terminal: one row for each block of each dialect, and the total."""

from collections.abc import Sequence
from itertools import groupby

from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.derived import catalogue_of
from harness.verify.coverage.missing import line_ranges, lines_not_run
from harness.verify.coverage.totals import Count, Totals, together

HEADINGS = ("block", "dialect", "statements", "branches", "MC/DC", "lines not run")


def rows(coverage: Coverage) -> list[tuple[str, ...]]:
    """The cells of the table. A block that has several texts is one row with all of them."""
    blocks = list(coverage.blocks())
    found = []
    for (name, dialect), group in groupby(
        blocks, key=lambda block: (block.places.name, block.file.dialect)
    ):
        texts = list(group)
        title = name if len(texts) == 1 else f"{name} ({len(texts)} texts)"
        found.append((title, dialect, *_cells(together(texts)), _lines(texts)))
    return [*found, ("all blocks", "", *_cells(together(blocks)), "")]


CATALOGUE_HEADINGS = ("catalogue", "exercised", "not yet")
_SHOWN = 4
"""Items that the table names; the other reports have them all."""


def catalogue_rows(coverage: Coverage) -> list[tuple[str, ...]]:
    """The cells of the table of the catalogue; none if no plant was looked at."""
    catalogue = catalogue_of(coverage)
    found = []
    for group in catalogue.groups():
        more = len(group.missing) - _SHOWN
        named = ", ".join(group.missing[:_SHOWN]) + (f" and {more} more" if more > 0 else "")
        found.append((group.name, _cell(group.exercised), named))
    return [*found, ("all", _cell(catalogue.total()), "")] if found else []


def _cells(totals: Totals) -> Sequence[str]:
    return [_cell(count) for count in totals]


def _cell(count: Count) -> str:
    return f"{count.shown:>5} {count.reached}/{count.total}" if count.total else "    -"


def _lines(texts: Sequence[BlockCounts]) -> str:
    """The lines of the only text; those of several texts are different ones."""
    return line_ranges(lines_not_run(texts[0])) if len(texts) == 1 else ""
