"""Scenario files: found, read, run, one after the other."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from fbgen.catalog import Catalog, load_catalog, load_yaml, validate
from fbgen.catalog.catalog import read_source
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.plant import Plant, load_plant
from harness.installation import Installation, PlantSetup, build_plant
from harness.scenario.model import Scenario, Variation
from harness.scenario.results import ScenarioReport, ScenarioResult
from harness.scenario.runner import ScenarioRun

SUFFIX = ".scenario.yaml"
"""Files with this ending in a folder are taken as scenarios."""


def find_scenarios(paths: Sequence[Path]) -> tuple[Path, ...]:
    """The scenario files among the paths and in the folders among them, in order of their names.

    Raises DiagnosticError FB8007 for a path that is not there or a folder without any.
    """
    found: list[Path] = []
    missing: list[Diagnostic] = []
    for path in paths:
        inside = sorted(path.rglob(f"*{SUFFIX}")) if path.is_dir() else [path]
        if not path.exists() or not inside:
            what = "there is no scenario in the folder" if path.is_dir() else "there is no file"
            advice = f"scenario files end in {SUFFIX}"
            missing.append(Diagnostic("FB8007", f"{what} {path.as_posix()}", help=advice))
        found += inside
    if missing:
        raise DiagnosticError(missing)
    return tuple(dict.fromkeys(found))


def load_scenario(path: Path) -> Scenario:
    """The scenario in a file. Raises DiagnosticError FB1001 to FB1008, FB8002."""
    return validate(load_yaml(read_source(path, path.as_posix())), Scenario)


def run_paths(
    paths: Sequence[Path],
    *,
    seed: int | None = None,
    select: str = "",
    finished: Callable[[ScenarioResult], None] = lambda result: None,
) -> ScenarioReport:
    """Run the scenarios of files and folders.

    `seed` takes the place of the files' own seeds; `select` runs only those whose title, file or
    tag contains it; `finished` is told of each result as soon as it is there.
    """
    catalog = load_catalog()
    results: list[ScenarioResult] = []
    for path in find_scenarios(paths):
        for result in run_file(path, catalog, seed=seed, select=select):
            results.append(result)
            finished(result)
    return ScenarioReport(tuple(results))


def run_file(
    path: Path, catalog: Catalog, *, seed: int | None = None, select: str = ""
) -> Iterable[ScenarioResult]:
    """Run one file, once for each of its variations; findings become failures of the result."""
    shown = path.as_posix()
    used_seed = seed or 0
    try:
        scenario = load_scenario(path)
        if select and not _selected(scenario, shown, select):
            return
        used_seed = scenario.seed if seed is None else seed
        plant = load_plant(path.parent / scenario.plant, catalog)
    except DiagnosticError as wrong:
        yield ScenarioResult(path.name, shown, used_seed, False, wrong.diagnostics)
        return
    for variation in scenario.variations or (Variation(),):
        name = f"{scenario.title}{_suffix(variation)}"
        try:
            changed = varied(plant, variation, catalog)
        except DiagnosticError as wrong:
            yield ScenarioResult(name, shown, used_seed, False, wrong.diagnostics)
            continue
        result = ScenarioResult(name, shown, used_seed, passed=True)
        yield _run(result, scenario, changed, catalog)


def _run(
    result: ScenarioResult, scenario: Scenario, plant: Plant, catalog: Catalog
) -> ScenarioResult:
    checks = virtual_ns = 0
    found: tuple[Diagnostic, ...] = ()
    try:
        run = ScenarioRun(scenario, _build(scenario, plant, catalog, result.seed), catalog)
        try:
            run.run()
        finally:
            checks, virtual_ns = run.checks, run.installation.kernel.now_ns
    except DiagnosticError as wrong:
        found = wrong.diagnostics
    if not found and not checks:
        advice = "add a step with expect:"
        found = (Diagnostic("FB8008", "the scenario checks nothing", scenario.span, advice),)
    return replace(result, passed=not found, failures=found, checks=checks, virtual_ns=virtual_ns)


def prepare(scenario: Scenario, path: Path, catalog: Catalog) -> ScenarioRun:
    """The scenario of a file on its plant as the plant file says, ready to run."""
    plant = load_plant(path.parent / scenario.plant, catalog)
    installation = _build(scenario, plant, catalog, scenario.seed)
    return ScenarioRun(scenario, installation, catalog)


def _build(scenario: Scenario, plant: Plant, catalog: Catalog, seed: int) -> Installation:
    drives = {name: setup.conditions() for name, setup in scenario.drives.items()}
    return build_plant(plant, catalog, PlantSetup(seed, scenario.engine, drives))


def varied(plant: Plant, variation: Variation, catalog: Catalog) -> Plant:
    """The plant with the changes of a variation; DiagnosticError if it does not allow them."""
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
    if variation.dialect is not None:
        changes["dialect"] = variation.dialect
    if variation.plc is not None:
        changes["plc"] = variation.plc
    changed = plant.model_copy(update=changes)
    found = [
        *changed.problems(),
        *changed.problems_against(catalog),
        *(item for gateway in gateways for item in gateway.problems_against(catalog)),
    ]
    if found:
        raise DiagnosticError(found)
    return changed


def _suffix(variation: Variation) -> str:
    parts = [variation.dialect, variation.plc, variation.layout, variation.access]
    parts += [f"{name}={value}" for name, value in variation.options.items()]
    shown = ", ".join(part for part in parts if part)
    return f" [{shown}]" if shown else ""


def _selected(scenario: Scenario, file: str, select: str) -> bool:
    wanted = select.casefold()
    return any(wanted in text.casefold() for text in (scenario.title, file, *scenario.tags))
