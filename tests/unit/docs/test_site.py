"""The site as files: complete, the same each time, small."""

import re
from dataclasses import replace

from fbgen.docs.document import Code, Page, Paragraph, Section, Tool
from fbgen.docs.html import html_site
from fbgen.docs.site import Site


def test_the_same_site_gives_the_same_bytes(site: Site, files: dict[str, bytes]) -> None:
    assert html_site(site) == files


def test_a_page_needs_nothing_but_what_lies_beside_it(files: dict[str, bytes]) -> None:
    needed = re.compile(rb'(?:src|href)="([^"#]+)')
    for name, data in files.items():
        if name.endswith(".html"):
            assert {path.decode() for path in needed.findall(data)} <= set(files), name


def test_the_site_of_the_whole_catalogue_stays_under_5_mb(files: dict[str, bytes]) -> None:
    assert sum(map(len, files.values())) < 5_000_000


def test_no_text_can_become_markup(site: Site) -> None:
    evil = "</script><script>alert(1)</script> & <b>"
    data = {"comnos": [["FA00", evil, "", 1, 0, 1]], "first": "FA00"}
    section = Section("A", (Paragraph((evil, Code(evil))), Tool("converter", data)), "a")
    page = Page("evil", evil, "Words", (evil,), (section,))
    text = html_site(replace(site, pages=(page,)))["evil.html"].decode()
    assert text.count("<script") == 3
    assert "<b>" not in text
