"""`fbgen check`: finds mistakes in PLC text, generated or written by hand."""

from collections.abc import Iterable, Sequence
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.dialects import DialectOption
from fbgen.cli.examples import examples
from fbgen.cli.output import report, result_json, say

if TYPE_CHECKING:
    from fbgen.diagnostics import Diagnostic


class Format(Enum):
    """How findings are printed: for a person on standard error, or as JSON on standard output."""

    TEXT = "text"
    JSON = "json"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen check out",
            "fbgen check pump.scl valve.scl",
            "fbgen check pump.st --dialect iec --syntax-only",
            "fbgen check out --format json",
        )
    )(check)


def check(
    files: Annotated[
        list[Path],
        typer.Argument(metavar="FILES", help="Files, or folders with .scl, .udt, .db, .st, .Tc*."),
    ],
    dialect: DialectOption = None,
    syntax_only: Annotated[
        bool, typer.Option("--syntax-only", help="Do not look at names and types.")
    ] = False,
    output: Annotated[
        Format, typer.Option("--format", help="text for a person, json for a program.")
    ] = Format.TEXT,
) -> None:
    """Check PLC text: syntax, names, types. All files are one program.

    Without --dialect the file names decide: .scl, .udt and .db are tia, .st and .xml (PLCopen) are
    iec, .TcPOU and the like are twincat. Exit status 1 if there is an error; warnings alone are
    status 0.
    """
    from fbgen.diagnostics import Severity

    paths = _expand(files)
    chosen = dialect or dialect_of(paths)
    findings = _findings(paths, chosen, syntax_only)
    errors = sum(finding.severity is Severity.ERROR for finding in findings)
    if output is Format.JSON:
        result_json(
            {
                "dialect": chosen,
                "files": [str(path) for path in paths],
                "diagnostics": [finding.as_json() for finding in findings],
            }
        )
    else:
        report(findings)
        others = len(findings) - errors
        say(f"files: {len(paths)}, dialect: {chosen}, errors: {errors}, other findings: {others}")
    if errors:
        raise typer.Exit(FINDINGS)


def _expand(files: Iterable[Path]) -> list[Path]:
    """Every file once, folders replaced by the PLC texts directly in them."""
    from fbgen.lang.containers import SUFFIXES

    plain = SUFFIXES.keys() - {".xml"}
    found: dict[Path, None] = {}
    for path in files:
        if path.is_dir():
            texts = sorted(item for item in path.iterdir() if item.suffix.lower() in plain)
            if not texts:
                raise typer.BadParameter(f"there is no file with PLC text in {path}")
            found.update(dict.fromkeys(texts))
        else:
            found[path] = None
    return list(found)


def dialect_of(paths: Sequence[Path]) -> str:
    """The dialect that the names of these files stand for; wrong usage if they do not tell."""
    from fbgen.lang.containers import SUFFIXES

    dialects = {SUFFIXES.get(path.suffix.lower()) for path in paths}
    if len(dialects) == 1 and (dialect := dialects.pop()) is not None:
        return dialect
    raise typer.BadParameter("the file names do not tell the dialect: add --dialect")


def _findings(paths: Sequence[Path], dialect: str, syntax_only: bool) -> list["Diagnostic"]:
    """Everything that is wrong, in the order of the files and their lines."""
    from fbgen.diagnostics import DiagnosticError
    from fbgen.lang.checker import check_reporting
    from fbgen.lang.containers import read_document

    trees = []
    found: list[Diagnostic] = []
    for path in paths:
        try:
            document = read_document(path, dialect)
        except DiagnosticError as unreadable:
            found += unreadable.diagnostics
        else:
            trees.append(document.file)
            found += document.findings
    if not found and not syntax_only:
        found += check_reporting(trees, dialect)[1]
    order = {str(path): index for index, path in enumerate(paths)}
    return sorted(
        found,
        key=lambda item: (
            (order.get(item.span.source.name, 0), item.span.line, item.span.column)
            if item.span
            else (-1, 0, 0)
        ),
    )
