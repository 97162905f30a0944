"""Who looks on while a scenario runs: a recorder of its trace, a collector of coverage.

An observer belongs to one run. It is made in the process that runs the scenario, looks on from
before the start, and leaves one piece of data that goes back with the result:

    options = RunOptions(observers=(TraceObserver,))
    for result in run_paths(paths, options).results:
        trace = result.observed(Trace)
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol, TypeAlias

from fbgen.diagnostics import Diagnostic
from harness.engine.compiled.watching.probes import ProbeMaker
from harness.results import ScenarioReport, ScenarioResult

if TYPE_CHECKING:
    from harness.scenario.cases import ScenarioCase
    from harness.scenario.runner import ScenarioRun


class Observer(Protocol):
    """Looks on at one run."""

    @property
    def probes(self) -> Sequence[ProbeMaker]:
        """What it puts into the compiled PLC text; the reference engine takes none."""
        ...

    def attach(self, run: "ScenarioRun") -> None:
        """The plant is built, nothing has happened yet; `run.on_step` tells of the steps."""
        ...

    def finish(self, result: ScenarioResult) -> object | None:
        """What it leaves, to be sent between processes; the run has ended, well or not."""
        ...


ObserverMaker: TypeAlias = "Callable[[ScenarioCase], Observer]"
"""Makes the observer of one run. It is sent to other processes: a class or a function of a module,
or a frozen dataclass with `__call__`."""


class ReportWriter(Protocol):
    """Writes a report on a session, such as a file that somebody has asked for."""

    @property
    def observers(self) -> Sequence[ObserverMaker]:
        """Who has to look on so that the report can be written."""
        ...

    def write(self, report: ScenarioReport) -> Sequence[Diagnostic]:
        """Write it. What is found wrong on the way, such as too little coverage, fails the command.

        After Ctrl-C the report has what ran until then. Raises DiagnosticError where it cannot be
        written; the others still are.
        """
        ...
