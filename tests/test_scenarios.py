"""Every scenario file of the project, one test for each of its variations.

The behaviour rows that a file names under `facts` are marks of its tests.
"""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from harness.scenario import ScenarioCase, find_scenarios, run_case, scenario_cases

ROOT = Path(__file__).parents[1]
FILES = find_scenarios([ROOT / "tests" / "scenarios", ROOT / "examples"])


def parameters() -> list[object]:
    """The cases of all files with their ids and marks."""
    return [
        pytest.param(
            case,
            id=f"{path.name.partition('.')[0]}{case.changes.replace(', ', '-')}",
            marks=[pytest.mark.fact(row) for row in case.scenario.facts],
        )
        for path in FILES
        for case in scenario_cases(path)
    ]


@pytest.mark.parametrize("case", parameters())
def test_scenario(case: ScenarioCase) -> None:
    result = run_case(case, load_catalog())
    assert result.passed, result.render()


def test_titles_tell_scenarios_apart() -> None:
    titles = [case.name for path in FILES for case in scenario_cases(path)]
    assert sorted(titles) == sorted(set(titles))
