"""Whether converted text is right in its dialect: read and checked as somebody else's would be.

A mistake in it is shown where it came from in the text that was converted.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.lang.ast import File, Globals
from fbgen.lang.checker import check_reporting
from fbgen.lang.containers.document import document_of
from fbgen.lang.containers.twincat import with_list_names
from fbgen.lang.parser import parse_recovering
from fbgen.lang.printer import PrintedText, print_file
from fbgen.source import Source, Span


def mistakes_in(files: Sequence[File], dialect: str) -> list[Diagnostic]:
    """FB3055 for each error in the text of these trees, which make up one program."""
    printed = {f"converted {number}": print_file(file) for number, file in enumerate(files)}
    again: list[File] = []
    found: list[Diagnostic] = []
    for name, text in printed.items():
        tree, findings = parse_recovering(Source(name, text.text), dialect)
        again.append(tree)
        found += errors_among(findings)
    if not found:
        named = [
            with_list_names(tree, [one.name for one in file.units if isinstance(one, Globals)])
            for tree, file in zip(again, files, strict=True)
        ]
        found = errors_among(check_reporting(named, dialect)[1])
    return [_mistake(one, printed, dialect) for one in found]


def mistakes_in_files(contents: Mapping[Path, bytes], dialect: str) -> list[Diagnostic]:
    """As `mistakes_in`, for files as they will be written; places are lines of these files."""
    documents = [document_of(path, data, dialect) for path, data in contents.items()]
    found = [one for document in documents for one in errors_among(document.findings)]
    if not found:
        files = [document.file for document in documents]
        found = errors_among(check_reporting(files, dialect)[1])
    return [
        replace(_mistake(one, {}, dialect), notes=(Note("in what would be written", one.span),))
        for one in found
    ]


def errors_among(findings: Sequence[Diagnostic]) -> list[Diagnostic]:
    """The findings that stop the work."""
    return [one for one in findings if one.severity is Severity.ERROR]


def _mistake(found: Diagnostic, printed: Mapping[str, PrintedText], dialect: str) -> Diagnostic:
    place: Span | None = None
    notes: tuple[Note, ...] = ()
    if found.span is not None and found.span.source.name in printed:
        line = found.span.line
        places = printed[found.span.source.name].places[:line]
        place = next((one for one in reversed(places) if one is not None), None)
        notes = (Note(f"converted: {found.span.source.line_text(line).strip()}"),)
    return Diagnostic(
        "FB3055",
        f"what this becomes is not right in dialect {dialect}: {found.message} [{found.code}]",
        place,
        "write it in another way; fbgen convert --no-check gives the text as it is",
        notes,
    )
