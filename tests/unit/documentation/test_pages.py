"""Every page does what it says: its files, commands and programs, in the order of the page."""

from itertools import pairwise
from pathlib import Path

import pytest

from tests.unit.documentation.fragments import DIALECTS, PROBLEMS, problems_of
from tests.unit.documentation.markdown import blocks_of, pages, text_of
from tests.unit.documentation.rehearsal import UNREAD, follow

MESSAGES = "docs/reference/diagnostics/"
KNOWN = {*DIALECTS, *PROBLEMS, "console", "diff", *UNREAD}
APART = {
    "docs/reference/scenario-files.md": "tests/unit/scenario/test_scenario_page.py",
    "docs/reference/trace.md": "tests/unit/trace/test_trace_page.py",
}
"""Pages whose code needs a stage of its own, and who sets it."""
FOLLOWED = [
    page
    for page in pages()
    if not page.startswith(MESSAGES) and blocks_of(page) and page not in APART
]


@pytest.mark.parametrize("page", FOLLOWED)
def test_a_page_works_as_it_stands_there(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    follow(page, tmp_path, capsys)


def test_every_code_block_says_its_language() -> None:
    shown = [block for page in pages() for block in blocks_of(page)]
    assert [block.place for block in shown if block.language not in KNOWN] == []


def test_no_code_stands_outside_of_fences() -> None:
    indented = []
    for page in pages():
        lines = _prose(page)
        for before, line in pairwise(lines):
            is_list = line.lstrip().startswith(("-", "*", "|"))
            if not before.strip() and line.startswith("    ") and not is_list:
                indented.append(f"{page}: {line}")
    assert indented == []


def _prose(page: str) -> list[str]:
    inside, lines = False, []
    for line in text_of(page).splitlines():
        is_fence = line.lstrip().startswith("```")
        inside ^= is_fence
        lines.append("-" if inside or is_fence else line)
    return lines


def test_what_a_message_page_calls_right_is_right() -> None:
    wrong = {}
    for page in pages():
        if not page.startswith(MESSAGES):
            continue
        fixed = text_of(page).count("\n", 0, text_of(page).index("## Fixed"))
        for block in blocks_of(page):
            is_read = block.language not in {"console", *UNREAD}
            if is_read and block.line > fixed:
                wrong[block.place] = problems_of(block.language, block.text)
    assert {place: found for place, found in wrong.items() if found} == {}
