"""The HTML report of a run with 100,000 events: made, and drawn in headless Chromium."""

import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from playwright.sync_api import Page, sync_playwright

from bench.measuring import Figure, measure
from harness.report.page import html_report
from harness.results import ScenarioReport
from tests.unit.report.results import PASSED
from tests.unit.report.traces import long_trace

_EVENTS = 100_000
_PICTURES = 20
_KEYS = {
    "drawing all of them": "0",
    "drawing a 32nd of them": "Shift+ArrowRight",
}


def figures() -> Iterator[Figure]:
    """What whoever asks for the page waits for, and whoever looks at it."""
    report = ScenarioReport((replace(PASSED, observations=(long_trace(_EVENTS),)),))
    made = measure("HTML report, 100,000 events", lambda: html_report(report), per=1, windows=5)
    yield made
    page = html_report(report)
    print(f"  {len(page) / 1e6:.2f} MB")
    for name, milliseconds in _drawn(page):
        seconds = milliseconds / 1000
        yield Figure(name, seconds, seconds / made.seconds * made.turns, "at most 16 ms")


def _drawn(text: str) -> Iterator[tuple[str, float]]:
    program = shutil.which("chromium") or shutil.which("google-chrome")
    if program is None:
        print("  no Chromium on the path: drawing is not measured")
        return
    with TemporaryDirectory() as folder, sync_playwright() as playwright:
        path = Path(folder) / "report.html"
        path.write_text(text, encoding="utf-8")
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1400, "height": 900})
        page.goto(path.as_uri())
        for name, key in _KEYS.items():
            if key != "0":
                for _ in range(5):
                    page.locator(".stage").press("+")
            yield name, median(_draw_ms(page, key) for _ in range(_PICTURES))
        browser.close()


def _draw_ms(page: Page, key: str) -> float:
    page.locator(".stage").press(key)
    page.wait_for_timeout(60)
    return float(page.evaluate("performance.getEntriesByName('fbgen draw')[0].duration"))
