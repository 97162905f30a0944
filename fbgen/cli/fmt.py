"""`fbgen fmt`: PLC text in its canonical layout."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli import FINDINGS
from fbgen.cli.dialects import DialectOption
from fbgen.cli.examples import examples
from fbgen.cli.output import on_error_terminal, report, result, result_bytes, say

if TYPE_CHECKING:
    from collections.abc import Iterator

    from fbgen.lang.formatting import Formatted


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen fmt blocks",
            "fbgen fmt pump.scl --diff",
            'fbgen fmt "blocks/**/*.scl" --check',
            "fbgen fmt classic.scl --dialect step7 --stdout",
        )
    )(fmt)


def fmt(
    files: Annotated[
        list[Path],
        typer.Argument(
            metavar="FILES",
            help="Files, patterns, or folders with .scl, .udt, .db, .st or .Tc* in them.",
        ),
    ],
    check: Annotated[
        bool,
        typer.Option("--check", help="Write nothing; exit status 1 if a file would change."),
    ] = False,
    diff: Annotated[
        bool, typer.Option("--diff", help="Write nothing; print what would change.")
    ] = False,
    stdout: Annotated[
        bool, typer.Option("--stdout", help="Print the formatted text of one file instead.")
    ] = False,
    dialect: DialectOption = None,
    jobs: Annotated[int, typer.Option("--jobs", min=1, help="Processes that share the files.")] = 1,
) -> None:
    """Bring PLC text into its canonical layout.

    Standard output lists the files that were changed. Comments and blank lines stay, and so do
    encoding, BOM and line ends; in XML only the code changes. A file with errors is reported and
    left alone. Without --dialect the file names decide, as for fbgen check.
    """
    from fbgen.cli.sources.plc_files import expand

    paths = expand(files)
    if stdout and (check or diff or len(paths) != 1):
        raise typer.BadParameter("--stdout takes one file, and neither --check nor --diff")
    counts = {"changed": 0, "unchanged": 0, "failed": 0}
    write = not (check or diff or stdout)
    for one in _formatted(paths, dialect, jobs):
        outcome = _outcome(one, write=write)
        counts[outcome] += 1
        if stdout and outcome != "failed":
            result_bytes(one.after)
        elif outcome == "changed":
            _print_difference(one) if diff else result(str(one.path))
    if not stdout:
        say(_summary(**counts, write=write))
    if counts["failed"] or (check and counts["changed"]):
        raise typer.Exit(FINDINGS)


def _formatted(paths: list[Path], dialect: str | None, jobs: int) -> "Iterator[Formatted]":
    """Each file in its turn; what cannot be formatted comes with the reason."""
    from functools import partial

    from fbgen.cli.progress import Progress
    from fbgen.cli.sources.plc_files import programs_of
    from fbgen.lang.formatting import format_or_findings
    from fbgen.workers import in_order

    programs_of(paths, dialect)
    progress = Progress(len(paths), shown=on_error_terminal())
    for one in in_order(partial(format_or_findings, dialect), paths, jobs):
        progress.end()
        yield one
        progress.step(str(one.path))
    progress.end()


def _outcome(one: "Formatted", *, write: bool) -> str:
    """What becomes of a file: changed, unchanged or failed. Its findings are reported."""
    from fbgen.cli.files import rewrite_file
    from fbgen.diagnostics import DiagnosticError

    report(one.findings)
    if one.is_broken:
        return "failed"
    if one.after == one.before:
        return "unchanged"
    if write:
        try:
            rewrite_file(one.path, one.after)
        except DiagnosticError as refused:
            report(refused.diagnostics)
            return "failed"
    return "changed"


def _print_difference(one: "Formatted") -> None:
    from difflib import unified_diff
    from io import StringIO

    from fbgen.lang.encoding import decode

    name = str(one.path)
    before, after = (
        StringIO(decode(data, name), newline="\n").readlines() for data in (one.before, one.after)
    )
    for line in unified_diff(before, after, name, name):
        result(line.rstrip("\r\n"))
        if not line.endswith("\n"):
            result("\\ No newline at end of file")


def _summary(changed: int, unchanged: int, failed: int, *, write: bool) -> str:
    text = f"{changed} {'changed' if write else 'would change'}, {unchanged} unchanged"
    return f"{text}, {failed} with errors left alone" if failed else text
