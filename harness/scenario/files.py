"""Scenario files: found, read, run, one after the other."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from fbgen.catalog import Catalog, load_catalog, load_yaml, validate
from fbgen.catalog.catalog import read_source
from fbgen.diagnostics import Diagnostic, DiagnosticError
from harness.scenario.cases import ScenarioCase, run_case
from harness.scenario.model import Scenario
from harness.scenario.results import ScenarioReport, ScenarioResult
from harness.scenario.selection import Selection, parse_selection

SUFFIX = ".scenario.yaml"
"""Files with this ending in a folder are taken as scenarios."""


def find_scenarios(paths: Sequence[Path]) -> tuple[Path, ...]:
    """The scenario files among the paths and in the folders among them, in order of their names.

    Raises DiagnosticError FB8007 for each path that is not there and each folder without any.
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
    """The scenario in a file. Raises DiagnosticError FB1001 to FB1008, FB8002, FB8008."""
    return validate(load_yaml(read_source(path, path.as_posix())), Scenario)


def scenario_cases(path: Path) -> tuple[ScenarioCase, ...]:
    """A file's scenario once for each of its variations. Raises DiagnosticError as the above."""
    return ScenarioCase.of(path, load_scenario(path))


def run_paths(
    paths: Sequence[Path],
    *,
    seed: int | None = None,
    select: str = "",
    dialect: str | None = None,
    finished: Callable[[ScenarioResult], None] = lambda result: None,
) -> ScenarioReport:
    """Run the scenarios of files and folders.

    `seed` takes the place of the files' own seeds; `select` is an expression over titles, files,
    variations and tags, see `harness.scenario.selection`; `finished` is told of each result as
    soon as it is there. `dialect` takes the place of that of each plant file.

    Raises DiagnosticError FB8007 for missing files and FB8011 for a wrong expression. What is wrong
    in a file is a failure of its result.
    """
    selection = parse_selection(select)
    files = find_scenarios(paths)
    catalog = load_catalog()
    results: list[ScenarioResult] = []
    for path in files:
        for result in _run_file(path, catalog, seed, selection, dialect):
            results.append(result)
            finished(result)
    return ScenarioReport(tuple(results))


def _run_file(
    path: Path, catalog: Catalog, seed: int | None, selection: Selection, dialect: str | None
) -> Iterable[ScenarioResult]:
    """The results of one file. What is wrong in the file itself is told once, not per variation."""
    try:
        cases = [replace(case, dialect=dialect) for case in scenario_cases(path)]
    except DiagnosticError as wrong:
        yield ScenarioResult(path.name, path.as_posix(), seed or 0, False, wrong.diagnostics)
        return
    told: tuple[Diagnostic, ...] = ()
    for case in cases:
        if not selection(case.names):
            continue
        result = run_case(case, catalog, seed)
        if result.failures and not result.virtual_ns and result.failures == told:
            continue
        told = result.failures
        yield result
