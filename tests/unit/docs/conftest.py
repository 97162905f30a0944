"""The site of the shipped catalogue, built once, and a browser that opens it."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from fbgen.catalog import load_catalog
from fbgen.docs.examples import example_programs
from fbgen.docs.html import html_site
from fbgen.docs.site import Site, build_site
from fbgen.docs.subject import Subject, whole_catalogue
from tests.browser import opened_pages


@pytest.fixture(scope="session")
def subject() -> Subject:
    """The whole catalogue, with the blocks of the example plants."""
    catalog = load_catalog()
    return whole_catalogue(catalog, tuple(example_programs(catalog)))


@pytest.fixture(scope="session")
def site(subject: Subject) -> Site:
    """The pages of the whole catalogue."""
    return build_site(subject, "1.2.3")


@pytest.fixture(scope="session")
def files(site: Site) -> dict[str, bytes]:
    """The same as HTML."""
    return html_site(site)


@pytest.fixture(scope="session")
def folder(files: dict[str, bytes], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same on disk."""
    place = tmp_path_factory.mktemp("site")
    for name, data in files.items():
        (place / name).write_bytes(data)
    return place


@pytest.fixture
def shown(chromium: Browser, folder: Path) -> Iterator[Callable[..., Page]]:
    """`shown("vf-s11.command", fragment="#v=C400", width=..., dark=...)`: a page of the site."""
    with opened_pages(chromium) as opened:
        yield lambda name, **how: opened(folder / f"{name}.html", **how)
