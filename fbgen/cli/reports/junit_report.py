"""`fbgen test --junit FILE`: the results as JUnit XML."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

from fbgen.dataclass import dataclass

if TYPE_CHECKING:
    from fbgen.diagnostics import Diagnostic
    from harness.results import ScenarioReport
    from harness.scenario import ObserverMaker

JunitOption: TypeAlias = Annotated[
    Path | None,
    typer.Option("--junit", metavar="FILE", help="Write the results as JUnit XML, for CI servers."),
]


@dataclass(frozen=True, slots=True)
class JunitWriter:
    """Writes the file; nobody has to look on for it."""

    path: Path
    observers: "tuple[ObserverMaker, ...]" = ()

    def write(self, report: "ScenarioReport") -> "Sequence[Diagnostic]":
        """Write it over the last one. Raises DiagnosticError FB9002 if that cannot be done."""
        from fbgen.cli.files import write_file
        from harness.report.junit import junit_xml

        write_file(self.path, junit_xml(report), overwrite=True)
        return ()
