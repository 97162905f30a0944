"""Scenario files as tests of pytest: node ids, selection, failures, processes."""

import subprocess
import sys

import pytest

from tests.unit.scenario.block_scenarios import HEAD, TANK

pytest_plugins = ["pytester"]

TABLE = """\
tags: [water]
seeds: 2
cases:
  low: {level: 10, runs: true}
  full: {level: 80, runs: false}
steps:
  - set: {block.start: true, block.level: "${level}"}
  - wait: 100 ms
  - expect: {block.pump: "${runs}"}
"""
PLUGIN = ("-p", "harness.pytest_plugin", "-p", "no:cacheprovider")


@pytest.fixture
def tank(pytester: pytest.Pytester) -> pytest.Pytester:
    """A folder with a block and a scenario file of four runs."""
    (pytester.path / "tank.scl").write_text(TANK, "utf-8")
    (pytester.path / "tank.scenario.yaml").write_text(HEAD + TABLE, "utf-8")
    return pytester


def test_each_row_and_seed_is_a_test_of_its_own(tank: pytest.Pytester) -> None:
    result = tank.runpytest(*PLUGIN, "-v")
    result.assert_outcomes(passed=4)
    result.stdout.fnmatch_lines(["tank.scenario.yaml::full-seed1 PASSED*"])


@pytest.mark.parametrize(
    ("arguments", "count"),
    [
        (["tank.scenario.yaml::low-seed0"], 1),
        (["-k", "full"], 2),
        (["-k", "water and not seed1"], 2),
        (["--fbgen-seed", "7"], 2),
    ],
)
def test_tests_are_chosen_as_usual(tank: pytest.Pytester, arguments: list[str], count: int) -> None:
    tank.runpytest(*PLUGIN, *arguments).assert_outcomes(passed=count)


def test_a_failure_has_the_text_of_fbgen_test(tank: pytest.Pytester) -> None:
    path = tank.path / "tank.scenario.yaml"
    path.write_text(path.read_text("utf-8").replace("runs: true", "runs: false"), "utf-8")
    result = tank.runpytest(*PLUGIN, "-k", "low and seed0")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(
        [
            "error?FB8001?: block.pump is true, expected false",
            "* --> tank.scenario.yaml:12:14",
            "run it again: fbgen test tank.scenario.yaml --seed 0 -k '\"?low?\"'",
        ]
    )


def test_a_mistake_in_a_file_is_an_error_of_collecting_it(tank: pytest.Pytester) -> None:
    (tank.path / "tank.scenario.yaml").write_text(HEAD + "stps: []\n", "utf-8")
    result = tank.runpytest(*PLUGIN)
    result.assert_outcomes(errors=1)
    result.stdout.fnmatch_lines(["*error?FB1005?: the key 'stps' is not known here*"])


def test_expected_failures_and_properties_that_show_nothing(tank: pytest.Pytester) -> None:
    text = "expect_failure: the pump is broken\nsteps:\n  - expect: {block.pump: true}\n"
    (tank.path / "tank.scenario.yaml").write_text(HEAD + text, "utf-8")
    tank.runpytest(*PLUGIN).assert_outcomes(xfailed=1)
    text = "properties:\n  - at_most: 0\n    per: 1 s\n    of: {block.pump: true}\n"
    path = tank.path / "tank.scenario.yaml"
    path.write_text(f"{HEAD}{text}steps:\n  - wait: 1 s\n", "utf-8")
    tank.runpytest(*PLUGIN, "-W", "default").assert_outcomes(passed=1, warnings=1)


def test_it_works_in_several_processes(tank: pytest.Pytester) -> None:
    result = tank.runpytest_subprocess(*PLUGIN, "-n", "2")
    result.assert_outcomes(passed=4)


def test_the_plugin_imports_nothing_that_costs() -> None:
    code = (
        "import sys, harness.pytest_plugin\n"
        "heavy = {name for name in sys.modules if name.startswith(('fbgen', 'harness.', 'pyda'))}\n"
        "print(*(heavy - {'harness.pytest_plugin'}))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.stdout.strip(), done.stderr) == ("", "")
