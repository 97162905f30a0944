"""`fbgen demo` and `fbgen test`: the commands that run the harness."""

import json
import shutil
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
SENT = ["E0 00 01 0B 50 FA 00 C4 00", "A0 00 02 0B 50 FA 01 13 88"]
SCENARIO = """\
version: 1
title: The virtual clock runs
plant: plant.yaml
tags: [clock]
steps:
  - wait: 100 ms
  - expect: {drive.EXAMPLE.frequency: 0.0}
"""


@pytest.fixture
def scenarios(tmp_path: Path) -> Path:
    """A folder with a plant and one scenario that passes."""
    example = ROOT / "examples" / "manual_example" / "plant.yaml"
    shutil.copy(example, tmp_path / "plant.yaml")
    text = example.read_text(encoding="utf-8")
    drive = text.partition("drives:")[2].partition("name:")[2].split()[0]
    scenario = SCENARIO.replace("EXAMPLE", drive)
    (tmp_path / "clock.scenario.yaml").write_text(scenario, encoding="utf-8")
    return tmp_path


def test_demo_shows_the_manuals_telegrams_and_succeeds(fbgen: Fbgen) -> None:
    run = fbgen("demo")
    assert (run.status, run.err) == (0, "")
    for telegram in SENT:
        assert telegram in run.out


def test_demo_as_json_gives_the_same_as_data(fbgen: Fbgen) -> None:
    run = fbgen("demo", "--json")
    assert (run.status, run.err) == (0, "")
    assert isinstance(json.loads(run.out), dict)
    for telegram in SENT:
        assert telegram in run.out


def test_demo_is_status_1_when_a_byte_differs(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("harness.demo.DemoReport.matches", False)
    assert fbgen("demo").status == 1
    assert fbgen("demo", "--json").status == 1


def test_a_passing_scenario_is_one_line_and_status_0(fbgen: Fbgen, scenarios: Path) -> None:
    run = fbgen("test", str(scenarios))
    assert (run.status, run.err) == (0, "1 passed, 0 failed\n")
    file = (scenarios / "clock.scenario.yaml").as_posix()
    assert run.out.split(maxsplit=4)[0] == "passed"
    assert run.out.endswith(f"{file}  The virtual clock runs\n")


def test_a_failing_scenario_shows_the_step_and_is_status_1(fbgen: Fbgen, scenarios: Path) -> None:
    path = scenarios / "clock.scenario.yaml"
    path.write_text(path.read_text("utf-8").replace("frequency: 0.0", "frequency: 1.0"), "utf-8")
    run = fbgen("test", str(path))
    assert run.status == 1
    assert run.out.startswith("FAILED")
    assert f"--> {path.as_posix()}:7:" in run.err
    assert f"run it again: fbgen test {path.as_posix()} --seed 0" in run.err
    assert run.err.endswith("0 passed, 1 failed\n")


def test_results_as_json_leave_standard_output_to_json(fbgen: Fbgen, scenarios: Path) -> None:
    run = fbgen("test", str(scenarios), "--seed", "7", "--json")
    (scenario,) = json.loads(run.out)["scenarios"]
    assert (run.status, scenario["passed"], scenario["seed"]) == (0, True, 7)
    assert scenario["virtual_ns"] >= 100_000_000


def test_scenarios_are_selected_by_title_file_or_tag(fbgen: Fbgen, scenarios: Path) -> None:
    for text in ("VIRTUAL", "clock.sc", "clock"):
        assert fbgen("test", str(scenarios), "-k", text).status == 0


def test_selecting_nothing_is_fb9006(fbgen: Fbgen, scenarios: Path) -> None:
    run = fbgen("test", str(scenarios), "-k", "zebra")
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9006]: no scenario fits -k 'zebra'\n")


def test_a_scenario_that_is_not_there_is_a_diagnostic(fbgen: Fbgen, tmp_path: Path) -> None:
    run = fbgen("test", str(tmp_path / "missing.scenario.yaml"))
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB8007]: ")


def test_scenarios_run_on_the_text_of_another_dialect(fbgen: Fbgen, scenarios: Path) -> None:
    run = fbgen("test", str(scenarios), "--dialect", "step7")
    assert run.status == 0, run.err
    assert "The virtual clock runs [step7]" in run.out


