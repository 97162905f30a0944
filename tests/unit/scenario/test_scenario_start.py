"""What a scenario says of the start: memories of gateways, times of PROFIBUS and PLC, the cycle."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from harness.kernel import NS_PER_MS
from harness.scenario import prepare, run_case, scenario_cases
from tests.unit.scenario.scenario_files import written

ECHO = """gateways:
  gw1: {trigger: 16#FE, status: 16#5F00, reply: "0B 47 FC 90 12 34"}
steps:
  - expect: {gateway.gw1.inputs: "5F 00 0B 47 FC 90 12 34"}
  - expect: {plc.TOS_Plant.gw1.line.online: true}
    within: 300 ms
"""
TIMES = """times: {profibus: 5 ms, start: 13 ms, execution: 4 ms}
variations: [{cycle_time_ms: 20}]
steps:
  - expect: {cpu.mode: RUN}
    within: 50 ms
"""


def test_a_gateway_that_kept_its_supply_shows_what_it_had(tmp_path: Path) -> None:
    (case,) = scenario_cases(written(tmp_path, ECHO))
    result = run_case(case, load_catalog())
    assert result.failures == ()


def test_bus_and_plc_have_the_times_of_the_scenario(tmp_path: Path) -> None:
    (case,) = scenario_cases(written(tmp_path, TIMES))
    run = prepare(case, load_catalog())
    plant = run.installation
    run.run()
    assert plant.master.times.period_ns == 5 * NS_PER_MS
    assert plant.cpu.settings.execution_ns == 4 * NS_PER_MS
    assert plant.plan.cycle_time_ms == 20
    assert plant.kernel.now_ns >= 13 * NS_PER_MS
    assert case.changes == "[cycle 20 ms]"


@pytest.mark.parametrize(
    ("text", "code", "line", "column"),
    [
        ("gateways:\n  gw9: {trigger: 1}\n", "FB8003", 5, 3),
        ("gateways:\n  gw1: {trigger: 256}\n", "FB1007", 5, 18),
        ("gateways:\n  gw1: {trigger: first}\n", "FB1007", 5, 18),
        ('gateways:\n  gw1: {reply: "0B 47"}\n', "FB1007", 5, 16),
        ("times: {profibus: 0 ms}\n", "FB1007", 4, 19),
        ("variations: [{cycle_time_ms: 0}]\n", "FB1007", 4, 30),
    ],
)
def test_what_cannot_be_is_told_at_its_place(
    tmp_path: Path, text: str, code: str, line: int, column: int
) -> None:
    path = written(tmp_path, f"{text}steps: [{{expect: {{cpu.mode: RUN}}}}]\n")
    with pytest.raises(DiagnosticError) as refused:
        prepare(scenario_cases(path)[0], load_catalog())
    (found,) = refused.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == (code, line, column)


def test_a_block_has_no_gateways_and_no_times(tmp_path: Path) -> None:
    path = tmp_path / "block.scenario.yaml"
    path.write_text(
        "version: 1\ntitle: A block\nsources: [none.scl]\nblock: B\ntimes: {start: 1 ms}\n"
        "gateways: {gw1: {trigger: 1}}\nsteps: [{call: 1}, {expect: {block.x: 1}}]\n",
        "utf-8",
    )
    with pytest.raises(DiagnosticError) as refused:
        scenario_cases(path)
    assert [item.code for item in refused.value.diagnostics] == ["FB8018", "FB8018"]
