"""`fbgen coverage`: puts together what several runs of the tests have reached."""

from pathlib import Path
from typing import Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.examples import examples
from fbgen.cli.layers import JsonOption
from fbgen.cli.output import report, result_json
from fbgen.cli.reports.coverage_report import CoverageReports, FailUnderOption


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        "coverage",
        epilog=examples(
            "fbgen coverage coverage.json",
            "fbgen coverage linux.json windows.json --report coverage.html",
            "fbgen coverage runs/*.json --report site/ --fail-under statement=90,branch=80",
        ),
    )(put_together)


def put_together(
    files: Annotated[
        list[Path],
        typer.Argument(metavar="FILES", help="Files of fbgen test --coverage FILE.json."),
    ],
    reports: Annotated[
        list[str] | None,
        typer.Option(
            "--report",
            metavar="REPORT",
            help="A file .html, .xml (Cobertura), .info (LCOV) or .json, or a folder/ for all of "
            "them; may be given several times.",
        ),
    ] = None,
    limits: FailUnderOption = "",
    as_json: JsonOption = False,
) -> None:
    """Put the coverage of several runs together: their counts are added.

    Prints the table and writes reports. Exit status 1 with less coverage than is demanded.
    """
    from fbgen.diagnostics import Diagnostic, DiagnosticError
    from harness.verify.coverage import Coverage, load, summary

    wanted = CoverageReports.asked(reports or (), limits, prints=not as_json)
    coverage = Coverage()
    wrong: list[Diagnostic] = []
    for file in files:
        try:
            coverage.merge([load(file)])
        except DiagnosticError as problem:
            wrong += problem.diagnostics
    if wrong:
        raise DiagnosticError(wrong)
    findings = wanted.write(coverage)
    if as_json:
        result_json(summary(coverage))
    report(findings)
    if findings:
        raise typer.Exit(FINDINGS)
