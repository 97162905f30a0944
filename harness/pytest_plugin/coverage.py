"""Coverage of the PLC text that the tests of a pytest session run: `--fbgen-coverage`.

Each process collects what its scenarios and fixtures reach. Workers of pytest-xdist send theirs to
the process that has started them; there the table and the reports are made.
"""

import shutil
from collections.abc import Iterator, Mapping, Sequence

import pytest

from fbgen.columns import columns
from fbgen.diagnostics import DiagnosticError, render
from harness.pytest_plugin import COVERAGE, FAIL_UNDER
from harness.verify.coverage import (
    CATALOGUE_HEADINGS,
    HEADINGS,
    Coverage,
    as_text,
    catalogue_rows,
    from_text,
    parse_limits,
    parse_target,
    rows,
    too_little,
    write,
)

_SENT = "fbgen_coverage"
_COLLECTED = pytest.StashKey[Coverage]()


class CoverageSession:
    """Makes the reports of a session. It is there only if they are asked for."""

    def __init__(self, config: pytest.Config) -> None:
        """Raises UsageError for reports and limits that are none."""
        reports: Sequence[str] = config.getoption(COVERAGE) or ()
        limits: str = config.getoption(FAIL_UNDER)
        try:
            self._targets = [parse_target(one) for one in reports if one != "table"]
            self._limits: Mapping[str, float] = parse_limits(limits) if limits else {}
        except DiagnosticError as wrong:
            raise pytest.UsageError("\n".join(map(render, wrong.diagnostics))) from None
        self._wrong: list[str] = []
        self._coverage = config.stash[_COLLECTED] = Coverage()

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: object) -> None:
        """A worker of pytest-xdist has ended; one that has crashed sends nothing."""
        sent: Mapping[str, str] = getattr(node, "workeroutput", {})
        if _SENT in sent:
            self._coverage.merge([from_text(sent[_SENT])])

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        """Send what was collected, or write the reports; too little fails the session."""
        output: dict[str, str] | None = getattr(session.config, "workeroutput", None)
        if output is not None:
            output[_SENT] = as_text(self._coverage)
            return
        self._wrong = [*self._written(), *map(render, too_little(self._coverage, self._limits))]
        if self._wrong and session.exitstatus == pytest.ExitCode.OK:
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    def _written(self) -> Iterator[str]:
        for target in self._targets:
            try:
                write(self._coverage, target)
            except OSError as wrong:
                place = target.path.as_posix()
                yield f"the coverage cannot be written to {place}: {wrong.strerror}"

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        """The tables of `fbgen test --coverage`, and what is wrong."""
        width = shutil.get_terminal_size().columns if terminalreporter.isatty else 0
        terminalreporter.section("coverage of the PLC text")
        terminalreporter.write_line(columns(HEADINGS, rows(self._coverage), width))
        if exercised := catalogue_rows(self._coverage):
            text = columns(CATALOGUE_HEADINGS, exercised, width)
            terminalreporter.write_line(f"\n{text}")
        for line in self._wrong:
            terminalreporter.write_line(f"\n{line}", red=True)


def coverage_of(config: pytest.Config) -> Coverage | None:
    """Where this process collects; None if nobody has asked for coverage."""
    return config.stash.get(_COLLECTED, None)
