"""The handbook, read back by a library that others wrote."""

import re
from io import BytesIO

import pytest
from pypdf import PdfReader

from fbgen.catalog import load_catalog
from fbgen.docs.document import Figure, Link, Page, Paragraph, Row, Sample, Section, Table
from fbgen.docs.drawing import Box, Drawing, Label, Line
from fbgen.docs.pdf import handbook
from fbgen.docs.site import Site, build_site
from fbgen.docs.subject import whole_catalogue


def page(name: str, group: str, *links: Link) -> Page:
    rows = tuple(Row(((f"row {n}",), ("wide " * 30,)), f"row-{n}") for n in range(60))
    shapes = (
        Box(0, 0, 40, 20),
        Line(((0, 0), (40, 30)), arrow=True, dashed=True),
        Label(5, 15, "drawn text", strong=True),
    )
    blocks = (
        Paragraph((f"Text of {name} with \u00e4 and <b>", *links)),
        Figure(Drawing(60, 40, shapes), "A picture"),
        Sample("x := 1;\n  y := 2;"),
        Table(("A", "B"), rows, "A title"),
    )
    return Page(name, f"Page {name}", group, (), (Section("Part", blocks, "part"),))


SITE = Site(
    "Hall 2", (page("one", "Words"), page("two", "Blocks", Link("go", "one", "row-3"))), "1"
)


@pytest.fixture(scope="module")
def reader() -> PdfReader:
    return PdfReader(BytesIO(handbook(SITE)))


def test_the_same_site_gives_the_same_bytes() -> None:
    assert handbook(SITE) == handbook(SITE)


def test_contents_and_bookmarks_name_the_pages_that_headings_stand_on(reader: PdfReader) -> None:
    texts = [sheet.extract_text() for sheet in reader.pages]
    contents = reader.pages[1].extract_text(extraction_mode="layout")
    for entry in reader.outline:
        for item in entry if isinstance(entry, list) else [entry]:
            number = reader.get_destination_page_number(item)
            assert number is not None
            assert str(item.title) in texts[number]
            line = next(one for one in contents.splitlines() if str(item.title) in one)
            assert line.rstrip().endswith(str(number + 1))


def test_every_sheet_has_its_number_and_every_row_is_there(reader: PdfReader) -> None:
    texts = [sheet.extract_text() for sheet in reader.pages]
    for number, text in enumerate(texts, start=1):
        assert str(number) in text.splitlines()
    whole = "\n".join(texts)
    assert all(f"row {n}\n" in whole or f"row {n} " in whole for n in range(60))
    assert "drawn text" in whole
    assert "Text of one with \u00e4 and <b>" in whole


def test_a_link_leads_to_the_sheet_of_its_row(reader: PdfReader) -> None:
    notes = [note.get_object() for sheet in reader.pages for note in sheet.get("/Annots", ())]
    (way,) = [note["/Dest"] for note in notes if note["/Dest"][1] == "/XYZ"]
    sheet = next(one for one in reader.pages if one.indirect_reference == list.__getitem__(way, 0))
    assert re.search(r"row 3\b", sheet.extract_text())


@pytest.mark.slow
def test_the_handbook_of_the_whole_catalogue_has_every_page() -> None:
    site = build_site(whole_catalogue(load_catalog()), "1")
    outline = PdfReader(BytesIO(handbook(site))).outline
    titles = {str(item.title) for entry in outline if isinstance(entry, list) for item in entry}
    assert titles == {page.title for page in site.pages}
