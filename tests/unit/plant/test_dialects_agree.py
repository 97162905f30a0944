"""The text of every dialect, read back and run, moves the same bytes at the same instants.

Each scenario runs on two plants that differ in nothing but the dialect. What is compared is every
transfer between master and gateway: when, which outputs, which inputs. The same holds for the two
engines. The long form takes every scenario file; those of a block alone pass in every dialect.
"""

from dataclasses import replace
from itertools import cycle
from pathlib import Path
from typing import Any

import pytest

from fbgen.catalog import load_catalog
from harness.fieldbus import Transfer
from harness.scenario import find_scenarios, prepare, run_case, scenario_cases
from harness.scenario.model import Variation

ROOT = Path(__file__).parents[3]
SCENARIOS = (
    "examples/manual_example/manual_example.scenario.yaml",
    "tests/scenarios/five_drives_polled.scenario.yaml",
    "tests/scenarios/start_and_stop.scenario.yaml",
    "tests/scenarios/trip_and_reset.scenario.yaml",
    "tests/scenarios/drive_lost_and_back.scenario.yaml",
    "tests/scenarios/gateway_power_cycle.scenario.yaml",
    "tests/scenarios/plc_restart_in_a_telegram.scenario.yaml",
    "tests/scenarios/two_drives_at_once.scenario.yaml",
)
FOR_ONE_PLC = (
    *("gateway_lost_", "error_block", "own_sequences", "torn_process_image"),
    *("alarms_of_a_line", "handshake_switched_off", "cyclic_data"),
    *("reads_refused", "writes_refused"),
)
"""Scenarios about one family, one access way or one option."""

FOR_DIRECT_ACCESS = ("five_drives_stopped_from_the_start", "tripped_is_not_running")
"""Scenarios whose times are those of accesses that do not wait for the process image."""


def needs_direct_access(name: str) -> bool:
    return any(part in name for part in FOR_DIRECT_ACCESS)


OTHERS = {
    str(path.relative_to(ROOT)): scenario_cases(path)[0].scenario.block is not None
    for path in find_scenarios([ROOT / "tests" / "scenarios"])
    if not any(part in str(path) for part in FOR_ONE_PLC)
    and str(path.relative_to(ROOT)) not in SCENARIOS
}
"""The other scenarios, and whether they are about a block alone, which moves nothing on a bus."""

EVERY = [name for name, alone in OTHERS.items() if not alone]
OF_BLOCKS = [name for name, alone in OTHERS.items() if alone]
WHOLE = {"layout": "whole10", "access": "dpxx_dat"}
IMAGE = {"access": "process_image"}

TWINS: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "step7": ({"plc": "s7-300"}, {"plc": "s7-300", "dialect": "step7"}),
    "step7 SFC14/15": (
        {"plc": "s7-400", **WHOLE},
        {"plc": "s7-400", "dialect": "step7", **WHOLE},
    ),
    "step7 image": ({"plc": "s7-300", **IMAGE}, {"plc": "s7-300", "dialect": "step7", **IMAGE}),
    "twincat": (IMAGE, {"plc": "twincat", "dialect": "twincat", **IMAGE}),
    "plcopen": (IMAGE, {"plc": "iec", "dialect": "plcopen", **IMAGE}),
    "iec": (IMAGE, {"plc": "iec", "dialect": "iec", **IMAGE}),
}
COMPARED = [
    *((name, twins) for name in SCENARIOS for twins in TWINS),
    *(
        pytest.param(name, twins, marks=pytest.mark.slow)
        for name in EVERY
        for twins, (first, _) in TWINS.items()
        if "access" not in first
        or first["access"] == WHOLE["access"]
        or not needs_direct_access(name)
    ),
]
OF_DIALECT: dict[str, dict[str, Any]] = {
    "tia": {},
    "step7": {"plc": "s7-300", "dialect": "step7"},
    "iec": {"plc": "iec", "dialect": "iec", **IMAGE},
}
PAIRS = [
    *(("tests/scenarios/plc_restart_in_a_telegram.scenario.yaml", item) for item in OF_DIALECT),
    *(
        pytest.param(name, dialect, marks=pytest.mark.slow)
        for name, dialect in zip(EVERY, cycle(OF_DIALECT), strict=False)
        if dialect != "iec" or not needs_direct_access(name)
    ),
]
"""The reference engine is slow: it runs each scenario in one dialect, the dialects taking turns."""
CATALOG = load_catalog()


Run = list[tuple[int, str, bytes, bytes]]
_RUNS: dict[str, Run] = {}


def transfers(path: Path, changes: dict[str, Any], engine: str = "compiled") -> Run:
    """Every transfer of a scenario on the plant with these changes; each is run once."""
    key = f"{path} {sorted(changes.items())} {engine}"
    if key not in _RUNS:
        _RUNS[key] = _transfers(path, changes, engine)
    return _RUNS[key]


def _transfers(path: Path, changes: dict[str, Any], engine: str) -> Run:
    found: Run = []

    def note(one: Transfer) -> None:
        name = one.station.settings.name
        found.append((one.time_ns, name, bytes(one.outputs), bytes(one.inputs)))

    case = scenario_cases(path)[0]
    scenario = case.scenario.model_copy(update={"engine": engine})
    run = prepare(replace(case, scenario=scenario, variation=Variation(**changes)), CATALOG)
    run.installation.master.taps.append(note)
    run.run()
    return found


@pytest.mark.parametrize(("scenario", "twins"), COMPARED)
def test_a_dialect_does_what_tia_does(scenario: str, twins: str) -> None:
    first, second = (transfers(ROOT / scenario, changes) for changes in TWINS[twins])
    assert len(first) > 5
    assert second == first


@pytest.mark.slow
@pytest.mark.parametrize("twins", TWINS)
@pytest.mark.parametrize("scenario", OF_BLOCKS)
def test_a_block_alone_passes_in_every_dialect(scenario: str, twins: str) -> None:
    case = scenario_cases(ROOT / scenario)[0]
    result = run_case(replace(case, variation=Variation(**TWINS[twins][1])), CATALOG)
    assert result.passed, result.render()


@pytest.mark.parametrize(("scenario", "dialect"), PAIRS)
def test_both_engines_do_the_same(scenario: str, dialect: str) -> None:
    first, second = (
        transfers(ROOT / scenario, OF_DIALECT[dialect], engine)
        for engine in ("compiled", "reference")
    )
    assert len(first) > 5
    assert second == first


def test_another_program_is_told_from_it() -> None:
    path = ROOT / SCENARIOS[0]
    assert transfers(path, IMAGE) != transfers(path, {})
