"""pytest with simulated plants: fixtures, and scenario files as tests.

pytest imports this in every project where fbgen is installed, so everything that costs is imported
in the fixtures and when a scenario file is there. The reference is
`docs/reference/pytest-plugin.md`.
"""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from harness.drives import Inverter
    from harness.engine.loading import LoadedProgram
    from harness.installation import Installation
    from harness.line import Line
    from harness.pytest_plugin.injected_faults import InjectedFaults

SEED = "--fbgen-seed"
COVERAGE = "--fbgen-coverage"
FAIL_UNDER = "--fbgen-coverage-fail-under"
PLANT = "fbgen_plant"
_SUFFIX = ".scenario.yaml"


def pytest_addoption(parser: pytest.Parser) -> None:
    """The options and the setting."""
    group = parser.getgroup("fbgen", "simulated plants")
    group.addoption(
        SEED,
        type=int,
        metavar="N",
        help="this seed for scenarios and plants, instead of their own",
    )
    group.addoption(
        COVERAGE,
        action="append",
        metavar="REPORT",
        help="what the tests reach of the PLC text: a file .html, .xml (Cobertura), .info (LCOV) "
        "or .json, a folder/ for all of them, or table; may be given several times",
    )
    group.addoption(
        FAIL_UNDER,
        default="",
        metavar="LIMITS",
        help="fail with less coverage, such as statement=90,branch=80,mcdc=70,catalogue=60",
    )
    parser.addini(PLANT, "plant file of the fixture plant, as seen from the root folder")


def pytest_configure(config: pytest.Config) -> None:
    """The marker; and who collects coverage, if it is asked for."""
    config.addinivalue_line(
        "markers",
        "fbgen(plant=None, seed=0, engine='compiled', drives={}, sources=None): the plant of the "
        "fixtures; the file is named as seen from the folder of the test",
    )
    if config.getoption(COVERAGE) or config.getoption(FAIL_UNDER):
        from harness.pytest_plugin.coverage import CoverageSession  # noqa: PLC0415 - where asked for

        config.pluginmanager.register(CoverageSession(config), "fbgen coverage")


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Scenario files are tests."""
    if not file_path.name.endswith(_SUFFIX):
        return None
    from harness.pytest_plugin.scenarios import ScenarioFile  # noqa: PLC0415 - only where needed

    return ScenarioFile.from_parent(parent, path=file_path)


@pytest.fixture
def plc(request: pytest.FixtureRequest) -> "Callable[..., LoadedProgram]":
    """Loads PLC text: `plc("tank.scl", dialect="tia")`.

    Files are named as seen from the folder of the test; the other arguments are those of
    `harness.load_program`.
    """
    from harness.pytest_plugin.fixtures import loader  # noqa: PLC0415 - only where needed

    return loader(request)


@pytest.fixture
def plant(request: pytest.FixtureRequest) -> "Installation":
    """The simulated plant of the marker `fbgen` or of the setting `fbgen_plant`, switched on."""
    from harness.pytest_plugin.fixtures import started_plant  # noqa: PLC0415 - only where needed

    return started_plant(request)


@pytest.fixture
def line(plant: "Installation") -> "Line":
    """The RS-485 line of the plant; of several, take `plant.lines["gw1"]`."""
    from harness.pytest_plugin.fixtures import only  # noqa: PLC0415 - only where needed

    return only(plant.lines, "line")


@pytest.fixture
def drive(plant: "Installation") -> "Inverter":
    """The inverter of the plant; of several, take `plant.drives["pump"]`."""
    from harness.pytest_plugin.fixtures import only  # noqa: PLC0415 - only where needed

    return only(plant.drives, "drive")


@pytest.fixture
def faults(plant: "Installation") -> "InjectedFaults":
    """Faults of the plant: `faults.inject("line_noise", on="gw1", bit_error_rate=0.1)`."""
    from harness.pytest_plugin.injected_faults import InjectedFaults  # noqa: PLC0415 - only where needed

    return InjectedFaults(plant)
