"""The site as Markdown, judged by a parser that others wrote."""

import re
from collections.abc import Iterator
from xml.etree import ElementTree

import pytest
from markdown_it import MarkdownIt
from markdown_it.token import Token

from fbgen.docs.document import Code, Page, Paragraph, Row, Section, Table
from fbgen.docs.markdown import markdown_site
from fbgen.docs.site import Site

PARSER = MarkdownIt("commonmark").enable("table")


@pytest.fixture(scope="module")
def texts(site: Site) -> dict[str, str]:
    return {
        name: data.decode() for name, data in markdown_site(site).items() if name.endswith(".md")
    }


def inline(tokens: list[Token]) -> Iterator[Token]:
    for token in tokens:
        yield from token.children or ()


def cells(text: str) -> list[str]:
    tokens = PARSER.parse(text)
    found = []
    for number, token in enumerate(tokens):
        if token.type in ("td_open", "th_open"):
            parts = tokens[number + 1].children or []
            found.append("".join(part.content for part in parts if part.type != "html_inline"))
    return found


def test_every_link_and_picture_leads_somewhere(site: Site, texts: dict[str, str]) -> None:
    files = set(markdown_site(site))
    places = {name: set(re.findall(r'<a id="([^"]+)">', text)) for name, text in texts.items()}
    for name in ("tospbdp001.md", "vf-s11.command.md", "usage.md", "block-TOS_Telegram.md"):
        for token in inline(PARSER.parse(texts[name])):
            address = str(token.attrs.get("href", token.attrs.get("src", "")))
            file, _, anchor = address.partition("#")
            assert not file or file in files, address
            assert not anchor or anchor in places[file or name], address


def test_a_table_has_all_rows_and_columns(site: Site, texts: dict[str, str]) -> None:
    page = next(page for page in site.pages if page.id == "vf-s11-trips")
    table = next(
        block for section in page.sections for block in section.blocks if isinstance(block, Table)
    )
    assert len(cells(texts["vf-s11-trips.md"])) == (len(table.rows) + 1) * len(table.columns)


def test_no_text_becomes_markup(site: Site) -> None:
    evil = "a | b * c_d [e](f) `g` <b> # ~h~ \\"
    table = Table(("A", "B"), (Row(((evil,), (Code("x | y"),))),))
    section = Section("S", (Paragraph((evil,)), table), "s")
    page = Page("p", evil, "Words", (evil,), (section,))
    one = Site("T", (page,), site.version)
    text = markdown_site(one)["p.md"].decode()
    assert cells(text)[2:] == [evil, "x | y"]
    paragraphs = [
        "".join(child.content for child in token.children or ())
        for token in PARSER.parse(text)
        if token.type == "inline"
    ]
    assert paragraphs[0] == evil
    assert evil in paragraphs[1:]


def test_the_list_beside_the_pages_names_each_of_them(site: Site, texts: dict[str, str]) -> None:
    links = {str(token.attrs.get("href")) for token in inline(PARSER.parse(texts["_Sidebar.md"]))}
    assert {f"{page.id}.md" for page in site.pages} <= links


def test_pictures_are_whole_files(site: Site) -> None:
    pictures = {name: data for name, data in markdown_site(site).items() if name.endswith(".svg")}
    assert len(pictures) > 30
    for data in pictures.values():
        assert ElementTree.fromstring(data).tag == "{http://www.w3.org/2000/svg}svg"
