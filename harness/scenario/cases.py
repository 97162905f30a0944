"""One run of a scenario file: a row of its table, a variation of its plant, a seed."""

import os.path
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.results import ScenarioResult
from harness.scenario.model import Scenario, Variation
from harness.scenario.observers import Observer, ObserverMaker
from harness.scenario.runner import ScenarioRun
from harness.scenario.staging import Staging
from harness.scenario.temporaries import Temporaries


@dataclass(frozen=True, slots=True)
class ScenarioCase:
    """A scenario of a file with one of its variations.

    `dialect` takes the place of that of the variation and of the plant file. `row` names the row
    of the table of cases that is filled in, `repeats` tells that the scenario runs with more seeds
    than this one. `temporaries` were asked for beside the file, and stand in the scenario.
    """

    path: Path
    scenario: Scenario
    variation: Variation
    dialect: str | None = None
    row: str = ""
    seed: int = 0
    repeats: bool = False
    temporaries: Temporaries | None = None

    @property
    def changes(self) -> str:
        """Row and changes of the variation in brackets; empty for the plant as it is."""
        variation = self.variation
        dialect = self.dialect or variation.dialect
        parts = [
            self.row,
            dialect,
            variation.plc,
            variation.layout,
            variation.access,
            variation.prefix,
        ]
        parts += [f"{name}={value}" for name, value in variation.options.items()]
        cycle_ms = variation.cycle_time_ms
        parts += [f"cycle {cycle_ms:g} ms"] if cycle_ms is not None else []
        parts += [f"error_obs={variation.error_obs}"] if variation.error_obs else []
        shown = ", ".join(part for part in parts if part)
        return f"[{shown}]" if shown else ""

    @property
    def name(self) -> str:
        """Title, changes, and the seed of one that runs with several."""
        seed = f"seed {self.seed}" if self.repeats else ""
        return " ".join(part for part in (self.scenario.title, self.changes, seed) if part)

    @property
    def plant(self) -> Path | None:
        """The plant file; None for a block of its own."""
        name = self.scenario.plant
        return Path(os.path.normpath(self.path.parent / name)) if name is not None else None

    @property
    def names(self) -> tuple[str, ...]:
        """What `-k` looks at."""
        return (self.name, self.path.as_posix(), *self.scenario.tags)


def run_case(
    case: ScenarioCase,
    catalog: Catalog,
    seed: int | None = None,
    observers: Sequence[ObserverMaker] = (),
) -> ScenarioResult:
    """Run a scenario; whatever is found becomes a failure of the result."""
    used = case.seed if seed is None else seed
    result = ScenarioResult(
        *(case.name, case.path.as_posix(), used, True),
        changes=case.changes,
        dialect=case.dialect,
        plant=case.plant.as_posix() if case.plant is not None else "",
        expected_failure=case.scenario.expect_failure,
        temporaries=case.temporaries or "",
    )
    watching = [make(case) for make in observers]
    try:
        run = prepare(case, catalog, used, watching)
    except DiagnosticError as wrong:
        return replace(result, passed=False, failures=wrong.diagnostics)
    found: tuple[Diagnostic, ...] = ()
    try:
        run.run()
    except DiagnosticError as wrong:
        found = wrong.diagnostics
    passed = not found
    if case.scenario.expect_failure is not None:
        passed = bool(found)
        found = found or (_passed_after_all(case.scenario),)
    result = replace(
        result,
        passed=passed,
        failures=found,
        ran_dialect=run.stage.dialect,
        warnings=run.warnings,
        checks=run.checks,
        virtual_ns=run.stage.kernel.now_ns,
    )
    left = (observer.finish(result) for observer in watching)
    return replace(result, observations=tuple(item for item in left if item is not None))


def prepare(
    case: ScenarioCase,
    catalog: Catalog,
    seed: int | None = None,
    observers: Sequence[Observer] = (),
) -> ScenarioRun:
    """The scenario on its plant or block, ready to run.

    Raises DiagnosticError with everything that is wrong in the plant or the PLC text, or in the
    scenario for them.
    """
    used = case.seed if seed is None else seed
    probes = tuple(probe for observer in observers for probe in observer.probes)
    staging = Staging(case.path, case.scenario, catalog)
    run = ScenarioRun(case.scenario, staging.stage(case.variation, case.dialect, used, probes))
    for observer in observers:
        observer.attach(run)
    return run


def _passed_after_all(scenario: Scenario) -> Diagnostic:
    """FB8014: the reason why it should fail is gone."""
    return Diagnostic(
        "FB8014",
        f"the scenario passes, and was expected to fail: {scenario.expect_failure}",
        scenario.span_of("expect_failure"),
        "leave out expect_failure: from now on it has to pass",
    )