def test_what_a_plant_cannot_do_in_another_dialect_is_a_failure(
    fbgen: Fbgen, scenarios: Path
) -> None:
    run = fbgen("test", str(scenarios), "--dialect", "iec")
    assert run.status == 1
    assert "FB2005" in run.err
    assert "--dialect iec" in run.err


def test_an_unknown_dialect_of_a_plant_is_wrong_usage(fbgen: Fbgen, scenarios: Path) -> None:
    run = fbgen("test", str(scenarios), "--dialect", "basic")
    assert run.status == 2
    assert "'basic' is none of tia, step7, iec, twincat, plcopen" in run.err


OWN_SERIES = """\
version: 1
id: vf-s11x
like: vf-s11
title: A series of our own
protocol: toshiba
source: a letter of the maker
link:
  {command: command_word, setpoint: frequency_setpoint, status: status, trip: trip_code,
   alarm: alarm, output_frequency: output_frequency, output_current: output_current_held,
   inv_no: inverter_number, maximum_frequency: maximum_frequency, timeout: communication_timeout}
times:
  reply_max: {ms: 20, source: it}
  boot: {ms: 900, source: it}
  reset_silence: {ms: 2000, source: it}
"""


def test_scenarios_run_with_a_catalogue_of_ones_own(fbgen: Fbgen, scenarios: Path) -> None:
    own = scenarios / "own"
    (own / "drives").mkdir(parents=True)
    (own / "drives" / "vf-s11x.yaml").write_text(OWN_SERIES, "utf-8")
    for kind, name in (("gateways", "tospbdp001"), ("sequences", "manual_example")):
        (own / kind).mkdir()
        shipped = (ROOT / "catalog" / kind / f"{name}.yaml").read_text("utf-8")
        changed = shipped.replace("series: [vf-s11", "series: [vf-s11x, vf-s11", 1)
        assert changed != shipped
        (own / kind / f"{name}.yaml").write_text(changed, "utf-8")
    plant = scenarios / "plant.yaml"
    plant.write_text(plant.read_text("utf-8").replace("series: vf-s11", "series: vf-s11x"), "utf-8")
    run = fbgen("test", str(scenarios), "--catalog", str(own))
    assert (run.status, run.err) == (0, "1 passed, 0 failed\n")
    run = fbgen("test", str(scenarios))
    assert run.status == 1
    assert "there is no drive series 'vf-s11x'" in run.err
    (own / "drives" / "vf-s11x.yaml").write_text(OWN_SERIES + "times: {}\n", "utf-8")
    run = fbgen("test", str(scenarios), "--catalog", str(own))
    assert run.status == 1
    assert run.err.count("error[FB1004]") == 1


def test_the_command_that_runs_a_scenario_again_names_the_catalogue(
    fbgen: Fbgen, scenarios: Path
) -> None:
    path = scenarios / "clock.scenario.yaml"
    path.write_text(path.read_text("utf-8").replace("frequency: 0.0", "frequency: 1.0"), "utf-8")
    own = scenarios / "own"
    own.mkdir()
    run = fbgen("test", str(scenarios), "--catalog", str(own))
    assert f"--seed 0 --catalog {own.as_posix()}\n" in run.err


def test_scenarios_run_in_several_processes(fbgen: Fbgen, scenarios: Path) -> None:
    shutil.copy(scenarios / "clock.scenario.yaml", scenarios / "again.scenario.yaml")
    run = fbgen("test", str(scenarios), "-j", "2")
    assert (run.status, run.err) == (0, "2 passed, 0 failed\n")
    assert [line.split()[3].rpartition("/")[2] for line in run.out.splitlines()] == [
        "again.scenario.yaml",
        "clock.scenario.yaml",
    ]


def test_ctrl_c_says_what_ran_and_is_status_130(
    fbgen: Fbgen, scenarios: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(scenario: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("fbgen.cli.test._show", interrupted)
    run = fbgen("test", str(scenarios))
    assert (run.status, run.err) == (130, "stopped by Ctrl-C: 1 passed, 0 failed, 0 not run\n")
