"""The handbook: a title, contents, a chapter for each group of pages, page numbers, bookmarks.

It is the same bytes for the same site. The library is an extra: `pip install fbgen[pdf]`.
"""

from collections.abc import Iterator, Sequence
from io import BytesIO
from itertools import groupby
from typing import Any

from reportlab.platypus import (
    BaseDocTemplate,
    Flowable,
    Frame,
    PageBreak,
    PageTemplate,
    Paragraph,
    Preformatted,
    Spacer,
    Table,
)
from reportlab.platypus.tableofcontents import TableOfContents

from fbgen.docs import document
from fbgen.docs.document import Block, Page, Section
from fbgen.docs.drawing import PRINTED
from fbgen.docs.pdf.phrases import phrase_markup, target, text_markup
from fbgen.docs.pdf.pictures import Picture
from fbgen.docs.pdf.styles import (
    BODY,
    BULLET,
    CHAPTER,
    CONTENTS,
    HEADING,
    LEAD,
    MARGIN,
    NOTICE,
    PAGE,
    PLAIN,
    SAMPLE,
    SECTION,
    TITLE,
    WIDTH,
)
from fbgen.docs.pdf.tables import grid
from fbgen.docs.site import Site

_WIDEST_FACT = 120.0


def handbook(site: Site) -> bytes:
    """The PDF."""
    data = BytesIO()
    book = _Book(data, site)
    book.multiBuild(list(_story(site)))
    return data.getvalue()


class _Book(BaseDocTemplate):
    """Pages with a foot; headings become bookmarks and lines of the contents."""

    def __init__(self, data: BytesIO, site: Site) -> None:
        super().__init__(
            data,
            pagesize=PAGE,
            leftMargin=MARGIN,
            rightMargin=MARGIN,
            topMargin=MARGIN,
            bottomMargin=MARGIN,
            title=f"{site.title}: reference",
            author="fbgen",
            invariant=1,
        )
        self._foot = f"{site.title} - fbgen {site.version}"
        frame = Frame(MARGIN, MARGIN, WIDTH, PAGE[1] - 2 * MARGIN, 0, 0, 0, 0)
        self.addPageTemplates(PageTemplate("page", [frame], onPage=self._on_page))

    def _on_page(self, canvas: Any, _book: object) -> None:
        canvas.saveState()
        canvas.setFont("Helvetica", 8)
        canvas.setFillColor(PRINTED["muted"])
        canvas.drawString(MARGIN, MARGIN - 16, self._foot)
        canvas.drawRightString(PAGE[0] - MARGIN, MARGIN - 16, str(canvas.getPageNumber()))
        canvas.restoreState()

    def afterFlowable(self, flowable: Flowable) -> None:  # noqa: N802 - the library's name
        """A heading has been set: note its page."""
        if isinstance(flowable, _Heading):
            place = flowable.place
            self.canv.bookmarkPage(place)
            self.canv.addOutlineEntry(flowable.title, place, flowable.level, closed=True)
            self.notify("TOCEntry", (flowable.level, text_markup(flowable.title), self.page, place))


class _Heading(Paragraph):
    """A heading that stands in the contents."""

    def __init__(self, title: str, level: int, place: str) -> None:
        super().__init__(text_markup(title), HEADING if level else CHAPTER)
        self.title, self.level, self.place = title, level, place
        self.keepWithNext = 1


def _story(site: Site) -> Iterator[Flowable]:
    yield Spacer(1, 150)
    yield Paragraph(text_markup(site.title), TITLE)
    yield Paragraph("Reference: how every bit is used", LEAD)
    yield Paragraph(text_markup(f"Made by fbgen {site.version}"), BODY)
    yield PageBreak()
    yield Paragraph("Contents", CHAPTER)
    contents = TableOfContents()
    contents.levelStyles = CONTENTS
    contents.dotsMinLevel = 0
    yield contents
    for group, pages in groupby(site.pages, lambda page: page.group):
        yield PageBreak()
        yield _Heading(group, 0, f"group-{group}")
        for page in pages:
            yield from _page(page)


def _page(page: Page) -> Iterator[Flowable]:
    yield _Heading(page.title, 1, target(page.id))
    lead = Paragraph(phrase_markup(page.lead, page.id), LEAD)
    lead.keepWithNext = 1
    yield lead
    for section in page.sections:
        blocks = [block for block in section.blocks if not isinstance(block, document.Tool)]
        if blocks:
            yield from _section(section, blocks, page.id)


def _section(section: Section, blocks: Sequence[Block], page: str) -> Iterator[Flowable]:
    name = f'<a name="{target(page, section.anchor)}"/>{text_markup(section.title)}'
    heading = Paragraph(name, SECTION)
    heading.keepWithNext = 1
    yield heading
    for block in blocks:
        yield from _block(block, page)


def _block(block: Block, page: str) -> Iterator[Flowable]:
    if isinstance(block, document.Paragraph):
        yield Paragraph(phrase_markup(block.phrase, page), NOTICE if block.tone else BODY)
    elif isinstance(block, document.Bullets):
        for item in block.items:
            yield Paragraph(phrase_markup(item, page), BULLET, bulletText="\u2022")
    elif isinstance(block, document.Facts):
        yield _facts(block, page)
    elif isinstance(block, document.Table):
        if block.title:
            yield Paragraph(f"<b>{text_markup(block.title)}</b>", BODY)
        if block.rows:
            yield grid(block, page)
    elif isinstance(block, document.Sample):
        yield Preformatted(block.text, SAMPLE)
    elif isinstance(block, document.Figure):
        yield Picture(block.drawing)
        yield Spacer(1, 6)


def _facts(block: document.Facts, page: str) -> Table:
    rows = [
        [Paragraph(text_markup(title), BODY), Paragraph(phrase_markup(phrase, page), BODY)]
        for title, phrase in block.rows
    ]
    widths = [_WIDEST_FACT, WIDTH - _WIDEST_FACT]
    return Table(rows, colWidths=widths, style=PLAIN, hAlign="LEFT", spaceAfter=6)
