"""Reports in headless Chromium; skipped where there is none. It must neither complain nor ask."""

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from harness.report.page import html_report
from harness.results import ScenarioReport

_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    """A browser without a window."""
    program = next(filter(None, map(shutil.which, _NAMES)), None)
    if program is None:
        pytest.skip("no Chromium on the path: the HTML report is not tried in a browser")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield browser
        browser.close()


@pytest.fixture
def shown(chromium: Browser, tmp_path: Path) -> Iterator[Callable[..., Page]]:
    """`shown(report, width=..., dark=...)`: the page of a report, as somebody opens it.

    At the end of the test nothing may have been logged, failed, or been asked of a network.
    """
    trouble: list[str] = []
    pages: list[Page] = []

    def show(report: ScenarioReport, width: int = 1400, dark: bool = False) -> Page:
        path = tmp_path / "report.html"
        path.write_text(html_report(report), "utf-8", newline="\n")
        scheme = "dark" if dark else "light"
        page = chromium.new_page(
            viewport={"width": width, "height": 900}, color_scheme=scheme, has_touch=True
        )
        pages.append(page)
        page.on("console", lambda message: trouble.append(message.text))
        page.on("pageerror", lambda error: trouble.append(str(error)))
        page.on("request", lambda request: trouble.append(request.url))
        page.goto(path.as_uri())
        trouble.remove(path.as_uri())
        return page

    yield show
    for page in pages:
        page.close()
    assert trouble == []
