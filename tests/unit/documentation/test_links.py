"""Links of all pages lead somewhere, and the index leads to every page."""

import re
from pathlib import Path

from tests.unit.documentation.markdown import ROOT, anchors_of, links_of, pages, prose, text_of

INDEX = "docs/README.md"


def target_of(page: str, link: str) -> tuple[str, str]:
    """The file that a link names, from the root of the project, and the place in it."""
    name, _, anchor = link.partition("#")
    path = (pages()[page].parent / name).resolve() if name else pages()[page]
    return path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else "", anchor


def inner_links(page: str) -> list[str]:
    return [link for link in links_of(page) if not link.startswith(("https://", "mailto:"))]


def test_every_link_leads_to_a_file_and_a_heading_that_there_are() -> None:
    broken = []
    for page in pages():
        for link in inner_links(page):
            target, anchor = target_of(page, link)
            if not target or not (ROOT / target).exists():
                broken.append(f"{page}: no file {link}")
            elif anchor and anchor not in anchors_of(target):
                broken.append(f"{page}: no heading {link}")
    assert broken == []


def test_from_the_index_every_page_of_the_documentation_is_found() -> None:
    found, left = {INDEX}, [INDEX]
    while left:
        page = left.pop()
        for target in {target_of(page, link)[0] for link in inner_links(page)} & set(pages()):
            if target not in found:
                found.add(target)
                left.append(target)
    lost = [page for page in pages() if page.startswith("docs/") and page not in found]
    assert lost == []


def test_the_index_names_every_page_that_is_no_part_of_a_list() -> None:
    parts = ("docs/reference/diagnostics/", "docs/decisions/0")
    named = {target_of(INDEX, link)[0] for link in inner_links(INDEX)}
    wanted = {page for page in pages() if page.startswith("docs/") and not page.startswith(parts)}
    assert sorted(wanted - named - {INDEX}) == []


def test_the_readme_leads_to_the_index() -> None:
    assert INDEX in {target_of("README.md", link)[0] for link in inner_links("README.md")}


def test_every_page_begins_with_its_title() -> None:
    assert [page for page in pages() if not text_of(page).startswith("# ")] == []


def test_every_row_of_a_table_has_as_many_cells_as_its_head() -> None:
    odd = []
    for page in pages():
        cells = 0
        for line in prose(page).splitlines():
            here = len(re.findall(r"(?<!\\)\|", line)) if line.startswith("|") else 0
            if here and cells and here != cells:
                odd.append(f"{page}: {line}")
            cells = here
    assert odd == []


def test_no_file_is_left_in_the_scratch_folders_of_pages_that_are_gone() -> None:
    folders = (Path(__file__).parent / "scratch").iterdir()
    assert {folder.name for folder in folders} <= {Path(page).stem for page in pages()}
