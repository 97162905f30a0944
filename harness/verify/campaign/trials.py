"""One seed of a campaign: its scenario run, and what came of it. Works in any process.

A process keeps what is dear to make: the catalogue, plants and their checked programs.
"""

from dataclasses import replace
from functools import cache
from pathlib import Path

import yaml

from fbgen.catalog import Catalog, load_catalog, with_own_sequences
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.plant import load_plant
from harness.installation import PlantSetup, build_plant
from harness.scenario import SUFFIX, run_case, scenario_cases
from harness.scenario.cases import ScenarioCase, prepare
from harness.scenario.fault_plans import possible_places
from harness.scenario.model import Scenario, Variation
from harness.verify.campaign.configurations import variations
from harness.verify.campaign.drawing import Subject, draw
from harness.verify.campaign.entries import Entry, written_time

_AS_IT_IS = "as in the file"


@dataclass(frozen=True, slots=True)
class CampaignSettings:
    """What a campaign tries: plant files and scenario files, as absolute paths, with `kinds` of
    faults. A scenario file is run as it is, with its own faults drawn by each seed."""

    files: tuple[str, ...]
    kinds: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Failure:
    """A seed that failed. `kind` says what broke, without instants and values: failures of one
    kind are one. `message` is the first finding, `configuration` how the plant was changed."""

    seed: int
    file: str
    kind: str
    message: str
    configuration: str


@dataclass(frozen=True, slots=True)
class Chunk:
    """Some seeds that were tried: those from `first` up to and without `behind`, in these
    `configurations`."""

    first: int
    behind: int
    virtual_ns: int
    configurations: tuple[str, ...]
    failures: tuple[Failure, ...]


def try_seeds(settings: CampaignSettings, first: int, behind: int) -> Chunk:
    """Run all seeds of a chunk."""
    failures, configurations, virtual_ns = [], set(), 0
    for seed in range(first, behind):
        case = case_of(settings, seed)
        result = run_case(case, _catalog(), seed)
        virtual_ns += result.virtual_ns
        file = settings.files[seed % len(settings.files)]
        configuration = case.changes.strip("[]") or _AS_IT_IS
        configurations.add(f"{Path(file).name}: {configuration}")
        if not result.passed:
            found = result.failures[0]
            failures.append(Failure(seed, file, kind_of(found), found.message, configuration))
    return Chunk(first, behind, virtual_ns, tuple(sorted(configurations)), tuple(failures))


def case_of(settings: CampaignSettings, seed: int) -> ScenarioCase:
    """The scenario of a seed: files and their cases take turns."""
    path = Path(settings.files[seed % len(settings.files)])
    if path.name.endswith(SUFFIX):
        cases = _cases(path)
        return replace(cases[seed // len(settings.files) % len(cases)], seed=seed)
    return case_from(drawn(settings, seed), path)


def drawn(settings: CampaignSettings, seed: int) -> Entry:
    """What a seed does to its plant file, or its scenario with the faults as a list of events."""
    file = settings.files[seed % len(settings.files)]
    if file.endswith(SUFFIX):
        return _explicit(Path(file), case_of(settings, seed), seed)
    return draw(seed, seed // len(settings.files), subject_of(file), settings.kinds)


def case_from(entry: Entry, path: Path) -> ScenarioCase:
    """A scenario in plain data; `path` is where its file lies or will lie."""
    scenario = Scenario.model_validate(entry)
    return ScenarioCase(path, scenario, (*scenario.variations, Variation())[0], seed=scenario.seed)


def outcome(entry: Entry, path: Path) -> Diagnostic | None:
    """What breaks first when a scenario runs; None if all is well."""
    case = case_from(entry, path)
    result = run_case(case, _catalog(), case.seed)
    return result.failures[0] if result.failures else None


def _explicit(path: Path, case: ScenarioCase, seed: int) -> Entry:
    """A scenario file as it is written, but for the seed and the faults that are drawn from it."""
    entry: Entry = yaml.safe_load(path.read_text(encoding="utf-8"))
    entry["seed"] = seed
    if case.scenario.plant is not None:
        entry["plant"] = (path.parent / case.scenario.plant).resolve().as_posix()
    if "variations" in entry:
        at = list(case.scenario.variations).index(case.variation)
        entry["variations"] = [entry["variations"][at]]
    if any("random" in fault for fault in entry.get("faults", ())):
        entry["faults"] = [
            {
                "at": written_time(event.at_ns),
                **({} if event.lasts_ns is None else {"lasts": written_time(event.lasts_ns)}),
                "inject": event.name,
                **({"on": event.on} if event.on else {}),
                **({"settings": dict(event.settings)} if event.settings else {}),
            }
            for event in prepare(case, _catalog(), seed).faults
        ]
    return entry


def kind_of(found: Diagnostic) -> str:
    """The code of a finding and what it is about: a rule, or a path."""
    quoted = found.message.split("'")
    about = quoted[1] if found.code == "FB8070" and len(quoted) > 1 else found.message.split(" ")[0]
    return f"{found.code} {about}"


@cache
def _catalog() -> Catalog:
    return load_catalog()


@cache
def _cases(path: Path) -> tuple[ScenarioCase, ...]:
    return scenario_cases(path)


@cache
def subject_of(file: str) -> Subject:
    """The plant of a file. Raises DiagnosticError for what is wrong in it."""
    catalog = with_own_sequences(_catalog(), Path(file).parent)
    plan = load_plant(Path(file), catalog)
    places = possible_places(build_plant(plan, catalog, PlantSetup()))
    return Subject(file, plan, catalog, variations(plan, catalog), places)
