"""One file, many runs: a table of cases, seeds, and failures that are expected."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.scenario import RunOptions, run_paths, scenario_cases
from tests.unit.scenario.block_scenarios import only_failure, tank, tank_file, tanks

TABLE = """\
cases:
  low: {level: 10, runs: true, word: start}
  full: {level: 80, runs: false, word: start}
steps:
  - set: {"block.${word}": true, block.level: "${level}"}
  - expect: {block.pump: "${runs}"}
    within: 60 ms
    stays_for: 100 ms
"""


def test_each_row_runs_with_its_values_and_its_name(tmp_path: Path) -> None:
    results = tanks(tmp_path, TABLE)
    assert [(item.name, item.passed) for item in results] == [
        ("Tank [low]", True),
        ("Tank [full]", True),
    ]
    assert results[1].replay.endswith("""--seed 0 -k '"[full]"'""")


def test_a_row_is_chosen_by_its_name(tmp_path: Path) -> None:
    report = run_paths([tank_file(tmp_path, TABLE)], RunOptions(select='"[full]"'))
    assert [item.name for item in report.results] == ["Tank [full]"]


def test_a_value_is_checked_as_what_it_stands_for(tmp_path: Path) -> None:
    results = tanks(tmp_path, TABLE.replace("level: 80", "level: high"))
    assert (results[0].passed, results[1].passed) == (True, False)
    assert only_failure(results[1]).message == "block.level is of type INT and never 'high'"


def test_what_is_wrong_in_one_row_is_told_with_its_name(tmp_path: Path) -> None:
    text = TABLE.replace("within: 60 ms", "within: ${level} ms").replace("level: 80", "level: x")
    with pytest.raises(DiagnosticError) as failure:
        scenario_cases(tank_file(tmp_path, text))
    (found,) = failure.value.diagnostics
    assert found.message.startswith("'x ms' is no time")
    assert [note.message for note in found.notes] == ["with the case full"]


def test_two_rows_of_one_name_are_told(tmp_path: Path) -> None:
    with pytest.raises(DiagnosticError) as failure:
        scenario_cases(tank_file(tmp_path, TABLE.replace("full:", "low:")))
    assert [item.code for item in failure.value.diagnostics] == ["FB1004"]


def test_without_a_table_there_is_nothing_to_fill_in(tmp_path: Path) -> None:
    with pytest.raises(DiagnosticError) as failure:
        scenario_cases(tank_file(tmp_path, "steps:\n  - expect: {block.level: '${level}'}\n"))
    (found,) = failure.value.diagnostics
    assert (found.code, found.help[:27]) == ("FB8015", "write a table cases: with r")


@pytest.mark.parametrize(
    ("text", "seeds"),
    [("seeds: 3\n", [0, 1, 2]), ("seed: 7\nseeds: 2\n", [7, 8]), ("seeds: [9, 4]\n", [9, 4])],
)
def test_a_scenario_runs_once_with_each_seed(tmp_path: Path, text: str, seeds: list[int]) -> None:
    results = tanks(tmp_path, f"{text}steps:\n  - expect: {{block.pump: false}}\n")
    assert [item.seed for item in results] == seeds
    assert [item.name for item in results] == [f"Tank seed {seed}" for seed in seeds]


def test_a_seed_of_the_command_runs_once(tmp_path: Path) -> None:
    path = tank_file(tmp_path, "seeds: 3\nsteps:\n  - expect: {block.pump: true}\n")
    (result,) = run_paths([path], RunOptions(seed=2)).results
    assert (result.seed, result.name) == (2, "Tank")
    again = run_paths([path]).results[2]
    assert (again.seed, again.replay) == (2, result.replay)


@pytest.mark.parametrize("seeds", ["0", "[1, 1]", "[-1]", "true", "1.5", "200000", "[]"])
def test_seeds_that_are_none_are_told(tmp_path: Path, seeds: str) -> None:
    path = tank_file(tmp_path, f"seeds: {seeds}\nsteps:\n  - expect: {{block.pump: false}}\n")
    with pytest.raises(DiagnosticError) as failure:
        scenario_cases(path)
    assert [item.code for item in failure.value.diagnostics] == ["FB1007"]


def test_an_expected_failure_passes_and_keeps_what_failed(tmp_path: Path) -> None:
    text = "expect_failure: the pump is broken\nsteps:\n  - expect: {block.pump: true}\n"
    result = tank(tmp_path, text)
    assert (result.passed, result.expected_failure) == (True, "the pump is broken")
    assert only_failure(result).code == "FB8001"


def test_a_mistake_in_the_file_is_no_expected_failure(tmp_path: Path) -> None:
    text = "expect_failure: the pump is broken\nsteps:\n  - expect: {block.pmp: true}\n"
    result = tank(tmp_path, text)
    assert (result.passed, only_failure(result).code) == (False, "FB8003")


def test_wait_until_goes_on_as_soon_as_it_holds_and_has_a_limit(tmp_path: Path) -> None:
    text = """\
steps:
  - set: {block.start: true}
  - wait_until: {block.pump: true}
    within: LIMIT
  - expect: {block.calls: 6}
"""
    assert tank(tmp_path, text.replace("LIMIT", "1 s")).passed
    failure = only_failure(tank(tmp_path, text.replace("LIMIT", "40 ms")))
    assert failure.message == "block.pump is false after 0.040 s, expected true"
