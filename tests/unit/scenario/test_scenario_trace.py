"""The trace of a scenario: its steps, checks and faults stand in it, with places and verdicts."""

from pathlib import Path

from fbgen.catalog import load_catalog
from harness.scenario import run_case, scenario_cases
from harness.scenario.tracing import TraceObserver
from harness.trace import Mark, Trace
from tests.unit.scenario.scenario_files import steps, written


def traced(folder: Path, *lines: str, more: str = "") -> Trace:
    [case] = scenario_cases(written(folder, more + steps(*lines)))
    trace = run_case(case, load_catalog(), observers=[TraceObserver]).observed(Trace)
    assert trace is not None
    return trace


def of_kind(trace: Trace, kind: str) -> list[Mark]:
    return [mark for mark in trace.marks if mark.kind == kind]


def test_each_step_has_its_time_its_place_and_its_verdict(tmp_path: Path) -> None:
    trace = traced(
        tmp_path,
        "- wait: 100 ms",
        "- set: {plc.TOS_Plant.gw1.pump.start_forward.execute: true}",
        "- expect: {drive.pump.running: true, cpu.mode: RUN}",
        "  within: 1 s",
    )
    found = of_kind(trace, "step")
    assert [mark.title for mark in found] == [
        "wait 100 ms",
        "set plc.TOS_Plant.gw1.pump.start_forward.execute = true",
        'expect drive.pump.running: true, cpu.mode: "RUN" within 1 s',
    ]
    assert {mark.verdict for mark in found} == {"passed"}
    places = [trace.places[mark.place] for mark in found if mark.place is not None]
    assert [place.line for place in places] == [5, 6, 7]
    assert (found[0].start_ns, found[0].end_ns) == (0, 100_000_000)


def test_the_check_that_failed_is_marked_and_no_other(tmp_path: Path) -> None:
    trace = traced(
        tmp_path,
        "- expect: {drive.pump.running: true, drive.pump.powered: true}",
        "  within: 20 ms",
    )
    first, second = of_kind(trace, "check")
    assert (first.target, first.verdict) == ("drive.pump.running", "failed")
    assert first.end_ns is not None
    assert 20_000_000 <= first.end_ns < 21_000_000
    assert (second.target, second.verdict) == ("drive.pump.powered", "passed")
    assert of_kind(trace, "step")[0].verdict == "failed"
    assert first.place is not None
    assert trace.places[first.place].column == 14


def test_a_fault_begins_and_ends(tmp_path: Path) -> None:
    trace = traced(
        tmp_path,
        "- {inject: line_noise, on: gw1}",
        "- wait: 10 ms",
        "- inject: cpu_stopped",
        "- {clear: line_noise, on: gw1}",
        "- expect: {cpu.mode: STOP}",
    )
    noise, stopped = of_kind(trace, "fault")
    assert (noise.title, noise.target, noise.start_ns) == ("line_noise", "gw1", 0)
    assert noise.end_ns == stopped.start_ns == 10_000_000
    assert (stopped.title, stopped.target, stopped.end_ns) == ("cpu_stopped", "", None)


def test_what_is_set_is_seen_at_once(tmp_path: Path) -> None:
    path = "plc.TOS_Plant.gw1.pump.start_forward.frequency"
    trace = traced(
        tmp_path, "- wait: 55 ms", f"- set: {{{path}: 12.5}}", f"- expect: {{{path}: 12.5}}"
    )
    change = trace.changes_of(path)[-1]
    assert (change.time_ns, change.value) == (55_000_000, 12.5)


def test_variables_that_steps_name_are_recorded(tmp_path: Path) -> None:
    trace = traced(
        tmp_path,
        "- expect: {plc.TOS_Parameters.gw1.line.retries: 2}",
        "- expect: {plc.tos_plant.gw1.pump.polled.tripCode: 0}",
    )
    paths = [channel.path for channel in trace.channels]
    assert "plc.TOS_Parameters.gw1.line.retries" in paths
    assert sum(path.casefold().endswith("pump.polled.tripcode") for path in paths) == 1


def test_a_scenario_with_mistakes_leaves_no_trace(tmp_path: Path) -> None:
    [case] = scenario_cases(written(tmp_path, steps("- expect: {drive.pimp.running: true}")))
    result = run_case(case, load_catalog(), observers=[TraceObserver])
    assert not result.passed
    assert result.observed(Trace) is None


def test_the_words_of_each_step(tmp_path: Path) -> None:
    trace = traced(
        tmp_path,
        "- wait: 100 ms",
        '- {telegrams: [{output: "xx xx FF 0B 47 FC 90 xx xx"}], gateway: gw1}',
        "- expect:",
        "    drive.pump.frequency: {min: 0.0, max: 50}",
        "    drive.pump.word.FD01: {bits: {running: 0}}",
        "    drive.pump.current: {equals: 0.0, tolerance: 0.5}",
        "  stays_for: 1500 us",
        "- expect: {drive.pump.trip: E}",
    )
    titles = [mark.title for mark in of_kind(trace, "step")]
    assert titles[1] == "1 telegram on gw1"
    assert titles[2] == (
        "expect drive.pump.frequency: min 0.0, max 50, drive.pump.word.FD01: running=0, "
        "drive.pump.current: equals 0.0, tolerance 0.5, stays for 1500 us"
    )
    assert titles[3] == 'expect drive.pump.trip: "E"'


def test_variables_that_only_properties_name_are_recorded(tmp_path: Path) -> None:
    trace = traced(
        tmp_path,
        "- wait: 20 ms",
        more="properties:\n"
        "  - always: {plc.TOS_Parameters.gw1.line.retries: 2}\n"
        "    during: {plc.TOS_Gateway_gw1_DB.statPrepared: true}\n",
    )
    paths = [channel.path for channel in trace.channels]
    assert "plc.TOS_Parameters.gw1.line.retries" in paths
    assert "plc.TOS_Gateway_gw1_DB.statPrepared" in paths


def test_faults_by_the_clock_are_marked_as_those_of_steps(tmp_path: Path) -> None:
    trace = traced(
        tmp_path,
        "- wait: 30 ms",
        "- expect: {cpu.mode: RUN}",
        more="faults:\n"
        "  - {at: 10 ms, lasts: 5 ms, every: 15 ms, until: 40 ms, inject: line_noise, on: gw1}\n"
        "  - {at: 28 ms, inject: drive_local, on: pump}\n",
    )
    first, second, local = of_kind(trace, "fault")
    assert [(mark.title, mark.target) for mark in (first, local)] == [
        ("line_noise", "gw1"),
        ("drive_local", "pump"),
    ]
    assert (first.start_ns, first.end_ns) == (10_000_000, 15_000_000)
    assert (second.start_ns, second.end_ns) == (25_000_000, 30_000_000)
    assert (local.start_ns, local.end_ns) == (28_000_000, None)
    assert first.place is not None
    assert trace.places[first.place].text.startswith("- {at: 10 ms")
    starts = [mark.start_ns for mark in trace.marks]
    assert starts == sorted(starts)
