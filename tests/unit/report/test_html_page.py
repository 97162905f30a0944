"""The HTML report as a text: whole by itself, harmless, always the same, whatever is in it."""

import re
from base64 import b64encode
from dataclasses import replace
from hashlib import sha256
from html.parser import HTMLParser

from fbgen.diagnostics import render
from harness.report.page import Table, html_report
from harness.results import ScenarioReport
from harness.trace import Channel
from tests.unit.report.results import EXPECTED, FAILED, PASSED, SESSION, WARNED
from tests.unit.report.traces import short_trace

HOSTILE = "</script><script>alert(1)</script><!--"


class Elements(HTMLParser):
    """All elements of a page with their attributes, and its text."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text += data


def test_the_page_names_no_other_file_and_no_address() -> None:
    result = replace(FAILED, observations=(short_trace(),))
    page = html_report(ScenarioReport((result,)))
    elements = Elements(page).found
    assert not [tag for tag, _ in elements if tag in {"link", "img", "iframe", "object", "base"}]
    assert not [found for _, found in elements if found.keys() & {"src", "href", "style"}]
    assert not re.findall(r"https?:|url\(|@import|fetch\(|XMLHttpRequest|WebSocket", page)


def test_the_policy_allows_this_script_and_this_style_alone() -> None:
    page = html_report(SESSION)
    (policy,) = re.findall(r'Content-Security-Policy" content="([^"]*)"', page)
    parts = {
        "script": re.findall(r"<script>(.*)</script>", page, re.DOTALL)[-1],
        "style": re.findall(r"<style>(.*)</style>", page, re.DOTALL)[0],
    }
    hashes = {
        name: b64encode(sha256(text.encode()).digest()).decode() for name, text in parts.items()
    }
    assert policy.replace("&#39;", "'") == (
        f"default-src 'none'; script-src 'sha256-{hashes['script']}'; "
        f"style-src 'sha256-{hashes['style']}'"
    )


def test_texts_of_users_stay_texts() -> None:
    trace = short_trace()
    trace = replace(
        trace, title=HOSTILE, channels=(*trace.channels, Channel(HOSTILE, HOSTILE, "text", "plc"))
    )
    result = replace(FAILED, name=HOSTILE, file=HOSTILE, observations=(trace,))
    scripts = [
        tag for tag, _ in Elements(html_report(ScenarioReport((result,)))).found if tag == "script"
    ]
    assert len(scripts) == 2


def test_results_and_failures_can_be_read_without_the_script() -> None:
    text = Elements(html_report(SESSION, ("seed 7 for all",))).text
    for expected in ("2 failed", "1 passed", "2.900 s", "seed 7 for all", FAILED.replay):
        assert expected in text
    for failure in FAILED.failures:
        assert render(failure) in text


def test_what_was_expected_to_fail_and_warnings_are_shown_as_such() -> None:
    page = html_report(ScenarioReport((EXPECTED, WARNED)))
    text = Elements(page).text
    assert "2 passed" in text
    assert "0 failed" in page
    assert "Failed as expected: the line is not repaired yet" in text
    assert "warning[FB8021]: nothing was decided" in text


def test_the_same_results_give_the_same_page() -> None:
    first = html_report(ScenarioReport((replace(PASSED, observations=(short_trace(),)),)))
    again = html_report(ScenarioReport((replace(PASSED, observations=(short_trace(),)),)))
    assert first == again


def test_a_session_that_ctrl_c_ended_says_so() -> None:
    assert "stopped by Ctrl-C" in Elements(html_report(ScenarioReport((PASSED,), True))).text


def test_tables_about_the_session_stand_below_the_scenarios() -> None:
    table = Table("Coverage", ("block", "statements"), [("TOS_Line", "91 % of <100>")])
    text = Elements(html_report(SESSION, tables=(table,))).text
    assert text.index("91 % of <100>") > text.index(PASSED.name)
    assert "TOS_Line" in text
