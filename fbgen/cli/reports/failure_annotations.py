"""`fbgen test --annotations HOST`: failures at their lines, where a code host shows them."""

from collections.abc import Sequence
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypeAlias

import typer

from fbgen.dataclass import dataclass

if TYPE_CHECKING:
    from fbgen.diagnostics import Diagnostic
    from harness.results import ScenarioReport
    from harness.scenario import ObserverMaker

GITLAB_FILE = "gl-code-quality-report.json"
"""The file's name in GitLab's documentation."""


class CodeHost(Enum):
    """Who shows the failures."""

    GITHUB = "github"
    GITLAB = "gitlab"


AnnotationsOption: TypeAlias = Annotated[
    CodeHost | None,
    typer.Option(
        "--annotations",
        help=f"github: log lines that mark failures in the changes; gitlab: {GITLAB_FILE}.",
    ),
]


@dataclass(frozen=True, slots=True)
class AnnotationWriter:
    """Prints lines for GitHub, writes the file for GitLab; nobody has to look on for it."""

    host: CodeHost
    observers: "tuple[ObserverMaker, ...]" = ()

    def write(self, report: "ScenarioReport") -> "Sequence[Diagnostic]":
        """Print or write it. FB9002 if the file cannot be written."""
        import json

        from fbgen.cli.files import write_file
        from fbgen.cli.output import result
        from fbgen.cli.reports.annotations import github_lines, gitlab_report
        from harness.report.findings import findings_of

        findings = list(findings_of(report))
        if self.host is CodeHost.GITLAB:
            text = json.dumps(gitlab_report(findings), indent=2) + "\n"
            write_file(Path(GITLAB_FILE), text, overwrite=True)
            return ()
        for line in github_lines(findings):
            result(line)
        return ()
