"""Reports in headless Chromium; skipped where there is none."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page

from harness.report.page import html_report
from harness.results import ScenarioReport
from tests.browser import opened_pages


@pytest.fixture
def shown(chromium: Browser, tmp_path: Path) -> Iterator[Callable[..., Page]]:
    """`shown(report, width=..., dark=...)`: the page of a report, as somebody opens it.

    It asks for no other file.
    """
    requests: list[str] = []

    with opened_pages(chromium) as opened:

        def show(report: ScenarioReport, width: int = 1400, dark: bool = False) -> Page:
            path = tmp_path / "report.html"
            path.write_text(html_report(report), "utf-8", newline="\n")
            page = opened(path, width=width, dark=dark)
            page.on("request", lambda request: requests.append(request.url))
            return page

        yield show
    assert requests == []
