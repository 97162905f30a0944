"""Tables in plain text: aligned columns."""

import textwrap
from collections.abc import Sequence

GAP = "  "
_NARROWEST = 20


def columns(headings: Sequence[str], rows: Sequence[Sequence[str]], width: int = 0) -> str:
    """The rows below their headings; every row has as many cells as there are headings.

    The last column wraps where the line would be longer than `width`; with 0 it never does.
    """
    cells = list(zip(headings, *rows, strict=True))
    widths = [max(len(cell) for cell in column) for column in cells]
    taken = sum(widths[:-1]) + len(GAP) * (len(widths) - 1)
    room = max(_NARROWEST, width - taken) if width else 0
    rule = ["-" * len(heading) for heading in headings]
    return "\n".join(_line(row, widths, room) for row in (headings, rule, *rows))


def _line(row: Sequence[str], widths: Sequence[int], room: int) -> str:
    *cells, last = row
    start = "".join(cell.ljust(width) + GAP for cell, width in zip(cells, widths, strict=False))
    if room and len(last) > room:
        last = f"\n{' ' * len(start)}".join(textwrap.wrap(last, room))
    return (start + last).rstrip()
