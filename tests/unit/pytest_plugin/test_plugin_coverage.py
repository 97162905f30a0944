"""`--fbgen-coverage`: what scenarios and fixtures of a session reach, of all its processes."""

import json
from pathlib import Path
from typing import Any

import pytest

from tests.unit.pytest_plugin.test_plugin_fixtures import PLANT
from tests.unit.scenario.block_scenarios import HEAD, TANK

pytest_plugins = ["pytester"]

ROOT = Path(__file__).parents[3]
PLUGIN = ("-p", "harness.pytest_plugin", "-p", "no:cacheprovider")
CALLS = 10
"""Of a scenario: one each 10 ms."""
CASES = """\
cases:
  low: {level: 10, runs: true}
  full: {level: 80, runs: false}
steps:
  - set: {block.start: true, block.level: "${level}"}
  - wait: 100 ms
  - expect: {block.pump: "${runs}"}
"""
FIXTURE = """
def test_tank(plc):
    plc("tank.scl").instance("Tank")(start=True)
"""


@pytest.fixture
def tank(pytester: pytest.Pytester) -> pytest.Pytester:
    """A folder with a block, a scenario file of two runs and a test in Python."""
    (pytester.path / "tank.scl").write_text(TANK, "utf-8")
    (pytester.path / "tank.scenario.yaml").write_text(HEAD + CASES, "utf-8")
    pytester.makepyfile(FIXTURE)
    return pytester


def read(path: Path) -> Any:
    """A report in JSON."""
    return json.loads(path.read_text("utf-8"))


def test_scenarios_and_fixtures_count_together_in_one_or_more_processes(
    tank: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    one = tank.runpytest(*PLUGIN, "--fbgen-coverage", "one.json", "--fbgen-coverage", "all/")
    one.assert_outcomes(passed=3)
    one.stdout.fnmatch_lines(["*coverage of the PLC text*", "Tank *tia*"])
    several = tank.runpytest_subprocess(*PLUGIN, "-n", "2", "--fbgen-coverage", "two.json")
    several.assert_outcomes(passed=3)
    several.stdout.fnmatch_lines(["Tank *tia*"])
    assert read(tank.path / "one.json") == read(tank.path / "two.json")
    (file,) = read(tank.path / "one.json")["files"]
    (block,) = file["blocks"]
    assert max(hits for *_, hits in block["statements"]) == 1 + 2 * CALLS
    assert (tank.path / "all" / "index.html").is_file()


def test_too_little_fails_the_session(tank: pytest.Pytester) -> None:
    run = tank.runpytest(*PLUGIN, "--fbgen-coverage-fail-under", "statement=100,mcdc=60")
    run.assert_outcomes(passed=3)
    assert run.ret == pytest.ExitCode.TESTS_FAILED
    run.stdout.fnmatch_lines(["error?FB8052?: the mcdc coverage is 50.0 % *"])
    enough = tank.runpytest(*PLUGIN, "--fbgen-coverage-fail-under", "statement=10")
    assert enough.ret == pytest.ExitCode.OK


@pytest.mark.parametrize(
    ("option", "code"),
    [("--fbgen-coverage=report.txt", "FB8053"), ("--fbgen-coverage-fail-under=x=1", "FB8051")],
)
def test_mistakes_are_said_before_anything_runs(
    tank: pytest.Pytester, option: str, code: str
) -> None:
    run = tank.runpytest(*PLUGIN, option)
    assert run.ret == pytest.ExitCode.USAGE_ERROR
    run.stderr.fnmatch_lines([f"*{code}*"])


def test_a_report_that_cannot_be_written_fails_the_session(tank: pytest.Pytester) -> None:
    (tank.path / "taken").write_text("", "utf-8")
    run = tank.runpytest(*PLUGIN, "--fbgen-coverage", "taken/coverage.json")
    run.assert_outcomes(passed=3)
    assert run.ret == pytest.ExitCode.TESTS_FAILED
    run.stdout.fnmatch_lines(["*cannot be written to taken/coverage.json*"])


def test_the_fixture_plant_is_counted_with_its_catalogue(pytester: pytest.Pytester) -> None:
    pytester.makeini(f"[pytest]\nfbgen_plant = {PLANT.as_posix()}\n")
    pytester.makepyfile("def test_plant(plant):\n    plant.run_for(100_000_000)\n")
    run = pytester.runpytest(*PLUGIN, "--fbgen-coverage", "plant.json")
    run.assert_outcomes(passed=1)
    data = read(pytester.path / "plant.json")
    assert data["exercised"]["bits of the gateway's words"]["reached"] > 0
    assert any(one["plants"] == ["one_drive"] for one in data["files"])
