"""Scenario files in folders: found, chosen, reported; a wrong file does not hide its neighbours."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.scenario import RunOptions, ScenarioReport, find_scenarios, run_paths
from tests.unit.scenario.scenario_files import PLANT, steps, written

PASSES = steps("- expect: {drive.pump.running: false}")
VARIED = "variations: [{}, {layout: doc9}, {plc: s7-300}]\ntags: [layouts]\n" + PASSES


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """b passes in three variations, a and c/d have mistakes, e.yaml is no scenario."""
    written(tmp_path, VARIED).rename(tmp_path / "b.scenario.yaml")
    (tmp_path / "a.scenario.yaml").write_text("version: 2\n", "utf-8")
    (tmp_path / "c").mkdir()
    wrong = written(tmp_path, VARIED.replace("running", "runing"))
    wrong.rename(tmp_path / "c" / "d.scenario.yaml")
    (tmp_path / "e.yaml").write_text("{", "utf-8")
    return tmp_path


def names(report: ScenarioReport) -> list[tuple[str, str, bool]]:
    return [(Path(item.file).name, item.name, item.passed) for item in report.results]


def test_a_folder_is_searched_in_the_order_of_names(folder: Path) -> None:
    found = find_scenarios([folder, folder / "b.scenario.yaml"])
    assert [path.name for path in found] == [
        "a.scenario.yaml",
        "b.scenario.yaml",
        "d.scenario.yaml",
    ]


def test_everything_runs_and_what_is_wrong_in_a_file_is_told_once(folder: Path) -> None:
    told: list[str] = []
    report = run_paths([folder], finished=lambda result: told.append(result.name))
    assert names(report) == [
        ("a.scenario.yaml", "a.scenario.yaml", False),
        ("b.scenario.yaml", "Tried out", True),
        ("b.scenario.yaml", "Tried out [doc9]", True),
        ("b.scenario.yaml", "Tried out [s7-300]", True),
        ("d.scenario.yaml", "Tried out", False),
    ]
    assert told == [item.name for item in report.results]
    assert not report.passed


def test_an_expression_chooses_single_variations(folder: Path) -> None:
    path = folder / "b.scenario.yaml"
    report = run_paths([path], RunOptions(select="layouts and not (doc9 or s7-300)"))
    assert names(report) == [("b.scenario.yaml", "Tried out", True)]
    replay = run_paths([path], RunOptions(select='"[doc9]"')).results
    assert [item.name for item in replay] == ["Tried out [doc9]"]
    assert replay[0].replay == f"""fbgen test {path.as_posix()} --seed 0 -k '"[doc9]"'"""


def test_an_expression_that_fits_nothing_runs_nothing(folder: Path) -> None:
    assert run_paths([folder / "b.scenario.yaml"], RunOptions(select="nothing_of_it")).results == ()


def test_a_wrong_expression_is_told_before_anything_runs(folder: Path) -> None:
    with pytest.raises(DiagnosticError) as failure:
        run_paths([folder], RunOptions(select="and"))
    assert [item.code for item in failure.value.diagnostics] == ["FB8011"]


def test_missing_files_and_empty_folders_are_told_together(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(DiagnosticError) as failure:
        run_paths([tmp_path / "x.scenario.yaml", tmp_path / "empty"])
    first, second = failure.value.diagnostics
    assert (first.code, second.code) == ("FB8007", "FB8007")
    assert first.message.startswith("there is no file ")
    assert second.message.startswith("there is no scenario in the folder ")


def test_a_missing_plant_file_is_told_where_it_is_named(tmp_path: Path) -> None:
    path = written(tmp_path, PASSES, "hall/plant.yaml")
    (result,) = run_paths([path]).results
    (found,) = result.failures
    assert found.code == "FB8007"
    assert found.message == f"there is no plant file {(tmp_path / 'hall/plant.yaml').as_posix()}"
    assert (found.span and found.span.text) == "hall/plant.yaml"


def test_all_mistakes_of_the_plant_file_are_told(tmp_path: Path) -> None:
    text = PLANT.read_text("utf-8").replace("tospbdp001", "tospbdp01").replace("tia", "tai")
    (tmp_path / "plant.yaml").write_text(text, "utf-8")
    (result,) = run_paths([written(tmp_path, PASSES, "plant.yaml")]).results
    assert {item.code for item in result.failures} == {"FB2001", "FB2014"} or (
        len(result.failures) == 2
    )
    assert {item.span.source.name for item in result.failures if item.span} == {
        (tmp_path / "plant.yaml").as_posix()
    }


def test_results_as_data_say_how_to_run_again(folder: Path) -> None:
    (result,) = run_paths([folder / "b.scenario.yaml"], RunOptions(select="doc9", seed=7)).results
    data = result.as_json()
    assert (data["passed"], data["seed"], data["checks"]) == (True, 7, 1)
    assert data["replay"] == result.replay
    assert "--seed 7" in result.replay


def test_a_folder_with_blanks_is_quoted_for_the_shell(tmp_path: Path) -> None:
    (tmp_path / "my plant").mkdir()
    path = written(tmp_path / "my plant", PASSES)
    (result,) = run_paths([path]).results
    assert f"'{path.as_posix()}'" in result.replay
    assert result.render() == f"run it again: {result.replay}"
