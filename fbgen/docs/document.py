"""What a page is made of: sections with paragraphs, tables, pictures. No markup of any format.

A phrase is a row of plain texts and marked ones. Pages and anchors are named, never by a path, so
that each format finds its own way from one page to another.
"""

from collections.abc import Iterator
from typing import Literal

from fbgen.dataclass import dataclass
from fbgen.docs.drawing import Drawing

Tone = Literal["unverified", "warning"]


@dataclass(frozen=True, slots=True)
class Code:
    """Text as somebody types it: names, numbers, lines of programs."""

    text: str


@dataclass(frozen=True, slots=True)
class Strong:
    """Text that is to be seen first."""

    text: str


@dataclass(frozen=True, slots=True)
class Link:
    """A text that leads to a page, or to an anchor on it. An empty page means this one.

    `state` is what the tool of the page is to show: `v=C400`. Formats without tools leave it out.
    """

    text: str
    page: str
    anchor: str = ""
    state: str = ""


@dataclass(frozen=True, slots=True)
class Tag:
    """A short remark about what stands beside it."""

    text: str
    tone: Tone


Inline = str | Code | Strong | Link | Tag
Phrase = tuple[Inline, ...]


@dataclass(frozen=True, slots=True)
class Paragraph:
    """A paragraph; one with a tone is set apart."""

    phrase: Phrase
    tone: Tone | None = None


@dataclass(frozen=True, slots=True)
class Bullets:
    """A list without order."""

    items: tuple[Phrase, ...]


@dataclass(frozen=True, slots=True)
class Facts:
    """Short facts: what it is about, and what is so."""

    rows: tuple[tuple[str, Phrase], ...]


@dataclass(frozen=True, slots=True)
class Row:
    """A row of a table. An anchor makes it a place; `found_by` is what a search finds it by."""

    cells: tuple[Phrase, ...]
    anchor: str = ""
    found_by: str = ""


@dataclass(frozen=True, slots=True)
class Table:
    """A table; each row has a cell for each column."""

    columns: tuple[str, ...]
    rows: tuple[Row, ...]
    title: str = ""


@dataclass(frozen=True, slots=True)
class Sample:
    """Lines of a program, of a command line, bytes: as they are."""

    text: str
    language: str = ""


@dataclass(frozen=True, slots=True)
class Figure:
    """A picture; `title` says what it shows to those who do not see it."""

    drawing: Drawing
    title: str


@dataclass(frozen=True, slots=True)
class Tool:
    """A part of a page that works with what somebody types; in print it is left out.

    `data` is for the script of this `kind`: plain lists, mappings, texts and numbers.
    """

    kind: Literal["decoder", "converter"]
    data: dict[str, object]


Block = Paragraph | Bullets | Facts | Table | Sample | Figure | Tool


@dataclass(frozen=True, slots=True)
class Section:
    """A part of a page under a heading of its own."""

    title: str
    blocks: tuple[Block, ...]
    anchor: str


@dataclass(frozen=True, slots=True)
class Page:
    """A page. `id` is unique in the site and the name of its file, `group` where a menu has it."""

    id: str
    title: str
    group: str
    lead: Phrase
    sections: tuple[Section, ...]
    found_by: str = ""

    def anchors(self) -> Iterator[str]:
        """Where one can be led on the page."""
        for section in self.sections:
            yield section.anchor
            for block in section.blocks:
                if isinstance(block, Table):
                    yield from (row.anchor for row in block.rows if row.anchor)

    def links(self) -> Iterator[Link]:
        """Where the page leads to."""
        for phrase in self._phrases():
            yield from (part for part in phrase if isinstance(part, Link))

    def _phrases(self) -> Iterator[Phrase]:
        yield self.lead
        for section in self.sections:
            for block in section.blocks:
                yield from phrases_of(block)


def phrases_of(block: Block) -> Iterator[Phrase]:
    """Every phrase of a block."""
    if isinstance(block, Paragraph):
        yield block.phrase
    elif isinstance(block, Bullets):
        yield from block.items
    elif isinstance(block, Facts):
        yield from (phrase for _, phrase in block.rows)
    elif isinstance(block, Table):
        for row in block.rows:
            yield from row.cells


def plain(phrase: Phrase) -> str:
    """A phrase without its marks."""
    return "".join(part if isinstance(part, str) else part.text for part in phrase)


def spaced(*phrases: Phrase) -> Phrase:
    """Phrases that are not empty, one behind the other with a blank between them."""
    parts: list[Inline] = []
    for phrase in phrases:
        if phrase:
            parts += [" ", *phrase] if parts else phrase
    return tuple(parts)
