"""Which line of the PLC wrote the value of a failing check: found by running the scenario again.

A run gives the same again, so nobody has to take notes in runs that pass.
"""

from collections.abc import Sequence
from dataclasses import replace

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic
from harness.engine.compiled import ProbeMaker, writers_probe
from harness.results import ScenarioResult
from harness.scenario.cases import ScenarioCase, run_case
from harness.scenario.runner import ScenarioRun
from harness.trace import Trace

_ABOUT_VALUES = ("FB8001", "FB8020")


class WriterNotes:
    """Looks on at a run so that its failures can name who wrote the values; leaves nothing."""

    probes: tuple[ProbeMaker, ...] = (writers_probe,)

    def __init__(self, case: ScenarioCase) -> None:
        """Whatever the case is."""

    def attach(self, run: ScenarioRun) -> None:
        """The probe is all that is needed."""

    def finish(self, result: ScenarioResult) -> None:
        """Nothing is left."""


def explained(case: ScenarioCase, result: ScenarioResult, catalog: Catalog) -> ScenarioResult:
    """The result; where a check has failed, with the lines that wrote the values."""
    trace = result.observed(Trace)
    if (
        result.passed
        or case.scenario.engine != "compiled"
        or (trace is not None and trace.writers)
        or all(failure.code not in _ABOUT_VALUES for failure in result.failures)
    ):
        return result
    again = run_case(case, catalog, result.seed, [WriterNotes])
    if _messages(again.failures) != _messages(result.failures):
        return result
    return replace(result, failures=again.failures)


def _messages(failures: Sequence[Diagnostic]) -> list[str]:
    return [failure.message for failure in failures]
