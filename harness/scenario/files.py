"""Scenario files: found, read, run, one after the other or several at the same time."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

from fbgen.cache import remembered
from fbgen.catalog import Catalog, load_catalog, load_yaml
from fbgen.catalog.catalog import read_source
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.workers import in_order
from harness.results import ScenarioReport, ScenarioResult
from harness.scenario.case_table import filled_in
from harness.scenario.cases import ScenarioCase, run_case
from harness.scenario.explaining import explained
from harness.scenario.model import Variation
from harness.scenario.options import RunOptions
from harness.scenario.seeds import seeds_of
from harness.scenario.selection import parse_selection

_AS_IT_IS = Variation.model_construct()
"""No variation: the plant of the file. It needs no check."""

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


def scenario_cases(path: Path, options: RunOptions | None = None) -> tuple[ScenarioCase, ...]:
    """A file's scenario once for each row of its table, each of its variations and each seed.

    `options` may give another seed, dialect, and start of temporary variables.

    Raises DiagnosticError FB1001 to FB1008, FB8002, FB8008, FB8015 to FB8018.
    """
    options = options or RunOptions()
    cases: list[ScenarioCase] = []
    temporaries = options.temporaries
    source = read_source(path, path.as_posix())
    parts = ("scenario", source.name, source.text)
    for row, scenario in remembered(parts, lambda: filled_in(load_yaml(source))):
        if temporaries is not None:
            scenario = scenario.model_copy(update={"temporaries": temporaries})
        seeds = seeds_of(scenario.seed, scenario.seeds)
        if options.seed is not None:
            seeds = (options.seed,)
        dialect = options.dialect if scenario.plant is not None else None
        cases += [
            ScenarioCase(
                *(path, scenario, variation, dialect, row, seed),
                repeats=len(seeds) > 1,
                temporaries=temporaries,
            )
            for variation in scenario.variations or (_AS_IT_IS,)
            for seed in seeds
        ]
    return tuple(cases)


def run_paths(
    paths: Sequence[Path],
    options: RunOptions | None = None,
    *,
    planned: Callable[[int], None] = lambda count: None,
    finished: Callable[[ScenarioResult], None] = lambda result: None,
) -> ScenarioReport:
    """Run the scenarios of files and folders.

    `planned` is told how many there are, `finished` of each result as soon as it is there. Ctrl-C
    ends the session: what had ended until then is in the report.

    Raises DiagnosticError FB8007 for missing files, FB8011 for a wrong expression, and what is
    wrong in a catalogue. What is wrong in a file is a failure of its result.
    """
    options = options or RunOptions()
    selection = parse_selection(options.select)
    if options.catalog:
        _catalog.cache_clear()
        _catalog(options.catalog)
    work = [
        item
        for path in find_scenarios(paths)
        for item in _of_file(path, options)
        if isinstance(item, ScenarioResult) or selection(item.names)
    ]
    planned(len(work))
    results: list[ScenarioResult] = []
    try:
        for result in in_order(partial(_run, options), work, options.jobs):
            if results and _tells_nothing_new(result, results[-1]):
                continue
            results.append(result)
            finished(result)
    except KeyboardInterrupt:
        return ScenarioReport(tuple(results), interrupted=True)
    return ScenarioReport(tuple(results))


def _of_file(path: Path, options: RunOptions) -> Sequence[ScenarioCase | ScenarioResult]:
    """The cases of a file, or what is wrong in it."""
    try:
        return scenario_cases(path, options)
    except DiagnosticError as wrong:
        name, file = path.name, path.as_posix()
        return [ScenarioResult(name, file, options.seed or 0, False, wrong.diagnostics)]


def _run(options: RunOptions, item: ScenarioCase | ScenarioResult) -> ScenarioResult:
    if isinstance(item, ScenarioResult):
        return item
    catalog = _catalog(options.catalog)
    result = explained(item, run_case(item, catalog, observers=options.observers), catalog)
    return replace(result, catalog=tuple(folder.as_posix() for folder in options.catalog))


@cache
def _catalog(folders: tuple[Path, ...]) -> Catalog:
    """Read once in each process of a session."""
    return load_catalog(folders)


def _tells_nothing_new(result: ScenarioResult, before: ScenarioResult) -> bool:
    """Whether a scenario could not begin for the reason that its variation before has told."""
    return (
        result.file == before.file and not result.ran_dialect and result.failures == before.failures
    )
