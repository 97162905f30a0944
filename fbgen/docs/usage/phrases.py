"""Uses as phrases: by blocks, each with its lines."""

from collections.abc import Iterable

from fbgen.docs.document import Code, Link, Phrase, Strong
from fbgen.docs.page_names import block_page
from fbgen.docs.texts import listed
from fbgen.docs.usage import Use


def by_block(uses: Iterable[Use]) -> Phrase:
    """`TOS_Drive sets 229, reads 118, 142`, with a link to the block's page."""
    rows: dict[tuple[str, str, bool], dict[str, list[int]]] = {}
    for use in uses:
        lines = rows.setdefault((use.block, use.file, use.own), {}).setdefault(use.does, [])
        if use.line not in lines:
            lines.append(use.line)
    return listed(
        (_name(block, file, own), f" {_done(done)}") for (block, file, own), done in rows.items()
    )


def places(uses: Iterable[Use]) -> Phrase:
    """`TOS_Drive.scl:229, TOS_Line.scl:159`."""
    return listed((Code(f"{use.file}:{use.line}"),) for use in uses)


def _name(block: str, file: str, own: bool) -> Strong | Link:
    return Strong(f"{block} ({file})") if own else Link(block, block_page(block))


def _done(done: dict[str, list[int]]) -> str:
    return ", ".join(f"{does} {', '.join(map(str, lines))}" for does, lines in done.items())
