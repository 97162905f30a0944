"""`fbgen test --coverage`, `--fail-under` and `fbgen coverage`."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
SCENARIO = """\
version: 1
title: The virtual clock runs
plant: plant.yaml
engine: compiled
steps:
  - wait: 100 ms
  - expect: {cpu.mode: RUN}
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with a plant, a scenario for the compiled engine and one for the other one."""
    shutil.copy(ROOT / "examples" / "manual_example" / "plant.yaml", tmp_path / "plant.yaml")
    for engine in ("compiled", "reference"):
        text = SCENARIO.replace("engine: compiled", f"engine: {engine}")
        (tmp_path / f"{engine}.scenario.yaml").write_text(text, encoding="utf-8")
    return tmp_path


def test_a_table_and_reports_are_made_of_what_runs(fbgen: Fbgen, folder: Path) -> None:
    whole = folder / "report"
    data = folder / "data.json"
    run = fbgen("test", str(folder), "-j", "2", "--coverage", f"{whole}/", "--coverage", str(data))
    assert run.status == 0, run.err
    assert "TOS_Telegram" in run.out
    assert "all blocks" in run.out
    assert {path.name for path in whole.iterdir()} == {
        *("cobertura.xml", "coverage.json", "index.html", "lcov.info", "sources"),
    }
    assert (whole / "sources" / "TOS_Main.scl").is_file()
    assert data.read_bytes() == (whole / "coverage.json").read_bytes()

    merged = folder / "merged.json"
    again = fbgen("coverage", str(data), str(data), "--report", str(merged))
    assert again.status == 0, again.err
    before, after = (json.loads(path.read_text("utf-8")) for path in (data, merged))
    assert after["totals"] == before["totals"]
    once, twice = hits(before), hits(after)
    assert twice == [2 * count for count in once]


def hits(data: dict[str, Any]) -> list[int]:
    """How often each statement ran."""
    blocks = [block for file in data["files"] for block in file["blocks"]]
    return [statement[4] for block in blocks for statement in block["statements"]]


def test_too_little_coverage_fails(fbgen: Fbgen, folder: Path) -> None:
    scenario = str(folder / "compiled.scenario.yaml")
    run = fbgen("test", scenario, "--fail-under", "statement=1,branch=99")
    assert run.status == 1
    assert "FB8052" in run.err
    assert "the branch coverage is" in run.err
    assert "statement coverage" not in run.err


def test_mistakes_in_the_options_are_said_before_anything_runs(fbgen: Fbgen, folder: Path) -> None:
    wrong = fbgen("test", str(folder), "--fail-under", "branches=1")
    assert (wrong.status, wrong.out) == (1, "")
    assert "FB8051" in wrong.err
    wrong = fbgen("test", str(folder), "--coverage", "report.txt")
    assert (wrong.status, wrong.out) == (1, "")
    assert "FB8053" in wrong.err


def test_files_without_coverage_are_all_named(fbgen: Fbgen, folder: Path) -> None:
    run = fbgen("coverage", str(folder / "plant.yaml"), str(folder / "none.json"))
    assert run.status == 1
    assert run.err.count("FB8050") == 2
