"""What the search of the site finds: pages, sections and rows, each with where it lies."""

import json
from collections.abc import Iterable, Iterator

from fbgen.docs.document import Page, Table, plain


def search_script(pages: Iterable[Page]) -> str:
    """A script that holds the index: a page from disk may load scripts, but no data."""
    rows = [list(entry) for page in pages for entry in _entries(page)]
    text = json.dumps(rows, ensure_ascii=False, separators=(",", ":"))
    return f"window.fbgenIndex={text};\n"


def _entries(page: Page) -> Iterator[tuple[str, str, str]]:
    """Text, place and the page's title."""
    address = f"{page.id}.html"
    yield (page.found_by or page.title), address, page.title
    for section in page.sections:
        for block in section.blocks:
            if not isinstance(block, Table):
                continue
            for row in block.rows:
                if row.anchor and row.found_by:
                    yield row.found_by, f"{address}#{row.anchor}", page.title
                elif row.anchor:
                    yield plain(row.cells[0]), f"{address}#{row.anchor}", page.title
