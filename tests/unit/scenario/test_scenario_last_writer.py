"""A check that fails names the line that wrote the value: found by running the scenario again."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic, Note
from harness.results import ScenarioResult
from harness.scenario import RunOptions, run_case, run_paths, scenario_cases
from harness.scenario.explaining import WriterNotes, explained
from harness.scenario.tracing import TraceObserver
from tests.unit.scenario.block_scenarios import tank_file
from tests.unit.scenario.scenario_files import steps, written

PUMP = "plc.TOS_Plant.gw1.pump"
STARTED = (
    "- wait: 100 ms",
    f"- set: {{{PUMP}.start_forward.execute: true, {PUMP}.start_forward.frequency: 30}}",
    "- wait: 300 ms",
)


def failure(path: Path, options: RunOptions | None = None) -> Diagnostic:
    [result] = run_paths([path], options or RunOptions()).results
    return result.failures[0]


def note(found: Diagnostic) -> Note:
    """The one about who wrote the value."""
    [one] = [
        item
        for item in found.notes
        if item.message.startswith(("it was last", "the PLC has not written"))
    ]
    return one


def marked(found: Note) -> str:
    assert found.span is not None
    return found.span.text


def test_the_line_of_the_plc_and_its_instance(tmp_path: Path) -> None:
    path = written(tmp_path, steps(*STARTED, f"- expect: {{{PUMP}.start_forward.done: false}}"))
    found = note(failure(path))
    assert found.message == "it was last written here, by TOS_Gateway_gw1_DB.seq_pump"
    assert marked(found) == "#drive.start_forward.done"
    assert found.span is not None
    assert found.span.source.name == "TOS_Sequences.scl"


def test_what_the_scenario_has_set_is_its_own(tmp_path: Path) -> None:
    check = "- expect: {plc.tos_plant.GW1.pump.start_forward.frequency: 31}"
    found = note(failure(written(tmp_path, steps(*STARTED, check))))
    assert found.message == "it was last set here"
    assert marked(found) == "30"


def test_what_nobody_has_written(tmp_path: Path) -> None:
    path = written(tmp_path, steps(*STARTED, f"- expect: {{{PUMP}.stop.done: true}}"))
    assert note(failure(path)).message == "the PLC has not written it since it started"


def test_what_no_plc_writes_has_no_such_note(tmp_path: Path) -> None:
    path = written(tmp_path, steps(*STARTED, "- expect: {drive.pump.running: false}"))
    assert not [item for item in failure(path).notes if "written" in item.message]


def test_a_restart_is_a_new_beginning(tmp_path: Path) -> None:
    restarted = ("- inject: cpu_stopped", "- wait: 50 ms", "- clear: cpu_stopped")
    check = f"- expect: {{{PUMP}.start_forward.done: true}}"
    found = note(failure(written(tmp_path, steps(*STARTED, *restarted, check))))
    assert found.message == "the PLC has not written it since it started"


def test_a_block_on_its_own(tmp_path: Path) -> None:
    lines = "steps:\n  - set: {block.start: true}\n  - wait: 100 ms\n"
    wrong = lines + "  - expect: {block.pump: false}\n"
    assert marked(note(failure(tank_file(tmp_path, wrong)))) == "#pump := #delay.Q;"
    wrong = lines + "  - expect: {block.start: false}\n"
    assert note(failure(tank_file(tmp_path, wrong))).message == "it was last set here"


def test_a_traced_run_knows_it_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def again(*_: object) -> ScenarioResult:
        raise AssertionError("there is no need to run it again")

    monkeypatch.setattr("harness.scenario.explaining.run_case", again)
    path = written(tmp_path, steps(*STARTED, f"- expect: {{{PUMP}.start_forward.done: false}}"))
    found = failure(path, RunOptions(observers=(TraceObserver,)))
    assert marked(note(found)) == "#drive.start_forward.done"


def test_the_reference_engine_does_not_know(tmp_path: Path) -> None:
    lines = "engine: reference\n" + steps(
        "- wait: 20 ms", "- expect: {plc.TOS_Plant.inputsHash: 0}"
    )
    assert not [
        item for item in failure(written(tmp_path, lines)).notes if "written" in item.message
    ]


def test_a_run_that_passes_is_not_run_again(tmp_path: Path) -> None:
    path = written(tmp_path, steps("- expect: {drive.pump.running: false}"))
    [case] = scenario_cases(path)
    result = run_case(case, load_catalog())
    assert explained(case, result, load_catalog()) is result


def test_looking_on_leaves_nothing(tmp_path: Path) -> None:
    path = written(tmp_path, steps("- expect: {drive.pump.running: false}"))
    [case] = scenario_cases(path)
    assert run_case(case, load_catalog(), observers=[WriterNotes]).observations == ()
