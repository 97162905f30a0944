"""Scenario files: what is done to a plant and what must come of it, without writing Python."""

from harness.results import ScenarioReport, ScenarioResult
from harness.scenario.cases import ScenarioCase, prepare, run_case
from harness.scenario.events import StepEvent, StepMoment
from harness.scenario.files import (
    SUFFIX,
    find_scenarios,
    run_paths,
    scenario_cases,
)
from harness.scenario.observers import Observer, ObserverMaker, ReportWriter
from harness.scenario.options import RunOptions

__all__ = [
    "SUFFIX",
    "Observer",
    "ObserverMaker",
    "ReportWriter",
    "RunOptions",
    "ScenarioCase",
    "ScenarioReport",
    "ScenarioResult",
    "StepEvent",
    "StepMoment",
    "find_scenarios",
    "prepare",
    "run_case",
    "run_paths",
    "scenario_cases",
]
