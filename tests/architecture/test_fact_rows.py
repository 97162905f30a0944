"""Every behaviour row of the manuals is shown by a test that names it.

The ids stand in `facts_rows.txt`. A row that only a slow test names does not count: `make test`
would not show it.
"""

from collections import Counter
from pathlib import Path

import pytest

from tests.fact_marks import FACTS, FactMark

ROWS = Path(__file__).with_name("facts_rows.txt")


def rows() -> list[str]:
    lines = ROWS.read_text(encoding="utf-8").splitlines()
    return [line.split()[0] for line in lines if line and not line.startswith("#")]


@pytest.fixture
def marks(request: pytest.FixtureRequest) -> list[FactMark]:
    """All marks of the tests that were collected."""
    config = request.config
    whole = [config.rootpath / path for path in config.getini("testpaths")]
    if [config.rootpath / path for path in config.args] != whole:
        pytest.skip("only a run of all tests can tell which rows nobody names")
    return config.stash[FACTS]


def test_every_row_is_named_by_a_test(marks: list[FactMark]) -> None:
    named = {row for row, _ in marks}
    assert [row for row in rows() if row not in named] == []


def test_no_test_names_a_row_that_does_not_exist(marks: list[FactMark]) -> None:
    known = set(rows())
    assert [f"{test} names {row}" for row, test in marks if row not in known] == []


def test_no_row_stands_twice_and_each_says_what_it_is_about() -> None:
    assert [row for row, count in Counter(rows()).items() if count > 1] == []
    lines = ROWS.read_text(encoding="utf-8").splitlines()
    assert [line for line in lines if line and len(line.split()) < 3] == []
