"""What the fixtures give: programs, and plants that run."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

import pytest

from fbgen.source import Source
from harness.engine.loading import PROBED, LoadedProgram, load_program
from harness.installation import DriveConditions, Installation, PlantSetup
from harness.installation import plant as installation
from harness.pytest_plugin import PLANT, SEED
from harness.pytest_plugin.coverage import coverage_of
from harness.pytest_plugin.naming import near
from harness.verify.coverage import Coverage, watch

Thing = TypeVar("Thing")
_SETTINGS = ("plant", "seed", "engine", "drives", "sources")


def loader(request: pytest.FixtureRequest) -> Callable[..., LoadedProgram]:
    """`load_program` for files beside the test."""
    folder = request.path.parent

    coverage = coverage_of(request.config)

    def load(*sources: str | Path | Source, **settings: Any) -> LoadedProgram:
        found = [item if isinstance(item, Source) else near(folder / item) for item in sources]
        if coverage is not None and settings.get("engine", PROBED) == PROBED:
            settings["probes"] = [*settings.get("probes", ()), coverage]
        return load_program(found, **settings)

    return load


def started_plant(request: pytest.FixtureRequest) -> Installation:
    """The plant that marker, setting and command line ask for."""
    settings = _settings(request)
    path = _plant_file(request, settings.get("plant"))
    sources = settings.get("sources")
    folder = request.path.parent
    drives: Mapping[str, DriveConditions] = settings.get("drives", {})
    asked = request.config.getoption(SEED)
    seed: int = settings.get("seed", 0) if asked is None else asked
    engine: str = settings.get("engine", PROBED)
    coverage = _coverage_of_test(request) if engine == PROBED else None
    setup = PlantSetup(
        seed,
        engine,
        drives,
        sources=None if sources is None else [folder / item for item in sources],
        probes=() if coverage is None else (coverage,),
    )
    built = installation(path, setup)
    if coverage is not None:
        coverage.name_plant(built.plan.name)
        watch(built, coverage.catalogue)
    request.node.user_properties.append(("fbgen_seed", seed))
    built.start()
    return built


def _coverage_of_test(request: pytest.FixtureRequest) -> Coverage | None:
    """Collects for one plant; what it has counts for the session when the test is over."""
    session = coverage_of(request.config)
    if session is None:
        return None
    coverage = Coverage()
    request.addfinalizer(lambda: session.merge([coverage]))
    return coverage


def _settings(request: pytest.FixtureRequest) -> dict[str, Any]:
    """Those of all markers, the nearest one first."""
    found: dict[str, Any] = {}
    for mark in request.node.iter_markers("fbgen"):
        unknown = [name for name in mark.kwargs if name not in _SETTINGS]
        if mark.args or unknown:
            what = f"'{unknown[0]}'" if unknown else "values without names"
            known = ", ".join(_SETTINGS)
            raise pytest.UsageError(f"the marker fbgen does not take {what}; known: {known}")
        found = {**mark.kwargs, **found}
    return found


def _plant_file(request: pytest.FixtureRequest, marked: str | None) -> Path:
    if marked is not None:
        return request.path.parent / marked
    setting: str = request.config.getini(PLANT)
    if not setting:
        raise pytest.UsageError(
            "no plant is named: mark the test with @pytest.mark.fbgen(plant='plant.yaml'), "
            f"or write {PLANT} = plant.yaml into the settings of pytest"
        )
    return request.config.rootpath / setting


def only(things: Mapping[str, Thing], what: str) -> Thing:
    """The only one of its kind."""
    if len(things) != 1:
        names = ", ".join(f'plant.{what}s["{name}"]' for name in things)
        raise pytest.UsageError(f"the plant has several {what}s: take {names}")
    return next(iter(things.values()))
