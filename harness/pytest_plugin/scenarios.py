"""Scenario files as tests: one for each row, variation and seed, failing with the same text."""

import os
from collections.abc import Iterable
from functools import cache
from typing import Any

import pytest

from fbgen.catalog import Catalog, load_catalog
from fbgen.diagnostics import DiagnosticError, render
from harness.pytest_plugin import SEED
from harness.pytest_plugin.coverage import coverage_of
from harness.pytest_plugin.naming import near
from harness.results import ScenarioResult
from harness.scenario import RunOptions, ScenarioCase, run_case, scenario_cases
from harness.scenario.explaining import explained
from harness.verify.coverage.observing import CoverageObserver, collected_by


class ScenarioWarning(pytest.PytestWarning):
    """What a scenario that has passed does not show."""


class ScenarioFailedError(Exception):
    """Carries the result to the report."""

    def __init__(self, result: ScenarioResult) -> None:
        super().__init__(result.name)
        self.result = result


class ScenarioFile(pytest.File):
    """One scenario file."""

    def collect(self) -> Iterable[pytest.Item]:
        """Its cases; a mistake in the file fails the collection with its places."""
        options = RunOptions(seed=self.config.getoption(SEED))
        try:
            cases = scenario_cases(near(self.path), options)
        except DiagnosticError as wrong:
            text = "\n".join(render(found) for found in wrong.diagnostics)
            raise self.CollectError(text) from None
        for case in cases:
            yield ScenarioItem.from_parent(self, name=_name(case), case=case)


class ScenarioItem(pytest.Item):
    """One run of a scenario. Its tags are keywords for -k and -m."""

    def __init__(
        self, name: str, parent: ScenarioFile, case: ScenarioCase, **arguments: Any
    ) -> None:
        super().__init__(name, parent, **arguments)
        self.case = case
        self.extra_keyword_matches |= {*case.scenario.tags, case.scenario.title}
        self.user_properties.append(("fbgen_seed", case.seed))

    def runtest(self) -> None:
        """Run it; a failure that is expected is reported as such."""
        catalog = _shipped_catalog()
        coverage = coverage_of(self.config)
        observers = () if coverage is None else (CoverageObserver,)
        result = run_case(self.case, catalog, observers=observers)
        if coverage is not None:
            coverage.merge(collected_by([result]))
        result = explained(self.case, result, catalog)
        for warning in result.warnings:
            self.warn(ScenarioWarning(render(warning)))
        if not result.passed:
            raise ScenarioFailedError(result)
        if result.expected_failure is not None:
            pytest.xfail(result.expected_failure)

    def repr_failure(
        self, excinfo: pytest.ExceptionInfo[BaseException], style: object = None
    ) -> str:
        """The text of `fbgen test`."""
        if isinstance(excinfo.value, ScenarioFailedError):
            return excinfo.value.result.render()
        return str(excinfo.getrepr(style="long"))

    def reportinfo(self) -> tuple[os.PathLike[str], int | None, str]:
        """Where it stands: its steps."""
        span = self.case.scenario.span_of("steps")
        return self.path, span.line - 1 if span is not None else None, self.case.name


def _name(case: ScenarioCase) -> str:
    """For node ids: row, variation and seed, without blanks."""
    changes = case.changes.strip("[]").replace(", ", "-").replace(" ", "_")
    parts = [changes or "scenario"]
    parts += [f"seed{case.seed}"] if case.repeats else []
    return "-".join(parts)


@cache
def _shipped_catalog() -> Catalog:
    return load_catalog()
