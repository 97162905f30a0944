"""`fbgen test --html FILE`: the results with timing diagrams, as one page for a browser."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

from fbgen.dataclass import dataclass

if TYPE_CHECKING:
    from fbgen.diagnostics import Diagnostic
    from harness.report.page import Table
    from harness.results import ScenarioReport
    from harness.scenario import ObserverMaker

HtmlOption: TypeAlias = Annotated[
    Path | None,
    typer.Option(
        "--html",
        metavar="FILE",
        help="Write the results with a timing diagram of each run, as one page for a browser.",
    ),
]


@dataclass(frozen=True, slots=True)
class HtmlWriter:
    """Writes the page; `asked` is what narrows the session, in words."""

    path: Path
    asked: tuple[str, ...] = ()

    @property
    def observers(self) -> Sequence["ObserverMaker"]:
        """Who records the runs."""
        from harness.scenario.tracing import TraceObserver

        return (TraceObserver,)

    def write(self, report: "ScenarioReport") -> "Sequence[Diagnostic]":
        """Write it over the last one. Raises DiagnosticError FB9002 if that cannot be done."""
        from fbgen.cli.files import write_file
        from harness.report.page import html_report

        page = html_report(report, self.asked, list(_coverage(report)))
        write_file(self.path, page, overwrite=True)
        return ()


def _coverage(report: "ScenarioReport") -> "Iterator[Table]":
    """The tables of `--coverage`, if it was asked for too."""
    from harness.report.page import Table
    from harness.verify.coverage import (
        CATALOGUE_HEADINGS,
        HEADINGS,
        Coverage,
        catalogue_rows,
        rows,
    )
    from harness.verify.coverage.observing import coverage_of

    if any(result.observed(Coverage) is not None for result in report.results):
        coverage = coverage_of(report)
        yield Table("Coverage", HEADINGS, rows(coverage))
        if exercised := catalogue_rows(coverage):
            yield Table("Coverage of the catalogue", CATALOGUE_HEADINGS, exercised)


def asked_for(
    seed: int | None, select: str, dialect: str | None, temporaries: str | None
) -> tuple[str, ...]:
    """What narrows or changes the session, as the report says it."""
    said = [
        f"seed {seed} for all" if seed is not None else "",
        f"dialect {dialect} for all" if dialect is not None else "",
        f"temporaries {temporaries} for all" if temporaries is not None else "",
        f"only {select}" if select else "",
    ]
    return tuple(text for text in said if text)
