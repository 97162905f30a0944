"""`fbgen test` with reports: which files are written, what is printed for code hosts."""

import json
import shutil
from pathlib import Path

import pytest
from junitparser import JUnitXml

from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
SCENARIO = """\
version: 1
title: A drive stands
plant: plant.yaml
variations: [{}, {plc: s7-300}]
steps:
  - expect: {drive.DRIVE.frequency: 0.0}
"""


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder: a plant, a scenario that passes, and one that fails."""
    plant = ROOT / "tests" / "scenarios" / "one_drive.yaml"
    shutil.copy(plant, tmp_path / "plant.yaml")
    text = SCENARIO.replace("DRIVE", "pump")
    (tmp_path / "stands.scenario.yaml").write_text(text, "utf-8")
    (tmp_path / "turns.scenario.yaml").write_text(text.replace("0.0", "1.0"), "utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_junit_is_written_with_every_run(fbgen: Fbgen, folder: Path) -> None:
    run = fbgen("test", "--junit", "out/results.xml")
    assert run.status == 1
    read = JUnitXml.fromfile(str(folder / "out" / "results.xml"))
    assert (read.tests, read.failures, read.errors) == (4, 2, 0)
    assert (folder / "out" / "results.xml").read_bytes().count(b'name="dialect" value="tia"') == 4


def test_the_same_run_writes_the_same_junit_file_over_the_last(fbgen: Fbgen, folder: Path) -> None:
    arguments = ("test", "stands.scenario.yaml", "--junit", "results.xml")
    assert fbgen(*arguments).status == 0
    first = (folder / "results.xml").read_bytes()
    assert fbgen(*arguments).status == 0
    assert (folder / "results.xml").read_bytes() == first


def test_github_gets_a_line_at_the_failing_check(fbgen: Fbgen, folder: Path) -> None:
    run = fbgen("test", "turns.scenario.yaml", "-k", "not s7-300", "--annotations", "github")
    (line,) = [text for text in run.out.splitlines() if text.startswith("::")]
    place = "title=FB8001,file=turns.scenario.yaml,line=6,endLine=6,col=14,endColumn=34"
    assert line.startswith(f"::error {place}::A drive stands: drive.pump.frequency is 0")
    assert "%0Arun it again: fbgen test turns.scenario.yaml --seed 0" in line


def test_gitlab_gets_its_file(fbgen: Fbgen, folder: Path) -> None:
    assert fbgen("test", "--annotations", "gitlab").status == 1
    found = json.loads((folder / "gl-code-quality-report.json").read_text("utf-8"))
    places = [(item["severity"], item["location"]) for item in found]
    assert places == [("major", {"path": "turns.scenario.yaml", "lines": {"begin": 6}})] * 2
    assert len({item["fingerprint"] for item in found}) == 2


def test_a_report_that_cannot_be_written_keeps_nobody_from_the_others(
    fbgen: Fbgen, folder: Path
) -> None:
    (folder / "taken").mkdir()
    arguments = ("test", "stands.scenario.yaml", "--junit", "taken", "--annotations", "gitlab")
    run = fbgen(*arguments)
    assert run.status == 1
    assert "error[FB9002]: taken cannot be written" in run.err
    assert "2 passed, 0 failed" in run.err
    assert json.loads((folder / "gl-code-quality-report.json").read_text("utf-8")) == []


def test_json_and_lines_for_github_do_not_share_standard_output(fbgen: Fbgen, folder: Path) -> None:
    run = fbgen("test", "--json", "--annotations", "github")
    assert (run.status, run.out) == (2, "")


def test_the_html_report_has_a_diagram_of_each_run_and_says_what_was_asked(
    fbgen: Fbgen, folder: Path
) -> None:
    asked = ("--seed", "7", "--temporaries", "undefined")
    run = fbgen("test", "stands.scenario.yaml", *asked, "--html", "out/report.html")
    assert run.status == 0
    page = (folder / "out" / "report.html").read_text("utf-8")
    assert page.count('<div class="diagram" data-trace=') == 2
    assert "seed 7 for all" in page
    assert "temporaries undefined for all" in page


def test_the_html_report_has_the_tables_of_coverage_where_it_is_asked_for(
    fbgen: Fbgen, folder: Path
) -> None:
    arguments = ("test", "stands.scenario.yaml", "-k", "not s7-300", "--html", "report.html")
    assert fbgen(*arguments).status == 0
    assert "all blocks" not in (folder / "report.html").read_text("utf-8")
    run = fbgen(*arguments, "--coverage", "table")
    assert run.status == 0
    page = (folder / "report.html").read_text("utf-8")
    assert "<summary>Coverage</summary>" in page
    assert "<td>TOS_Line</td>" in page
    assert "Coverage of the catalogue" in page
