"""`fbgen mutate` from the command line, on a small block and a short scenario."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen

SCENARIO = "tests/scenarios/ram_writes_spare_the_eeprom.scenario.yaml"
SMALL = ("mutate", "--scenarios", SCENARIO, "--block", "TOS_TriggerCounter")


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> dict[str, object]:
    from fbgen.cli import main  # noqa: PLC0415 - only this fixture runs outside of a test

    path = tmp_path_factory.mktemp("mutate") / "mutants.json"
    main((*SMALL, "--json", str(path)))
    found: dict[str, object] = json.loads(path.read_text(encoding="utf-8"))
    return found


def test_the_report_has_every_mutant_with_its_patch(report: dict[str, object]) -> None:
    mutants = report["mutants"]
    assert isinstance(mutants, list)
    by_id = {one["id"]: one for one in mutants}
    score = report["score"]
    assert isinstance(score, dict)
    assert score["mutants"] == len(by_id)
    assert score["killed"] == sum(one["fate"] == "killed" for one in mutants)
    first = next(one for one in mutants if one["operator"] == "drop")
    assert first["diff"].startswith("--- TOS_TriggerCounter.scl\n+++ TOS_TriggerCounter.scl (")
    assert any(one["origin"] for one in mutants), "some constants are from the catalogue"


def test_survivors_are_shown_with_their_lines(fbgen: Fbgen) -> None:
    run = fbgen(*SMALL, "--operators", "edge,drop")
    assert run.status == 0
    assert "TOS_TriggerCounter.scl:" in run.out
    assert "-   #statAdvance := #advance;" in run.out
    assert run.out.splitlines()[-1].startswith("all")


def test_a_score_that_is_too_low_fails(fbgen: Fbgen) -> None:
    run = fbgen(*SMALL, "--operators", "edge", "--fail-under", "50")
    assert run.status == 1
    assert "FB8064" in run.err


def test_one_mutant_is_shown_with_the_check_that_noticed_it(
    fbgen: Fbgen, report: dict[str, object]
) -> None:
    mutants = report["mutants"]
    assert isinstance(mutants, list)
    killed = next(one for one in mutants if one["fate"] == "killed")
    run = fbgen("mutate", "--scenarios", SCENARIO, "--mutant", killed["id"])
    assert run.status == 0
    assert killed["id"] in run.out
    assert f"error[{killed['message'].partition(':')[0]}]" in run.err


def test_a_sample_is_drawn_by_the_seed(fbgen: Fbgen) -> None:
    first = fbgen(*SMALL, "--max", "3", "--seed", "4")
    again = fbgen(*SMALL, "--max", "3", "--seed", "4")
    assert first.out == again.out
    assert first.out.splitlines()[-1].split()[1] == "3"


def test_a_page_for_people_is_written(fbgen: Fbgen, tmp_path: Path) -> None:
    page = tmp_path / "mutants.html"
    fbgen(*SMALL, "--operators", "edge", "--html", str(page))
    text = page.read_text(encoding="utf-8")
    assert "TOS_TriggerCounter:" in text
    assert "http" not in text, "it opens offline"


def test_a_log_goes_on_where_it_ended(fbgen: Fbgen, tmp_path: Path) -> None:
    log = tmp_path / "mutants.jsonl"
    whole = fbgen(*SMALL, "--log", str(log))
    lines = log.read_text(encoding="utf-8").splitlines(keepends=True)
    place = next(number for number, line in enumerate(lines) if '"run"' in line)
    told = {**json.loads(lines[place]), "noticed": "FB8001: as the log says", "at_ns": 1}
    log.write_text("".join((*lines[:place], json.dumps(told) + "\n", lines[-1][:9])), "utf-8")
    again = fbgen(*SMALL, "--log", str(log))
    assert again.out.splitlines()[-1].split()[1] == whole.out.splitlines()[-1].split()[1]
    ran = [json.loads(line).get("run") for line in log.read_text("utf-8").splitlines()]
    assert ran.count(told["run"]) == 1, "what is in the log is not run again"
    assert log.read_text("utf-8").count('"asked"') == 1


def test_a_log_keeps_what_other_scenarios_have_said(fbgen: Fbgen, tmp_path: Path) -> None:
    log = tmp_path / "mutants.jsonl"
    fbgen(*SMALL, "--log", str(log))
    before = log.read_text("utf-8").splitlines()
    block = "tests/scenarios/mutants_tos_trigger_counter.scenario.yaml"
    more = fbgen(*SMALL, "--scenarios", block, "--log", str(log))
    after = log.read_text("utf-8").splitlines()
    assert after[: len(before)] == before, "the lines of the first scenario still count"
    alone = fbgen("mutate", "--scenarios", SCENARIO, "--scenarios", block, *SMALL[3:])
    assert more.out.splitlines()[-1] == alone.out.splitlines()[-1]


def test_a_log_of_another_version_begins_anew(fbgen: Fbgen, tmp_path: Path) -> None:
    log = tmp_path / "mutants.jsonl"
    log.write_text('{"format": "fbgen mutation log 1"}\n{"id": "OLD"}\n', encoding="utf-8")
    fbgen(*SMALL, "--operators", "edge", "--log", str(log))
    assert "OLD" not in log.read_text(encoding="utf-8")


@pytest.mark.skipif(os.name != "posix", reason="Ctrl+C is sent to the process")
@pytest.mark.usefixtures("usual_ctrl_c")
def test_ctrl_c_leaves_a_report_of_what_ran(tmp_path: Path) -> None:
    log, report = tmp_path / "mutants.jsonl", tmp_path / "mutants.json"
    command = [sys.executable, "-m", "fbgen.cli", "mutate", "--scenarios", SCENARIO]
    command += ["--block", "TOS_Telegram", "--log", str(log), "--json", str(report)]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
    while not log.exists() or log.read_text(encoding="utf-8").count('"run"') < 5:
        assert process.poll() is None, "it ended before it was stopped"
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 130
    assert b"stopped by Ctrl-C" in said
    found = json.loads(report.read_text(encoding="utf-8"))
    assert found["interrupted"]
    assert 0 < len(found["mutants"]) < found["planned"]


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("--block", "TOS_Trigger"), "FB8060"),
        (("--mutant", "TOS_TriggerCounter:1:drop:1"), "FB8062"),
        (("--block", "TOS_WordToHz", "--log", SCENARIO), "FB8063"),
        (("--operators", "logic"), "FB8065"),
        (("examples/five_drives/plant.yaml",), "FB8066"),
        (("own.scl",), "FB8066"),
    ],
)
def test_what_cannot_be_done_is_said(fbgen: Fbgen, arguments: tuple[str, ...], code: str) -> None:
    run = fbgen("mutate", "--scenarios", SCENARIO, *arguments)
    assert (run.status, run.err.splitlines()[0][:13]) == (1, f"error[{code}]")


def test_a_scenario_that_fails_by_itself_is_named(fbgen: Fbgen, tmp_path: Path) -> None:
    plant = (Path("tests/scenarios") / "one_drive.yaml").resolve()
    scenario = tmp_path / "wrong.scenario.yaml"
    scenario.write_text(
        f"version: 1\ntitle: Wrong\nplant: {os.path.relpath(plant, tmp_path)}\n"
        "steps:\n  - expect: {cpu.mode: RUN}\n    within: 100 ms\n"
        "  - expect: {drive.pump.running: true}\n",
        encoding="utf-8",
    )
    run = fbgen("mutate", "--scenarios", str(scenario), "--block", "TOS_TriggerCounter")
    assert run.status == 1
    assert "FB8061" in run.err
    assert "fbgen test" in run.err


def test_the_blocks_of_a_text_of_ones_own_are_changed(fbgen: Fbgen, tmp_path: Path) -> None:
    head = "VAR_INPUT x : Int; END_VAR VAR_OUTPUT y : Int; END_VAR BEGIN"
    for name, statement in (("Own", '#y := "Other"(x := #x);'), ("Second", "#y := #x;")):
        text = f'FUNCTION_BLOCK "{name}" {head}\n  {statement}\nEND_FUNCTION_BLOCK\n'
        (tmp_path / f"{name}.scl").write_text(text, encoding="utf-8")
    other = (
        'FUNCTION "Other" : Int VAR_INPUT x : Int; END_VAR BEGIN #Other := #x + 1; END_FUNCTION\n'
    )
    with (tmp_path / "Own.scl").open("a", encoding="utf-8") as file:
        file.write(other)
    (tmp_path / "own.scenario.yaml").write_text(
        "version: 1\ntitle: Own\nsources: [Own.scl, Second.scl]\nblock: Own\n"
        "steps:\n  - set: {block.x: 1}\n  - call: 1\n  - expect: {block.y: 2}\n",
        encoding="utf-8",
    )
    run = fbgen("mutate", str(tmp_path / "Own.scl"), "--scenarios", str(tmp_path))
    assert run.status == 0
    assert [line.split()[0] for line in run.out.splitlines()[-4:]] == [
        "block",
        "Own",
        "Other",
        "all",
    ]


def test_equivalent_mutants_are_proved_and_do_not_count(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "mutants.json"
    fbgen(
        *("mutate", "--scenarios", SCENARIO, "--block", "TOS_HzToWord", "--operators"),
        *("relational", "--prove", "--json", str(path)),
    )
    found = json.loads(path.read_text(encoding="utf-8"))
    proved = [one for one in found["mutants"] if one["fate"] == "proved"]
    assert proved, "a comparison that comes behind another one"
    assert found["score"]["proved"] == len(proved)
    explained = [one for one in found["mutants"] if one["fate"] == "explained"]
    counted = found["score"]["mutants"] - len(proved) - len(explained)
    assert found["score"]["noticed"] == round(100 * found["score"]["killed"] / counted, 2)


def test_proofs_need_a_package(fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    run = fbgen(*SMALL, "--prove")
    assert (run.status, run.err.splitlines()[0][:13]) == (1, "error[FB8067]")


def test_reasons_count_until_something_speaks_against_them(
    fbgen: Fbgen, report: dict[str, object], tmp_path: Path
) -> None:
    mutants = report["mutants"]
    assert isinstance(mutants, list)
    quiet = [one for one in mutants if one["fate"] != "killed" and not one.get("effect")]
    killed = next(one for one in mutants if one["fate"] == "killed")
    names = [*(one["fingerprint"] for one in quiet), killed["fingerprint"], "m0000000000"]
    reasons = tmp_path / "mutation-equivalents.yaml"
    entries = (f"  - {{block: TOS_TriggerCounter, mutant: {one}, reason: so}}\n" for one in names)
    reasons.write_text(f"version: 1\nequivalents:\n{''.join(entries)}", encoding="utf-8")
    path = tmp_path / "mutants.json"
    run = fbgen(*SMALL, "--equivalents", str(reasons), "--json", str(path))
    found = {one["id"]: one for one in json.loads(path.read_text(encoding="utf-8"))["mutants"]}
    assert {found[one["id"]]["fate"] for one in quiet} == {"explained"}
    assert found[killed["id"]]["fate"] == "killed"
    assert run.status == 1
    first, second, third = [line for line in run.err.splitlines() if line.startswith("error[")]
    assert first.startswith("error[FB8068]")
    assert f"{killed['id']} is noticed by" in first
    assert (
        second
        == "error[FB8068]: the entry for m0000000000 of TOS_TriggerCounter belongs to no mutant"
    )
    assert third.startswith(f"error[FB8069]: {len(quiet)} of {len(mutants)} mutants")
