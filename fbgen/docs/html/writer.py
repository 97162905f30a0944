"""A site as files: one page each, a style, a script, the index of the search.

The pages need each other by relative links only, so the folder can be opened from disk, put on any
server, or packed. Their policy forbids everything but what lies beside them.
"""

import json
from collections.abc import Iterable, Sequence
from functools import cache
from itertools import groupby
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from fbgen.docs.document import Page
from fbgen.docs.html.phrases import phrase_html
from fbgen.docs.html.search_index import search_script
from fbgen.docs.html.svg import svg
from fbgen.docs.site import Site
from fbgen.resources import shipped

_SCRIPTS = ("numbers.js", "frames.js", "decoder.js", "converter.js", "search.js", "page.js")
_STYLES = ("colours.css", "site.css", "print.css")


def html_site(site: Site) -> dict[str, bytes]:
    """Name of each file -> its bytes. The same site gives the same bytes."""
    template = _environment().get_template("page.html.jinja")
    menu = _menu(site.pages)
    files = {}
    for page in site.pages:
        text = template.render(
            site=site, page=page, menu=menu, script_names=_SCRIPTS, kind=_kind, data=_data
        )
        files[f"{page.id}.html"] = text.encode()
    files["site.css"] = _joined(_STYLES)
    files["site.js"] = b'(() => {\n"use strict";\n' + _joined(_SCRIPTS) + b"})();\n"
    files["index.js"] = search_script(site.pages).encode()
    return files


def _menu(pages: Sequence[Page]) -> list[tuple[str, list[Page]]]:
    """Groups in the order of the pages."""
    return [(group, list(row)) for group, row in groupby(pages, lambda page: page.group)]


def _kind(block: object) -> str:
    """What the template calls a block."""
    return type(block).__name__.lower()


def _data(data: object) -> Markup:
    """JSON that may stand between script tags."""
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    return Markup(text.replace("<", "\\u003c"))


def _joined(names: Iterable[str]) -> bytes:
    return b"".join((_folder() / name).read_bytes() for name in names)


@cache
def _folder() -> Path:
    return shipped("templates") / "docs" / "site"


@cache
def _environment() -> Environment:
    environment = Environment(
        loader=FileSystemLoader(_folder(), encoding="utf-8"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["phrase"] = phrase_html
    environment.globals["svg"] = svg
    return environment
