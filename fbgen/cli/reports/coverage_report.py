"""Coverage on the command line: options of `fbgen test`, the table, reports, what is demanded."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

from fbgen.cli.files import write_files
from fbgen.cli.output import result
from fbgen.cli.table import table
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError

if TYPE_CHECKING:
    from harness.results import ScenarioReport
    from harness.scenario import ObserverMaker
    from harness.verify.coverage import Coverage, Target

CoverageOption: TypeAlias = Annotated[
    list[str] | None,
    typer.Option(
        "--coverage",
        metavar="REPORT",
        help="What the tests reach: a file .html, .xml (Cobertura), .info (LCOV) or .json, a "
        "folder/ for all of them, or table; may be given several times.",
    ),
]
FailUnderOption: TypeAlias = Annotated[
    str,
    typer.Option(
        "--fail-under",
        metavar="LIMITS",
        help="Exit status 1 with less coverage, such as statement=90,branch=80,mcdc=70,"
        "catalogue=60.",
    ),
]


@dataclass(frozen=True, slots=True)
class CoverageReports:
    """What is asked for. The table is printed if `prints`."""

    targets: "Sequence[Target]"
    limits: Mapping[str, float]
    prints: bool

    @classmethod
    def asked(cls, reports: Sequence[str], limits: str, *, prints: bool) -> "CoverageReports":
        """From the options. Raises DiagnosticError FB8051, FB8053."""
        from harness.verify.coverage import parse_limits, parse_target

        targets = [parse_target(one) for one in reports if one != "table"]
        return cls(targets, parse_limits(limits) if limits else {}, prints)

    def write(self, coverage: "Coverage") -> Sequence[Diagnostic]:
        """The table and the reports; what could not be written, and what is too little."""
        from harness.verify.coverage import (
            CATALOGUE_HEADINGS,
            HEADINGS,
            catalogue_rows,
            rows,
            too_little,
        )

        if self.prints:
            result("\n" + table(HEADINGS, rows(coverage)))
            if exercised := catalogue_rows(coverage):
                result("\n" + table(CATALOGUE_HEADINGS, exercised))
        return [*self._files(coverage), *too_little(coverage, self.limits)]

    def _files(self, coverage: "Coverage") -> Iterator[Diagnostic]:
        from harness.verify.coverage import contents

        for target in self.targets:
            try:
                write_files(contents(coverage, target), overwrite=True)
            except DiagnosticError as wrong:
                yield from wrong.diagnostics


@dataclass(frozen=True, slots=True)
class CoverageWriter:
    """The coverage of a session of `fbgen test`."""

    reports: CoverageReports

    @property
    def observers(self) -> "tuple[ObserverMaker, ...]":
        """Who collects it."""
        from harness.verify.coverage.observing import CoverageObserver

        return (CoverageObserver,)

    def write(self, report: "ScenarioReport") -> Sequence[Diagnostic]:
        """Everything that is asked for."""
        from harness.verify.coverage.observing import coverage_of

        return self.reports.write(coverage_of(report))


def coverage_writer(
    reports: Sequence[str] | None, limits: str, *, prints: bool
) -> CoverageWriter | None:
    """The writer that the options ask for, if they do. Raises DiagnosticError FB8051, FB8053."""
    if not reports and not limits:
        return None
    return CoverageWriter(CoverageReports.asked(reports or (), limits, prints=prints))
