"""Coverage of scenarios: who collects it while they run."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import PurePath

from harness.engine.compiled import ProbeMaker
from harness.results import ScenarioReport, ScenarioResult
from harness.scenario.cases import ScenarioCase
from harness.scenario.runner import ScenarioRun
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.watching import watch


class CoverageObserver:
    """Collects the coverage of one run."""

    def __init__(self, case: ScenarioCase) -> None:
        self._coverage = Coverage()
        self._plant_file = case.scenario.plant

    @property
    def probes(self) -> Sequence[ProbeMaker]:
        """What counts in the PLC text."""
        return (self._coverage,)

    def attach(self, run: ScenarioRun) -> None:
        """Note for which plant the text was generated, and look on at its devices."""
        installation = run.stage.installation
        if installation is not None:
            self._coverage.name_plant(installation.plan.name)
            watch(installation, self._coverage.catalogue)
        elif self._plant_file is not None:
            self._coverage.name_plant(PurePath(self._plant_file).stem)

    def finish(self, _: ScenarioResult) -> Coverage:
        """What was reached."""
        return self._coverage


def coverage_of(report: ScenarioReport) -> Coverage:
    """What all runs of a session have reached together."""
    coverage = Coverage()
    coverage.merge(collected_by(report.results))
    return coverage


def collected_by(results: Iterable[ScenarioResult]) -> Iterator[Coverage]:
    """What each run has collected."""
    found = (result.observed(Coverage) for result in results)
    return (one for one in found if one is not None)
