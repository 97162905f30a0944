"""From PLC text to the checked program.

Apart from `harness.engine.loading`, because a program that is already there needs none of the
parser and the checker, and they take longer to import than a small plant to run.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.lang import ast
from fbgen.lang.checked import Program
from fbgen.lang.checker import check, check_reporting
from fbgen.lang.containers import XML_SUFFIXES, read_document, read_text
from fbgen.lang.tag_files import global_file
from fbgen.lang.tags import ConstantValue, Tag
from fbgen.source import Source


def read_program(
    sources: Iterable[str | Path | Source],
    dialect: str = "tia",
    db_numbers: Mapping[str, int] = MappingProxyType({}),
    constants: Mapping[str, ConstantValue] = MappingProxyType({}),
    tags: Iterable[str | Path | Source | Tag] = (),
    *,
    stubbed: Collection[str] = (),
) -> Program:
    """The checked program that the files or texts make up; raises all errors together.

    `stubbed` are the names of blocks that a stub stands for.
    """
    files: list[ast.File] = []
    found: list[Diagnostic] = []
    if isinstance(sources, str | Path | Source):
        sources = (sources,)
    for source in sources:
        try:
            file, findings = _tree(source, dialect)
        except DiagnosticError as failure:
            found.extend(failure.diagnostics)
        else:
            files.append(file)
            found += [one for one in findings if one.severity is Severity.ERROR]
    try:
        files.append(global_file(dialect, constants, tags))
    except DiagnosticError as failure:
        raise DiagnosticError([*found, *failure.diagnostics]) from None
    if found:
        _, more = check_reporting(
            files, dialect, db_numbers=db_numbers, stubbed=stubbed, unread=found
        )
        raise DiagnosticError([*found, *(one for one in more if one.severity is Severity.ERROR)])
    return check(files, dialect, db_numbers=db_numbers, stubbed=stubbed)


def _tree(source: str | Path | Source, dialect: str) -> tuple[ast.File, Sequence[Diagnostic]]:
    if isinstance(source, Source):
        is_xml = Path(source.name).suffix.lower() in XML_SUFFIXES
        document = read_text(source, dialect, is_xml)
    else:
        document = read_document(Path(source), dialect)
    return document.file, document.findings
