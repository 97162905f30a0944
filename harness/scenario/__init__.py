"""Scenario files: what is done to a plant and what must come of it, without writing Python."""

from harness.scenario.cases import ScenarioCase, prepare, run_case
from harness.scenario.files import (
    SUFFIX,
    find_scenarios,
    load_scenario,
    run_paths,
    scenario_cases,
)
from harness.scenario.results import ScenarioReport, ScenarioResult

__all__ = [
    "SUFFIX",
    "ScenarioCase",
    "ScenarioReport",
    "ScenarioResult",
    "find_scenarios",
    "load_scenario",
    "prepare",
    "run_case",
    "run_paths",
    "scenario_cases",
]
