"""Tables and texts for people: on a terminal they wrap at its edge."""

import shutil
import textwrap
from collections.abc import Sequence

from fbgen.cli.output import on_terminal
from fbgen.columns import columns

_NARROWEST = 20


def table(headings: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """The rows below their headings. Every row has as many cells as there are headings."""
    width = shutil.get_terminal_size().columns if on_terminal() else 0
    return columns(headings, rows, width)


def indented(text: str) -> str:
    """A text two columns further right."""
    return textwrap.indent(text, "  ")


def paragraph(text: str) -> str:
    """A text for people, wrapped on a terminal, on one line otherwise."""
    if not on_terminal():
        return text
    return textwrap.fill(text, max(_NARROWEST, shutil.get_terminal_size().columns))
