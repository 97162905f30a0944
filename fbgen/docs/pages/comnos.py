"""A page for each series with all its ComNos, and a converter of values to words and back."""

from collections.abc import Iterator

from fbgen.catalog import ComNo, Drive
from fbgen.docs.document import (
    Code,
    Link,
    Page,
    Paragraph,
    Phrase,
    Row,
    Section,
    Table,
    Tool,
    spaced,
)
from fbgen.docs.page_names import comno_anchor, comno_page, device_page, word_page
from fbgen.docs.sources import UNVERIFIED, Sources
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code, number, with_unit

GROUP = "ComNos"
_ACCESS = {"r": "read", "w": "write", "rw": "read, write"}
_STORAGE = {"ram": "RAM", "eeprom": "EEPROM"}
_COLUMNS = (
    *("ComNo", "Name", "Panel", "What it is", "Unit", "One count", "Range", "Default"),
    *("Access", "Kept in", "Source"),
)


def comno_pages(subject: Subject) -> Iterator[Page]:
    """One page a series."""
    for series in subject.drives.values():
        yield _page(series, subject)


def _page(series: Drive, subject: Subject) -> Page:
    sources = Sources()
    cells = sorted(series.comnos, key=lambda cell: cell.number)
    having = {
        cell.hex: [
            other.id
            for other in subject.drives.values()
            if any(entry.number == cell.number for entry in other.comnos)
        ]
        for cell in cells
    }
    rows = tuple(_row(series, cell, sources) for cell in cells)
    sections = (
        Section("Converter", (Tool("converter", _converter(series)),), "converter"),
        Section("All ComNos", (Table(_COLUMNS, rows),), "comnos"),
        *_series_section(having, len(subject.drives)),
        *sources.sections(),
    )
    lead: Phrase = (
        "Communication numbers of ",
        Link(series.title, device_page(series.id)),
        ". A word is the value divided by what one count is: 50 Hz at 0.01 Hz is ",
        Code("1388"),
        " hexadecimal. What is in the EEPROM is kept without supply; a cell lasts about 10,000 "
        "writes.",
    )
    return Page(
        comno_page(series.id), f"ComNos of {series.id}", GROUP, lead, sections, f"{series.id} ComNo"
    )


def _row(series: Drive, cell: ComNo, sources: Sources) -> Row:
    parts: list[Phrase] = [
        code(cell.hex),
        code(cell.name),
        code(cell.display) if cell.display else (),
        _what(series, cell),
        (cell.unit,),
        (with_unit(cell.resolution, cell.unit) if cell.unit or cell.resolution != 1 else "",),
        _guessed(_range(cell), cell, "minimum", "maximum"),
        _guessed(_default(cell), cell, "default"),
        (_ACCESS[cell.access],),
        _guessed(_STORAGE[cell.storage], cell, "storage"),
        sources.of(cell.source, cell.status),
    ]
    shown = f" {cell.display}" if cell.display else ""
    found = f"{series.id} {cell.hex} {cell.name}{shown} {cell.title}"
    return Row(tuple(parts), comno_anchor(cell), found)


def _what(series: Drive, cell: ComNo) -> Phrase:
    texts: list[str] = []
    if cell.values:
        texts.append("; ".join(f"{value} = {text}" for value, text in sorted(cell.values.items())))
    if cell.limited_by is not None:
        texts.append(f"At most the value of {cell.limited_by}.")
    if cell.frozen_copy_of is not None:
        texts.append(f"Repeats {cell.frozen_copy_of} until a trip freezes it.")
    if cell.effect == "after_restart":
        texts.append("Acts after a restart.")
    if cell.requires_stop:
        texts.append("Can be written at standstill only.")
    if cell.remark:
        texts.append(cell.remark)
    link: Phrase = ()
    if cell.word is not None:
        link = (Link("bits", word_page(series.id, cell.word)),)
    return spaced((f"{cell.title}.",), link, tuple([" ".join(texts)] if texts else []))


def _range(cell: ComNo) -> str:
    if cell.minimum is None and cell.maximum is None:
        return ""
    low = number(cell.minimum) if cell.minimum is not None else "0"
    high = number(cell.maximum) if cell.maximum is not None else ""
    return f"{low} to {high}" if high else f"from {low}"


def _default(cell: ComNo) -> str:
    return "" if cell.default is None else number(cell.default)


def _guessed(text: str, cell: ComNo, *fields: str) -> Phrase:
    """A text that may rest on no document although the ComNo does."""
    if not text:
        return ()
    guess = cell.status == "verified" and not set(fields).isdisjoint(cell.unverified)
    return (f"{text} ", UNVERIFIED) if guess else (text,)


def _series_section(having: dict[str, list[str]], series: int) -> tuple[Section, ...]:
    """Which other series have the same numbers."""
    if series < 2:
        return ()
    rows = tuple(Row((code(hexadecimal), (", ".join(ids),))) for hexadecimal, ids in having.items())
    note = Paragraph(("The same number in another series need not mean the same value range.",))
    table = Table(("ComNo", "Series that have it"), rows)
    return (Section("Series with the same numbers", (note, table), "series"),)


def _converter(series: Drive) -> dict[str, object]:
    """What the converter's script needs: number, name, unit, one count, smallest, greatest word."""
    rows = [
        [cell.hex, cell.name, cell.unit, cell.resolution, cell.minimum_word, cell.maximum_word]
        for cell in sorted(series.comnos, key=lambda cell: cell.number)
        if cell.word is None
    ]
    return {"series": series.id, "comnos": rows, "first": "FA01"}
