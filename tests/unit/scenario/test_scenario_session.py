"""A session of scenarios: several processes, Ctrl-C, and those who look on."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from harness.engine.compiled.watching.probes import ProbeMaker
from harness.scenario import (
    RunOptions,
    ScenarioCase,
    ScenarioResult,
    StepEvent,
    StepMoment,
    run_paths,
)
from harness.scenario.runner import ScenarioRun
from tests.unit.scenario.scenario_files import steps, written

TEXT = "variations: [{}, {layout: doc9}, {plc: s7-300}]\n" + steps(
    "- wait: 20 ms",
    "- expect: {drive.pump.running: false}",
    "- expect: {drive.pump.running: true}",
)


@dataclass(frozen=True)
class Seen:
    """What an observer leaves."""

    case: str
    passed: bool
    told: tuple[tuple[str, int], ...]


@dataclass
class Looking:
    """Notes the steps of one run."""

    case: ScenarioCase
    probes: Sequence[ProbeMaker] = ()
    events: list[StepEvent] = field(default_factory=list)

    def attach(self, run: ScenarioRun) -> None:
        assert run.installation.kernel.now_ns == 0
        run.on_step.append(self.events.append)

    def finish(self, result: ScenarioResult) -> Seen:
        told = tuple((item.moment.name, item.time_ns) for item in self.events)
        return Seen(self.case.name, result.passed, told)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """Three cases that fail at their third step."""
    return written(tmp_path, TEXT)


@pytest.mark.parametrize("jobs", [1, 2])
def test_what_an_observer_leaves_goes_with_the_result(path: Path, jobs: int) -> None:
    results = run_paths([path], RunOptions(jobs=jobs, observers=(Looking,))).results
    begun, done, failed = (moment.name for moment in StepMoment)
    for result in results:
        seen = result.observed(Seen)
        assert seen is not None
        assert (seen.case, seen.passed) == (result.name, False)
        assert [moment for moment, _ in seen.told] == [begun, done, begun, done, begun, failed]
        assert [time_ns for _, time_ns in seen.told] == [0, *[result.virtual_ns] * 5]
    assert results[0].observed(StepEvent) is None


def test_several_processes_give_the_same_results_in_the_same_order(path: Path) -> None:
    alone, shared = (run_paths([path], RunOptions(jobs=jobs)).results for jobs in (1, 3))
    assert [item.as_json() for item in shared] == [item.as_json() for item in alone]
    assert len(alone) == 3


@pytest.mark.parametrize("jobs", [1, 2])
def test_after_ctrl_c_the_report_has_what_ran(path: Path, jobs: int) -> None:
    told: list[int] = []

    def interrupt(_: ScenarioResult) -> None:
        raise KeyboardInterrupt

    report = run_paths([path], RunOptions(jobs=jobs), planned=told.append, finished=interrupt)
    assert (told, len(report.results), report.interrupted) == ([3], 1, True)
