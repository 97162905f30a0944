"""One scenario on one plant: the file's plant with the changes of one variation, built and run."""

import os.path
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from fbgen.catalog import Catalog, Drive, with_own_sequences
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note, error
from fbgen.nearest import nearest
from fbgen.plant import Plant, in_dialect, load_plant, problems_of
from harness.drives import Inverter, InverterSettings
from harness.installation import PlantSetup, build_plant
from harness.kernel import Kernel
from harness.line import Line
from harness.results import ScenarioResult
from harness.scenario.model import DriveSetup, Scenario, Variation
from harness.scenario.observers import Observer, ObserverMaker
from harness.scenario.places import at, key_span, value_span
from harness.scenario.runner import ScenarioRun


@dataclass(frozen=True, slots=True)
class ScenarioCase:
    """A scenario of a file with one of its variations.

    `dialect` takes the place of that of the variation and of the plant file.
    """

    path: Path
    scenario: Scenario
    variation: Variation
    dialect: str | None = None

    @classmethod
    def of(cls, path: Path, scenario: Scenario) -> tuple["ScenarioCase", ...]:
        """A scenario once for each of its variations, once if it has none."""
        return tuple(cls(path, scenario, item) for item in scenario.variations or (Variation(),))

    @property
    def changes(self) -> str:
        """The changes of the variation in brackets; empty for the plant as it is."""
        variation = self.variation
        dialect = self.dialect or variation.dialect
        parts = [dialect, variation.plc, variation.layout, variation.access, variation.prefix]
        parts += [f"{name}={value}" for name, value in variation.options.items()]
        parts += [f"error_obs={variation.error_obs}"] if variation.error_obs else []
        shown = ", ".join(part for part in parts if part)
        return f"[{shown}]" if shown else ""

    @property
    def name(self) -> str:
        """Title and changes."""
        return f"{self.scenario.title} {self.changes}".rstrip()

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
    used = case.scenario.seed if seed is None else seed
    result = ScenarioResult(
        *(case.name, case.path.as_posix(), used, True),
        changes=case.changes,
        dialect=case.dialect,
        plant=_plant_path(case).as_posix(),
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
    virtual_ns = run.installation.kernel.now_ns
    result = replace(
        result,
        passed=not found,
        failures=found,
        checks=run.checks,
        virtual_ns=virtual_ns,
        ran_dialect=run.installation.plan.dialect,
    )
    left = (observer.finish(result) for observer in watching)
    return replace(result, observations=tuple(item for item in left if item is not None))


def prepare(
    case: ScenarioCase,
    catalog: Catalog,
    seed: int | None = None,
    observers: Sequence[Observer] = (),
) -> ScenarioRun:
    """The scenario on its plant, ready to run.

    Raises DiagnosticError with everything that is wrong in the plant, or in the scenario for that
    plant.
    """
    scenario = case.scenario
    path = _plant_file(case)
    catalog = with_own_sequences(catalog, path.parent)
    plan = _varied(load_plant(path, catalog), case.variation, catalog)
    if case.dialect is not None:
        plan = in_dialect(plan, case.dialect, catalog)
    if found := list(_drive_problems(scenario, plan, catalog)):
        raise DiagnosticError(found)
    setup = PlantSetup(
        scenario.seed if seed is None else seed,
        scenario.engine,
        {name: setup.conditions() for name, setup in scenario.drives.items()},
        probes=tuple(probe for observer in observers for probe in observer.probes),
    )
    run = ScenarioRun(scenario, build_plant(plan, catalog, setup), catalog)
    for observer in observers:
        observer.attach(run)
    return run


def _plant_path(case: ScenarioCase) -> Path:
    return Path(os.path.normpath(case.path.parent / case.scenario.plant))


def _plant_file(case: ScenarioCase) -> Path:
    path = _plant_path(case)
    if not path.is_file():
        raise error(
            "FB8007",
            f"there is no plant file {path.as_posix()}",
            case.scenario.span_of("plant"),
            "name it as seen from the folder of the scenario",
        )
    return path


def _varied(plant: Plant, variation: Variation, catalog: Catalog) -> Plant:
    """The plant with the changes of a variation. DiagnosticError if it does not allow them."""
    gateway_changes = {
        key: value
        for key, value in (("layout", variation.layout), ("access", variation.access))
        if value is not None
    }
    gateways = tuple(
        gateway.model_copy(
            update={**gateway_changes, "options": {**gateway.options, **variation.options}}
        )
        for gateway in plant.gateways
    )
    changes: dict[str, object] = {"gateways": gateways}
    changes |= {
        key: value
        for key, value in (
            ("dialect", variation.dialect),
            ("plc", variation.plc),
            ("prefix", variation.prefix),
            ("error_obs", variation.error_obs),
        )
        if value is not None
    }
    changed = plant.model_copy(update=changes)
    if found := problems_of(changed, catalog):
        raise DiagnosticError(_of_variation(item, variation) for item in found)
    return changed


def _of_variation(found: Diagnostic, variation: Variation) -> Diagnostic:
    """What the plant does not allow, at the variation that asks for it."""
    notes = (*found.notes, Note("in the plant file the place is here", found.span))
    return replace(found, span=variation.span, notes=notes)


def _drive_problems(scenario: Scenario, plan: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB8003 for drives that the plant does not have, and what their series do not take."""
    known = {item.name: item for item in plan.drives}
    for name, setup in scenario.drives.items():
        if name in known:
            yield from _parameter_problems(setup, catalog.drive(known[name].series))
        else:
            message = f"there is no drive '{name}' in the plant '{plan.name}'"
            place = key_span(scenario, "drives", name)
            yield Diagnostic("FB8003", message, place, nearest(name, known))


def _parameter_problems(setup: DriveSetup, series: Drive) -> Iterator[Diagnostic]:
    """Each parameter tried on a drive of its own, so that each refusal gets its place."""
    for key, value in setup.parameters.items():
        kernel = Kernel()
        try:
            Inverter(kernel, Line(kernel), series, InverterSettings(parameters={key: value}))
        except DiagnosticError as refused:
            yield from at(value_span(setup, "parameters", key), refused.diagnostics)
