"""The table for the terminal: one row for each block, and the total."""

from collections.abc import Iterable, Sequence

from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.derived import catalogue_of
from harness.verify.coverage.totals import Count, Totals
from harness.verify.coverage.uniting import UnitedBlock, together, united

HEADINGS = ("block", "dialects", "statements", "branches", "MC/DC", "lines not run")


def rows(coverage: Coverage) -> list[tuple[str, ...]]:
    """The cells of the table. A block that has several texts is one row for all of them."""
    blocks = united(coverage)
    found = []
    for block in blocks:
        title = block.name if len(block.texts) == 1 else f"{block.name} ({len(block.texts)} texts)"
        dialects = ", ".join(block.dialects)
        found.append((title, dialects, *_cells(block.totals), _lines(block)))
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


def _lines(block: UnitedBlock) -> str:
    """The lines of the only text, or of the one that has most of them, with its plant."""
    text, lines = max(
        ((text, block.lines_not_run(text)) for text in block.texts), key=lambda one: len(one[1])
    )
    if len(block.texts) == 1 or not lines:
        return line_ranges(lines)
    return f"{line_ranges(lines)} of {'/'.join((*sorted(text.plants)[:1], text.file.dialect))}"


def line_ranges(lines: Iterable[int]) -> str:
    """Line numbers for people: `12, 40-43`."""
    ranges: list[list[int]] = []
    for line in sorted(set(lines)):
        if ranges and line == ranges[-1][1] + 1:
            ranges[-1][1] = line
        else:
            ranges.append([line, line])
    return ", ".join(str(first) if first == last else f"{first}-{last}" for first, last in ranges)
