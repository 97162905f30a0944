"""Scenario files: what is done to a plant and what must come of it, without writing Python."""

from harness.scenario.files import SUFFIX, find_scenarios, load_scenario, prepare, run_paths
from harness.scenario.results import ScenarioReport, ScenarioResult

__all__ = [
    "SUFFIX",
    "ScenarioReport",
    "ScenarioResult",
    "find_scenarios",
    "load_scenario",
    "prepare",
    "run_paths",
]
