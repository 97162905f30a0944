"""A site as Markdown: a file for each page, one for each picture, and a list of all pages."""

from collections.abc import Iterator, Sequence
from itertools import groupby

from fbgen.docs.document import (
    Block,
    Bullets,
    Facts,
    Figure,
    Page,
    Paragraph,
    Sample,
    Section,
    Table,
    Tool,
)
from fbgen.docs.html.svg import svg_file
from fbgen.docs.markdown.phrases import phrase_markdown, plain_markdown
from fbgen.docs.site import Site

MENU = "_Sidebar.md"
"""As the wikis of GitHub and GitLab call the list beside every page."""


def markdown_site(site: Site) -> dict[str, bytes]:
    """Name of each file -> its bytes. The same site gives the same bytes."""
    files: dict[str, bytes] = {}
    for page in site.pages:
        pictures: dict[str, bytes] = {}
        text = "\n".join(_page(page, pictures)).rstrip() + "\n"
        files[f"{page.id}.md"] = text.encode()
        files |= pictures
    files[MENU] = ("\n".join(_menu(site)) + "\n").encode()
    return files


def _menu(site: Site) -> Iterator[str]:
    yield f"# {plain_markdown(site.title)}"
    for group, pages in groupby(site.pages, lambda page: page.group):
        yield from ("", f"## {plain_markdown(group)}", "")
        for page in pages:
            yield f"- [{plain_markdown(page.title)}]({page.id}.md)"


def _page(page: Page, pictures: dict[str, bytes]) -> Iterator[str]:
    yield from (f"# {plain_markdown(page.title)}", "", phrase_markdown(page.lead), "")
    for section in page.sections:
        blocks = [block for block in section.blocks if not isinstance(block, Tool)]
        if blocks:
            yield from _section(section, blocks, page, pictures)


def _section(
    section: Section, blocks: Sequence[Block], page: Page, pictures: dict[str, bytes]
) -> Iterator[str]:
    yield f'<a id="{section.anchor}"></a>'
    yield from ("", f"## {plain_markdown(section.title)}", "")
    for block in blocks:
        if isinstance(block, Figure):
            name = f"{page.id}-{len(pictures) + 1}.svg"
            pictures[name] = svg_file(block.drawing, block.title)
            yield from (f"![{plain_markdown(block.title)}]({name})", "")
        else:
            yield from _block(block)


def _block(block: Block) -> Iterator[str]:
    if isinstance(block, Paragraph):
        text = phrase_markdown(block.phrase)
        yield from (f"> {text}" if block.tone else text, "")
    elif isinstance(block, Bullets):
        yield from (f"- {phrase_markdown(item)}" for item in block.items)
        yield ""
    elif isinstance(block, Facts):
        yield from ("| | |", "|---|---|")
        for title, phrase in block.rows:
            yield f"| {plain_markdown(title)} | {phrase_markdown(phrase)} |"
        yield ""
    elif isinstance(block, Sample):
        yield from (f"```{block.language}", block.text, "```", "")
    elif isinstance(block, Table):
        yield from _table(block)


def _table(table: Table) -> Iterator[str]:
    if table.title:
        yield from (f"**{plain_markdown(table.title)}**", "")
    yield f"| {' | '.join(map(plain_markdown, table.columns))} |"
    yield f"|{'---|' * len(table.columns)}"
    for row in table.rows:
        cells = [phrase_markdown(cell) for cell in row.cells]
        if row.anchor:
            cells[0] = f'<a id="{row.anchor}"></a>{cells[0]}'
        yield f"| {' | '.join(cells)} |"
    yield ""
