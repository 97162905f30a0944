"""`fbgen check`: finds mistakes in PLC text, generated or written by hand."""

from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.dialects import DialectOption
from fbgen.cli.examples import examples
from fbgen.cli.output import on_error_terminal, report, result, result_json, say
from fbgen.cli.sources.project_data import (
    ConstantsOption,
    NumbersOption,
    TagsOption,
    read_constants,
    read_numbers,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from fbgen.cli.sources.plc_files import ProgramFiles
    from fbgen.diagnostics import Diagnostic


class Format(Enum):
    """How findings are printed: `text` on standard error, the others on standard output."""

    TEXT = "text"
    JSON = "json"
    SARIF = "sarif"
    GITHUB = "github"
    GITLAB = "gitlab"


class Lowest(Enum):
    """The findings to show: these and all that are worse."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"


class Switch(Enum):
    """A setting of the compiler."""

    ON = "on"
    OFF = "off"


class Family(Enum):
    """A CPU family."""

    S7_300 = "s7-300"
    S7_400 = "s7-400"
    S7_1200 = "s7-1200"
    S7_1500 = "s7-1500"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen check out",
            "fbgen check pump.scl valve.scl --cpu s7-1200",
            'fbgen check "blocks/**/*.scl" --strict',
            "fbgen check pump.st --dialect iec --syntax-only",
            "fbgen check out --format sarif > fbgen.sarif",
            'fbgen check blocks --tags "PLC tags.xml" --constant MAX_PUMPS=8',
        )
    )(check)


def check(
    files: Annotated[
        list[Path],
        typer.Argument(
            metavar="FILES",
            help="Files, patterns, or folders with .scl, .udt, .db, .st or .Tc* in them.",
        ),
    ],
    dialect: DialectOption = None,
    syntax_only: Annotated[
        bool, typer.Option("--syntax-only", help="Do not look at names and types.")
    ] = False,
    cpu: Annotated[
        Family | None,
        typer.Option("--cpu", help="Refuse what this CPU family does not have."),
    ] = None,
    iec_check: Annotated[
        Switch | None,
        typer.Option(
            "--iec-check",
            help="The setting of TIA Portal. By default off for S7-300/400 and step7, on for"
            " S7-1200/1500; without --cpu what needs it off is a warning.",
        ),
    ] = None,
    lowest: Annotated[
        Lowest, typer.Option("--severity", help="Show these findings and worse ones.")
    ] = Lowest.WARNING,
    strict: Annotated[
        bool, typer.Option("--strict", help="Exit status 1 for warnings too.")
    ] = False,
    jobs: Annotated[
        int,
        typer.Option(
            "--jobs", min=1, help="Processes: one program each, or with --syntax-only some files."
        ),
    ] = 1,
    output: Annotated[
        Format,
        typer.Option(
            "--format", help="text for a person; json, sarif, github or gitlab for a program."
        ),
    ] = Format.TEXT,
    constants: ConstantsOption = None,
    tags: TagsOption = None,
    numbers: NumbersOption = None,
) -> None:
    """Check PLC text: syntax, names, types, likely mistakes.

    All files of one dialect are one program. Without --dialect the file names decide: .scl, .udt
    and .db are tia, .st and .xml (PLCopen) are iec, .TcPOU and the like are twincat; .st that only
    CODESYS and TwinCAT take, because of what they convert, is twincat too. Exit status 1
    if there is an error; warnings alone are status 0.
    """
    from fbgen.cli.progress import Progress
    from fbgen.cli.sources.checking import Settings, check_programs
    from fbgen.cli.sources.plc_files import expand, programs_of
    from fbgen.diagnostics import Severity
    from fbgen.lang.families import Cpu

    paths = expand(files)
    programs = programs_of(paths, dialect)
    settings = Settings(
        syntax_only=syntax_only,
        iec_check=None if iec_check is None else iec_check is Switch.ON,
        cpu=None if cpu is None else Cpu(cpu.value),
        constants=read_constants(constants),
        tags=tuple(tags or ()),
        db_numbers=read_numbers(numbers),
    )
    progress = Progress(len(paths) + len(programs), shown=on_error_terminal())
    programs, found = check_programs(programs, settings, jobs, progress)
    ranks = (Severity.INFO, Severity.WARNING, Severity.ERROR)
    least = ranks.index(Severity(lowest.value))
    shown = [finding for finding in found if ranks.index(finding.severity) >= least]
    _print(shown, programs, output)
    failing = 1 if strict else 2
    if any(ranks.index(finding.severity) >= failing for finding in found):
        raise typer.Exit(FINDINGS)


def _print(
    findings: "Sequence[Diagnostic]", programs: "Sequence[ProgramFiles]", output: Format
) -> None:
    from fbgen.cli.reports.annotations import github_lines, gitlab_report
    from fbgen.cli.reports.check_report import report_of
    from fbgen.cli.reports.sarif import sarif_of

    if output is Format.JSON:
        result_json(report_of(programs, findings))
    elif output is Format.SARIF:
        result_json(sarif_of(findings))
    elif output is Format.GITLAB:
        result_json(gitlab_report(findings))
    elif output is Format.GITHUB:
        for line in github_lines(findings):
            result(line)
    else:
        report(findings)
        say(_summary(findings, programs))


def _summary(findings: "Sequence[Diagnostic]", programs: "Sequence[ProgramFiles]") -> str:
    from fbgen.diagnostics import Severity

    severities = [finding.severity for finding in findings]
    files = sum(len(program.paths) for program in programs)
    dialects = ", ".join(program.dialect for program in programs)
    text = (
        f"files: {files}, dialect: {dialects}, errors: {severities.count(Severity.ERROR)}, "
        f"warnings: {severities.count(Severity.WARNING)}"
    )
    hints = severities.count(Severity.INFO)
    return f"{text}, hints: {hints}" if hints else text
