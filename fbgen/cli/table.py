"""Tables in plain text: aligned columns; on a terminal the last column wraps at its edge."""

import shutil
import textwrap
from collections.abc import Sequence

from fbgen.cli.output import on_terminal

_GAP = "  "
_NARROWEST = 20


def table(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """The rows below their headings. Every row has as many cells as there are headings."""
    columns = list(zip(headings, *rows, strict=True))
    widths = [max(len(cell) for cell in column) for column in columns]
    room = 0
    if on_terminal():
        taken = sum(widths[:-1]) + len(_GAP) * (len(widths) - 1)
        room = max(_NARROWEST, shutil.get_terminal_size().columns - taken)
    rule = ["-" * len(heading) for heading in headings]
    return "\n".join(_line(row, widths, room) for row in (headings, rule, *rows))


def indented(text: str) -> str:
    """A text two columns further right."""
    return textwrap.indent(text, "  ")


def paragraph(text: str) -> str:
    """A text for people, wrapped on a terminal, on one line otherwise."""
    if not on_terminal():
        return text
    return textwrap.fill(text, max(_NARROWEST, shutil.get_terminal_size().columns))


def _line(row: Sequence[str], widths: Sequence[int], room: int) -> str:
    *cells, last = row
    start = "".join(cell.ljust(width) + _GAP for cell, width in zip(cells, widths, strict=False))
    if room and len(last) > room:
        last = f"\n{' ' * len(start)}".join(textwrap.wrap(last, room))
    return (start + last).rstrip()
