"""What all tests share: skips that may count as failures, golden files, behaviour rows.

`FBGEN_REQUIRE_ALL=1` turns each skip into a failure: the continuous integration sets it, because
there everything that a check needs is installed. A run ends with a list of what was skipped and
why. `--update-golden` writes golden files anew instead of comparing with them. The cache folder is
one that begins empty with each run: what is tested is made by this code, once for all processes.
Python's cycle collector looks less often, as it does in a command of fbgen: ten thousand collected
tests are alive until the end, and looking through them again and again took an eighth of a run.
Random examples have no time limit: how fast a machine is says nothing about what is right.
"""

import gc
import os
import shutil
import signal
import tempfile
from collections import Counter
from collections.abc import Callable, Generator, Iterator

import pytest
from hypothesis import HealthCheck, settings

from tests.fact_marks import FACTS

if "PYTEST_XDIST_WORKER" not in os.environ:
    os.environ["FBGEN_CACHE"] = tempfile.mkdtemp(prefix="fbgen-tests-")
_NEW_OBJECTS = 100_000
"""How many objects come into being before Python looks for garbage among them."""

settings.register_profile("fbgen", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("fbgen")

_REQUIRE_ALL = os.environ.get("FBGEN_REQUIRE_ALL") == "1"


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--update-golden",
        action="store_true",
        help="write the golden files anew instead of comparing with them",
    )


def pytest_unconfigure() -> None:
    if "PYTEST_XDIST_WORKER" not in os.environ:
        shutil.rmtree(os.environ["FBGEN_CACHE"], ignore_errors=True)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Nothing that is collected becomes garbage."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()
        gc.collect()
        gc.set_threshold(_NEW_OBJECTS)


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Note the behaviour rows before -k and -m take tests away."""
    config.stash[FACTS] = [
        (str(row), item.nodeid)
        for item in items
        if item.get_closest_marker("slow") is None
        for mark in item.iter_markers("fact")
        for row in mark.args
    ]


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item,
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    if _REQUIRE_ALL and report.skipped and not hasattr(report, "wasxfail"):
        report.outcome = "failed"
        report.longrepr = f"{item.nodeid} must not be skipped here: {_reason(report)}"
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    report = yield
    if _REQUIRE_ALL and report.skipped:
        report.outcome = "failed"
        report.longrepr = f"{collector.nodeid} must not be skipped here: {_reason(report)}"
    return report


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """The list of what was skipped, each reason once with the number of its tests."""
    skipped = terminalreporter.stats.get("skipped", [])
    reasons = Counter(_reason(report) for report in skipped)
    terminalreporter.section("skipped", sep="-")
    for reason, count in sorted(reasons.items()):
        terminalreporter.write_line(f"{count} x {reason}")
    if not reasons:
        terminalreporter.write_line("nothing was skipped")
    if terminalreporter.config.getoption("markexpr") == "not slow":
        terminalreporter.write_line("tests marked slow were left out: make sweep runs them")


def _reason(report: pytest.TestReport | pytest.CollectReport) -> str:
    longrepr = report.longrepr
    text = str(longrepr[2]) if isinstance(longrepr, tuple) else str(longrepr)
    return text.removeprefix("Skipped: ")


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> Callable[[str, str], None]:
    """`golden(name, text)`: the text must be that of tests/golden/NAME, byte for byte."""
    update = bool(request.config.getoption("--update-golden"))
    folder = request.config.rootpath / "tests" / "golden"

    def compare(name: str, text: str) -> None:
        path = folder / name
        if update:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text.encode())
            return
        assert path.is_file(), f"there is no tests/golden/{name}; pytest --update-golden writes it"
        assert text == path.read_bytes().decode()

    return compare


@pytest.fixture
def usual_ctrl_c() -> Iterator[None]:
    """Ctrl+C reaches the processes of a test, also where pytest runs in the background itself.

    A shell starts background jobs with SIGINT ignored, and children inherit that.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)
