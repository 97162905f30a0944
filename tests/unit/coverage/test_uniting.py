"""What several texts are made of one template counts once, in the table and in each report."""

import json
from collections.abc import Sequence
from itertools import accumulate
from pathlib import Path

import pytest

from fbgen.source import TEMPLATE, Origin, Source
from harness import load_program
from harness.verify.coverage import Count, Coverage, load, parse_limits, rows, too_little, united
from harness.verify.coverage.cobertura import cobertura
from harness.verify.coverage.lcov import lcov
from harness.verify.coverage.page import page
from harness.verify.coverage.storing import as_text
from tests.unit.coverage.programs import BELT, belt

Line = tuple[int, str]
"""A line of a block, and the line of the template that it is from."""

HEAD: Sequence[Line] = (
    (1, 'FUNCTION_BLOCK "Valves"'),
    (2, "VAR_INPUT open, ready : BOOL; END_VAR VAR a, b, copy : BOOL; END_VAR"),
    (3, "BEGIN"),
)
TAIL: Sequence[Line] = ((9, "END_FUNCTION_BLOCK"),)
A: Sequence[Line] = ((4, "IF #open AND #ready THEN"), (5, "#a := TRUE;"), (6, "END_IF;"))
B: Sequence[Line] = ((4, "IF #open AND #ready THEN"), (5, "#b := TRUE;"), (6, "END_IF;"))
COPY: Sequence[Line] = ((5, "#copy := #open;"),)


def generated(
    coverage: Coverage, name: str, lines: Sequence[Line], calls: Sequence[tuple[bool, bool]]
) -> None:
    """Call a block that is made of these lines."""
    whole = (*HEAD, *lines, *TAIL)
    starts = accumulate((len(text) + 1 for _, text in whole), initial=0)
    origins = [
        (start, Origin(TEMPLATE, "Valves.scl.jinja", number))
        for start, (number, _) in zip(starts, whole, strict=False)
    ]
    source = Source(name, "".join(f"{text}\n" for _, text in whole), tuple(origins))
    block = load_program([source], probes=[coverage]).instance("Valves")
    for opened, ready in calls:
        block(open=opened, ready=ready)


@pytest.fixture
def two() -> Coverage:
    """A plant with one valve that is opened, and one with two that stay as they are."""
    coverage = Coverage()
    generated(coverage, "one.scl", A, [(True, True), (False, True)])
    generated(coverage, "two.scl", (*B, *A), [(False, False), (True, False)])
    return coverage


def test_a_place_of_the_template_is_reached_if_any_text_was_reached_there(two: Coverage) -> None:
    (block,) = united(two)
    assert len(block.texts) == 2
    # the first expansion is reached in one.scl, the second one's inside nowhere
    assert block.totals.statement == Count(3, 4)
    assert block.totals.branch == Count(3, 4)
    (found,) = (item for item in block.missing_in(block.texts[0]) if item.kind == "statement")
    assert block.texts[0].file.name == "two.scl"
    assert found.place.line == 8
    assert not block.missing_in(block.texts[1])


def test_a_condition_is_shown_by_the_vectors_of_all_texts(two: Coverage) -> None:
    (block,) = united(two)
    # open decides in one.scl; ready in TRUE, TRUE of one.scl with TRUE, FALSE of two.scl
    assert block.totals.mcdc == Count(2, 4)


def test_a_statement_that_one_text_has_counts_beside_the_others() -> None:
    coverage = Coverage()
    generated(coverage, "one.scl", A, [(True, True)])
    generated(coverage, "copies.scl", (*A[:2], *COPY, A[2]), [])
    (block,) = united(coverage)
    assert block.totals.statement == Count(2, 3)
    generated(coverage, "other.scl", (*COPY, *A), [])
    (block,) = united(coverage)
    assert block.totals.statement == Count(2, 4), "outside of the IF it is another one"


def test_texts_of_a_person_stay_apart() -> None:
    coverage = belt({"stop": True})
    load_program([Source("belt.scl", BELT.replace("> 100", "> 50"))], probes=[coverage])
    both = united(coverage)
    assert [len(block.texts) for block in both] == [1, 1]
    assert sum(block.totals.statement.total for block in both) == 26


def test_table_demand_and_reports_say_the_same(two: Coverage) -> None:
    row, total = rows(two)
    assert row[0] == "Valves (2 texts)"
    assert row[2].split() == total[2].split() == ["75", "%", "3/4"]
    assert row[5] == "8 of tia"
    (found,) = too_little(two, parse_limits("statement=80"))
    assert "75.0 % (3 of 4)" in found.message
    records = lcov(two)
    assert "SF:two.scl" in records
    assert "SF:one.scl" not in records, "two.scl has all that it has"
    assert "DA:5,1" in records
    assert "LF:4\nLH:3" in records
    assert 'lines-covered="3" lines-valid="4"' in cobertura(two)
    assert 'branches-covered="3" branches-valid="4"' in cobertura(two)
    data = json.loads(page(two).partition('type="application/json">')[2].partition("</script>")[0])
    assert data["totals"]["statement"] == [3, 4]
    assert data["blocks"][0]["texts"] == [0, 1]
    assert data["texts"][1]["statements"] == [[4, 4, 2, True], [5, 5, 1, True]]
    assert data["texts"][0]["statements"][1] == [5, 5, 0, True], "reached, in the other text"


def test_it_stays_so_in_the_file(two: Coverage, tmp_path: Path) -> None:
    path = tmp_path / "coverage.json"
    path.write_text(as_text(two), encoding="utf-8")
    assert rows(load(path)) == rows(two)
    assert as_text(load(path)) == as_text(two)
