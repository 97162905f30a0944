"""Tables of the handbook: columns as wide as what stands in them asks for."""

from collections.abc import Iterator, Sequence

from reportlab.pdfbase.pdfmetrics import stringWidth
from reportlab.platypus import LongTable, Paragraph

from fbgen.docs.document import Code, Inline, Phrase, Row, Strong, Table
from fbgen.docs.pdf.phrases import phrase_markup, target, text_markup
from fbgen.docs.pdf.styles import CELL, GRID, HEAD, WIDTH

_PADDING = 9.0
_LOOKED_AT = 60
"""So many rows tell how wide the columns are."""


def grid(table: Table, page: str) -> LongTable:
    """The table; its head stands on every page that it reaches."""
    head = [Paragraph(text_markup(column), HEAD) for column in table.columns]
    rows = [_cells(row, page) for row in table.rows]
    widths = _widths(table)
    return LongTable(
        [head, *rows], colWidths=widths, repeatRows=1, style=GRID, hAlign="LEFT", spaceAfter=8
    )


def _cells(row: Row, page: str) -> list[Paragraph | str]:
    texts = [phrase_markup(cell, page) for cell in row.cells]
    if row.anchor:
        texts[0] = f'<a name="{target(page, row.anchor)}"/>{texts[0]}'
    return [Paragraph(text, CELL) if text else "" for text in texts]


def _widths(table: Table) -> list[float]:
    """What each column needs at least, its longest word; and a share of the rest by its texts."""
    step = max(1, len(table.rows) // _LOOKED_AT)
    least, wanted = [], []
    for number, column in enumerate(table.columns):
        cells: list[Phrase] = [(Strong(column),)]
        cells += [row.cells[number] for row in table.rows[::step] if number < len(row.cells)]
        least.append(max(_width(part, word) for cell in cells for part, word in _words(cell)))
        wanted.append(max(sum(_width(part, _text(part)) for part in cell) for cell in cells))
    return _shared(least, wanted)


def _words(cell: Phrase) -> Iterator[tuple[Inline, str]]:
    yield "", ""
    for part in cell:
        for word in _text(part).split():
            yield part, word


def _text(part: Inline) -> str:
    return part if isinstance(part, str) else part.text


def _shared(least: Sequence[float], wanted: Sequence[float]) -> list[float]:
    low = [min(one, WIDTH / 4) + _PADDING for one in least]
    high = [one + _PADDING for one in wanted]
    if sum(high) <= WIDTH:
        return high
    room = WIDTH - sum(low)
    if room <= 0:
        return [one * WIDTH / sum(low) for one in low]
    more = [max(0.0, top - bottom) ** 0.6 for top, bottom in zip(high, low, strict=True)]
    return [one + room * part / sum(more) for one, part in zip(low, more, strict=True)]


def _width(part: Inline, text: str) -> float:
    font = "Courier" if isinstance(part, Code) else "Helvetica-Bold"
    return stringWidth(text, font, CELL.fontSize) + 1
