"""`fbgen convert`: PLC text in another dialect, or in another kind of file."""

from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.dialects import DialectOption
from fbgen.cli.examples import examples
from fbgen.cli.output import counted, on_error_terminal, result, result_bytes, say

if TYPE_CHECKING:
    from collections.abc import Sequence

    from fbgen.cli.progress import Progress
    from fbgen.diagnostics import Diagnostic
    from fbgen.lang.ast import File


class Target(Enum):
    """A dialect, or the container of PLCopen with dialect iec in it."""

    TIA = "tia"
    STEP7 = "step7"
    IEC = "iec"
    TWINCAT = "twincat"
    PLCOPEN = "plcopen"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen convert pump.scl --to iec",
            "fbgen convert blocks --to step7 -o classic",
            "fbgen convert pump.scl valve.scl --to plcopen -o plant.xml",
            'fbgen convert "lib/*.st" --dialect twincat --to tia -o tia',
            "fbgen convert blocks --to twincat -o project --text",
        )
    )(convert)


def convert(
    files: Annotated[
        list[Path],
        typer.Argument(metavar="FILES", help="Files, patterns or folders: one program."),
    ],
    to: Annotated[
        Target, typer.Option("--to", help="A dialect; plcopen is dialect iec in XML (PLCopen TC6).")
    ],
    output: Annotated[
        Path | None,
        typer.Option(
            "-o",
            "--output",
            metavar="FILE|DIR",
            help="Where it goes; a name without suffix is a folder. Else to standard output.",
        ),
    ] = None,
    dialect: DialectOption = None,
    text: Annotated[
        bool, typer.Option("--text", help="For twincat in a folder: .st in the place of XML.")
    ] = False,
    check: Annotated[
        bool,
        typer.Option("--check/--no-check", help="Whether names and types must be right as well."),
    ] = True,
    force: Annotated[
        bool, typer.Option("--force", help="Overwrite files that are there with other content.")
    ] = False,
) -> None:
    """Convert PLC text to another dialect.

    All files together are one program of one dialect. What the other dialect cannot say is refused
    by name, everything at once, and nothing is written. What came out is read and checked again in
    its own dialect. Comments and layout are kept.
    """
    from fbgen.cli.files import write_files
    from fbgen.cli.sources.converted_files import Destination, encoded_files
    from fbgen.cli.sources.plc_files import dialect_of, expand
    from fbgen.lang.conversion_proof import mistakes_in_files

    paths = expand(files)
    source = dialect or dialect_of(paths)
    destination = Destination(to.value, output, text)
    trees = _converted(paths, source, destination.dialect, check=check)
    if destination.container == "text":
        trees = _without_names_of_lists(trees, destination.dialect)
    contents = encoded_files(trees, destination, len(paths))
    if check and destination.container != "text":
        _raise_any(mistakes_in_files(contents, destination.dialect))
    if output is None:
        for data in contents.values():
            result_bytes(data)
        return
    write_files(contents, overwrite=force)
    for path in contents:
        result(str(path))
    are = "is" if len(paths) == 1 else "are"
    say(
        f"{counted(len(paths), 'file')} of dialect {source} {are} now {len(contents)} of {to.value}"
    )


def _converted(
    paths: "Sequence[Path]", source: str, target: str, *, check: bool
) -> "Sequence[File]":
    """The trees in the other dialect. Raises DiagnosticError with all that is in the way."""
    from fbgen.cli.progress import Progress
    from fbgen.lang.checker import check_reporting
    from fbgen.lang.conversion import convert as convert_trees
    from fbgen.lang.conversion_proof import errors_among, mistakes_in

    progress = Progress(len(paths) + 3, shown=on_error_terminal())
    try:
        trees = _read(paths, source, progress)
        if check:
            progress.step("names and types")
            _raise_any(errors_among(check_reporting(trees, source)[1]))
        progress.step(f"conversion to {target}")
        converted = convert_trees(trees, target)
        if check:
            progress.step("what came out")
            _raise_any(mistakes_in(converted, target))
    finally:
        progress.end()
    return converted


def _without_names_of_lists(trees: "Sequence[File]", dialect: str) -> "Sequence[File]":
    from fbgen.lang.conversion.list_names import without_list_names
    from fbgen.lang.lowering.findings import Findings

    findings = Findings(dialect)
    written = without_list_names(trees, findings)
    _raise_any(findings.all)
    return written


def _read(paths: "Sequence[Path]", dialect: str, progress: "Progress") -> "list[File]":
    from fbgen.diagnostics import DiagnosticError
    from fbgen.lang.containers import read_document
    from fbgen.lang.conversion_proof import errors_among

    trees: list[File] = []
    found: list[Diagnostic] = []
    for path in paths:
        progress.step(str(path))
        try:
            document = read_document(path, dialect)
        except DiagnosticError as unreadable:
            found += unreadable.diagnostics
        else:
            trees.append(document.file)
            found += errors_among(document.findings)
    _raise_any(found)
    return trees


def _raise_any(found: "Sequence[Diagnostic]") -> None:
    from fbgen.diagnostics import DiagnosticError

    if found:
        raise DiagnosticError(found)
