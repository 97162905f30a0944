"""Blocks on their own: calls, cycles, stubs, and what a block cannot do."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from harness.scenario import RunOptions, run_case, run_paths, scenario_cases
from harness.scenario.tracing import TraceObserver
from harness.trace import Trace
from harness.trace.vcd import vcd_text
from tests.unit.scenario.block_scenarios import HEAD, only_failure, tank, tank_file
from tests.unit.scenario.scenario_files import PLANT, marked

READER = """\
FUNCTION_BLOCK "Reader"
VAR_OUTPUT
  status : WORD;
  found : INT;
END_VAR
BEGIN
  #status := GET_WEATHER(station := 3, degrees => #found);
END_FUNCTION_BLOCK
"""


def test_a_block_is_called_once_each_cycle_while_time_passes(tmp_path: Path) -> None:
    result = tank(
        tmp_path,
        """\
cycle: 20 ms
steps:
  - expect: {block.calls: 0}
  - wait: 20 ms
  - expect: {block.calls: 1}
  - wait: 30 ms
  - expect: {block.calls: 3}
  - set: {block.start: true}
  - expect: {block.pump: true, block.calls: 7}
    within: 100 ms
""",
    )
    assert result.passed, result.render()
    assert result.virtual_ns == 121_000_000, "the call at 120 ms is seen a millisecond later"


def test_call_stays_at_the_instant_of_the_last_cycle(tmp_path: Path) -> None:
    text = "steps:\n  - call: 3\n  - expect: {block.calls: 3}\n  - call: 1\n"
    result = tank(tmp_path, f"{text}  - expect: {{block.calls: 4}}\n")
    assert (result.passed, result.virtual_ns) == (True, 30_000_000)


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_both_engines_run_blocks(tmp_path: Path, engine: str) -> None:
    text = f"engine: {engine}\nsteps:\n  - call: 2\n  - expect: {{block.calls: 2}}\n"
    assert tank(tmp_path, text).passed


TAKER = """\
TYPE "Order"
STRUCT
  parts : INT;
  taken : BOOL;
END_STRUCT;
END_TYPE

FUNCTION_BLOCK "Taker"
VAR_IN_OUT
  order : "Order";
  stock : INT;
END_VAR
BEGIN
  IF NOT #order.taken AND #order.parts <= #stock THEN
    #stock := #stock - #order.parts;
    #order.taken := TRUE;
  END_IF;
END_FUNCTION_BLOCK
"""


@pytest.mark.parametrize("engine", ["compiled", "reference"])
def test_in_outs_are_variables_of_the_scenario(tmp_path: Path, engine: str) -> None:
    text = f"""\
version: 1
title: Orders
sources: [taker.scl]
block: Taker
engine: {engine}
steps:
  - expect: {{block.order.taken: false, block.stock: 0}}
  - set: {{block.order.parts: 3, block.stock: 2}}
  - call: 1
  - expect: {{block.order.taken: false, block.stock: 2}}
  - set: {{block.stock: 5}}
  - call: 2
  - expect: {{block.order.taken: true, block.order.parts: 3, block.stock: 2}}
"""
    (tmp_path / "taker.scl").write_text(TAKER, "utf-8")
    path = tmp_path / "taker.scenario.yaml"
    path.write_text(text, "utf-8")
    result = run_case(scenario_cases(path)[0], load_catalog())
    assert result.passed, result.render()


def test_a_stub_gives_what_the_scenario_says(tmp_path: Path) -> None:
    text = """\
