"""Headless Chromium for pages that we make. It must neither complain nor ask a network."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
Opened = Callable[..., Page]


@contextmanager
def headless_chromium() -> Iterator[Browser]:
    """A browser without a window; what needs it is skipped where there is none."""
    program = next(filter(None, map(shutil.which, _NAMES)), None)
    if program is None:
        pytest.skip("no Chromium on the path: pages are not tried in a browser")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield browser
        browser.close()


@contextmanager
def opened_pages(chromium: Browser) -> Iterator[Opened]:
    """`opened(path, fragment=..., width=..., dark=...)`: a file as somebody opens it.

    At the end nothing may have been logged or failed, and no address outside of the file's own
    folder have been asked for.
    """
    trouble: list[str] = []
    pages: list[Page] = []

    def opened(path: Path, fragment: str = "", width: int = 1400, dark: bool = False) -> Page:
        scheme = "dark" if dark else "light"
        page = chromium.new_page(
            viewport={"width": width, "height": 900}, color_scheme=scheme, has_touch=True
        )
        pages.append(page)
        folder = path.parent.as_uri()
        page.on("console", lambda message: trouble.append(message.text))
        page.on("pageerror", lambda error: trouble.append(str(error)))
        page.on("requestfailed", lambda request: trouble.append(f"failed: {request.url}"))
        page.on(
            "request",
            lambda request: None if request.url.startswith(folder) else trouble.append(request.url),
        )
        page.goto(path.as_uri() + fragment)
        return page

    yield opened
    for page in pages:
        page.close()
    assert trouble == []