stubs:
  GET_WEATHER: {RET_VAL: 16#8401, degrees: -4}
steps:
  - call: 1
  - expect: {block.status: 16#8401, block.found: -4}
"""
    result = tank(tmp_path, text, READER)
    assert result.passed, result.render()


def test_a_stub_gives_a_value_for_each_call_or_by_the_clock(tmp_path: Path) -> None:
    text = """\
stubs:
  GET_WEATHER: {RET_VAL: [16#8401, 16#7002, 0], degrees: {0 s: -4, 30 ms: 5, 1 s: 20}}
steps:
  - call: 1
  - expect: {block.status: 16#8401, block.found: -4}
  - call: 1
  - expect: {block.status: 16#7002, block.found: -4}
  - call: 2
  - expect: {block.status: 0, block.found: 5}
  - wait: 1 s
  - expect: {block.status: 0, block.found: 20}
"""
    result = tank(tmp_path, text, READER)
    assert result.passed, result.render()


@pytest.mark.parametrize(
    ("degrees", "message"),
    [("[]", "empty"), ("{soon: 4}", "'soon' is no time"), ("[[1]]", "found a list")],
)
def test_a_table_of_a_stub_that_is_none_is_refused(
    tmp_path: Path, degrees: str, message: str
) -> None:
    text = f"stubs:\n  GET_WEATHER: {{degrees: {degrees}}}\n"
    with pytest.raises(DiagnosticError) as refused:
        tank(tmp_path, f"{text}steps:\n  - expect: {{block.found: 1}}\n", READER)
    (found,) = refused.value.diagnostics
    assert message in found.message
    assert found.span is not None
    assert found.span.line == 5


def test_a_generated_block_is_tested_without_its_devices(tmp_path: Path) -> None:
    path = tmp_path / "drive.scenario.yaml"
    path.write_text(
        f"version: 1\ntitle: T\nplant: {PLANT.as_posix()}\nblock: TOS_TriggerCounter\n"
        "steps:\n  - call: 2\n  - expect: {cpu.mode: RUN}\n",
        "utf-8",
    )
    result = run_case(scenario_cases(path)[0], load_catalog())
    assert only_failure(result).message == (
        "there is no kind of thing 'cpu' beside a block on its own"
    )


@pytest.mark.parametrize(
    ("line", "code", "place"),
    [
        ("  - expect: {block.pmp: true}", "FB8003", "block.pmp"),
        ("  - expect: {pump: true}", "FB8003", "pump"),
        ("  - expect: {plc.nothing: true}", "FB8003", "plc.nothing"),
        ("  - expect: {block.level: true}", "FB8009", "true"),
        ("  - set: {block.level: 40000}", "FB8009", "40000"),
        ("  - inject: line_noise\n    on: gw1", "FB8018", "inject: line_noise\n    on: gw1"),
    ],
)
def test_mistakes_are_told_before_anything_runs(
    tmp_path: Path, line: str, code: str, place: str
) -> None:
    result = tank(tmp_path, f"steps:\n{line}\n  - expect: {{block.pump: false}}\n")
    failure = only_failure(result)
    assert (failure.code, marked(failure).strip()) == (code, place)
    assert result.virtual_ns == 0


def test_a_fault_of_the_program_fails_the_scenario_at_its_line(tmp_path: Path) -> None:
    source = 'FUNCTION_BLOCK "D"\nVAR_INPUT\n  n : INT;\nEND_VAR\nVAR_OUTPUT\n  q : INT;\n'
    source += "END_VAR\nBEGIN\n  #q := 1 / #n;\nEND_FUNCTION_BLOCK\n"
    failure = only_failure(
        tank(tmp_path, "steps:\n  - expect: {block.q: 1}\n    within: 1 s\n", source)
    )
    assert failure.code == "FB6003"
    assert failure.span is not None
    assert failure.span.line == 9


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("drives: {pump: {reply_time: 1 ms}}\n", "{pump: {reply_time: 1 ms}}"),
        ("variations: [{}]\n", "[{}]"),
        ("seed: 1\nseeds: [1, 2]\n", "1"),
    ],
)
def test_what_belongs_to_a_plant_is_told(tmp_path: Path, text: str, place: str) -> None:
    path = tank_file(tmp_path, f"{text}steps:\n  - expect: {{block.pump: false}}\n")
    (result,) = run_paths([path], RunOptions()).results
    failure = only_failure(result)
    assert (failure.code, marked(failure)) == ("FB8018", place)


def test_a_scenario_of_nothing_is_told(tmp_path: Path) -> None:
    path = tmp_path / "x.scenario.yaml"
    path.write_text("version: 1\ntitle: T\nsteps:\n  - expect: {block.pump: true}\n", "utf-8")
    failure = only_failure(run_paths([path]).results[0])
    assert (failure.code, failure.message) == ("FB8018", "nothing says what is tested")


def test_missing_sources_are_told_together(tmp_path: Path) -> None:
    path = tmp_path / "x.scenario.yaml"
    text = HEAD.replace("[tank.scl]", "[a.scl, b.scl]")
    path.write_text(f"{text}steps:\n  - expect: {{block.pump: true}}\n", "utf-8")
    found = run_paths([path]).results[0].failures
    assert [(item.code, marked(item)) for item in found] == [
        ("FB8007", "a.scl"),
        ("FB8007", "b.scl"),
    ]


def test_the_users_own_program_runs_in_the_plant(tmp_path: Path) -> None:
    (tmp_path / "main.scl").write_text(
        'DATA_BLOCK "Count"\nSTRUCT\n  scans : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n'
        'ORGANIZATION_BLOCK "Main"\nBEGIN\n  "Count".scans := "Count".scans + 1;\n'
        "END_ORGANIZATION_BLOCK\n",
        "utf-8",
    )
    path = tmp_path / "own.scenario.yaml"
    path.write_text(
        f"version: 1\ntitle: T\nplant: {PLANT.as_posix()}\nsources: [main.scl]\n"
        "steps:\n  - expect: {plc.Count.scans: {min: 3}, gateway.gw1.online: true}\n"
        "    within: 200 ms\n",
        "utf-8",
    )
    result = run_case(scenario_cases(path)[0], load_catalog())
    assert result.passed, result.render()


def test_a_block_on_its_own_leaves_a_trace_of_its_variables(tmp_path: Path) -> None:
    path = tank_file(
        tmp_path,
        "steps:\n  - set: {block.start: true}\n"
        "  - expect: {block.pump: true}\n    within: 600 ms\n",
    )
    (case,) = scenario_cases(path)
    trace = run_case(case, load_catalog(), observers=[TraceObserver]).observed(Trace)
    assert trace is not None
    started = trace.changes_of("block.start")
    assert [change.value for change in started] == [False, True]
    written = trace.writer_of(started[1])
    assert written is not None
    assert written.text == "- set: {block.start: true}"
    off, on = trace.changes_of("block.pump")
    assert (off.value, on.value) == (False, True)
    assert on.time_ns > 0
    source = trace.writer_of(on)
    assert source is not None
    assert source.file.endswith("tank.scl")
    assert [mark.verdict for mark in trace.marks if mark.kind == "check"] == ["passed"]
    assert "block" in vcd_text(trace)
