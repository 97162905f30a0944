"""Checks programs, each as a whole, in one process or several.

Names and types need all files of a program at once, and handing syntax trees from one process to
another takes longer than reading the text. So a program is checked in one process; several
programs, or files whose syntax alone is checked, are shared out.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import partial
from pathlib import Path

from fbgen.cli.progress import Progress
from fbgen.cli.sources.plc_files import ProgramFiles
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.lang import ast
from fbgen.lang.analysis.cpu import missing_on
from fbgen.lang.checker import check_reporting, rules_for
from fbgen.lang.checker.rules import Rules
from fbgen.lang.containers import read_document
from fbgen.lang.families import Cpu
from fbgen.lang.tag_files import global_file
from fbgen.lang.unread_parts import unread_parts
from fbgen.workers import in_order

_CONVERSIONS = frozenset({"FB4010", "FB4011", "FB4012", "FB4058"})
"""Errors that Structured Text can have because nobody has said that it is of CODESYS."""


@dataclass(frozen=True, slots=True)
class Checked:
    """A program, in the dialect that it turned out to have, and what is wrong with it."""

    program: ProgramFiles
    findings: list[Diagnostic]


_RESETS_ITSELF = "FB4225"
"""On an S7-300/400 Q changes in a call only, so a timer may reset itself."""
_STRANGER = "FB4062"
"""A number for a data block: each program says it that does not have the data block."""


@dataclass(frozen=True, slots=True)
class Settings:
    """How to check. `iec_check` None: as the CPU family has it, else as the dialect has it.

    `constants` are user constants by name, `tags` files with tag tables, `db_numbers` the numbers
    of data blocks by name: what the project has besides its sources.
    """

    syntax_only: bool = False
    iec_check: bool | None = None
    cpu: Cpu | None = None
    constants: Mapping[str, str] = field(default_factory=dict)
    tags: tuple[str, ...] = ()
    db_numbers: Mapping[str, int] = field(default_factory=dict)


def check_programs(
    programs: Sequence[ProgramFiles], settings: Settings, jobs: int, progress: Progress
) -> tuple[list[ProgramFiles], list[Diagnostic]]:
    """The programs in their dialects, and everything that is wrong, by files and lines.

    Names and types are left alone if the constants or tags cannot be read.
    """
    unread = _unread_tables(settings)
    if unread:
        settings = replace(settings, syntax_only=True)
    parts = list(_shares(programs, settings, jobs))
    if jobs > 1 and len(parts) > 1:
        found = list(in_order(partial(_check_quietly, settings), parts, jobs))
    else:
        found = [_check(part, settings, progress) for part in parts]
    progress.end()
    checked = list(programs)
    if len(found) == len(programs):
        checked = [part.program for part in found]
    strangers = _of_no_program([part.findings for part in found])
    rest = (one for part in found for one in part.findings if one.code != _STRANGER)
    return checked, [*unread, *strangers, *rest]


def _of_no_program(findings: Sequence[Sequence[Diagnostic]]) -> list[Diagnostic]:
    """The numbers of data blocks that no program has."""
    strangers = [[one for one in part if one.code == _STRANGER] for part in findings]
    first, *others = strangers or [[]]
    messages = [{one.message for one in part} for part in others]
    return [one for one in first if all(one.message in known for known in messages)]


def _unread_tables(settings: Settings) -> list[Diagnostic]:
    try:
        global_file("tia", settings.constants, settings.tags)
    except DiagnosticError as failure:
        return list(failure.diagnostics)
    return []


def _shares(
    programs: Sequence[ProgramFiles], settings: Settings, jobs: int
) -> Iterator[ProgramFiles]:
    """The programs; their files in neighbouring groups where only the syntax is looked at."""
    for program in programs:
        if not settings.syntax_only or jobs == 1:
            yield program
            continue
        size = -(-len(program.paths) // jobs)
        for start in range(0, len(program.paths), size):
            yield replace(program, paths=program.paths[start : start + size])


def _check_quietly(settings: Settings, program: ProgramFiles) -> Checked:
    return _check(program, settings, Progress(0, shown=False))


def settled(program: ProgramFiles, settings: Settings) -> ProgramFiles:
    """The program in the dialect that it is right in."""
    return _check_quietly(settings, program).program if program.is_open else program


def _check(program: ProgramFiles, settings: Settings, progress: Progress) -> Checked:
    """Structured Text of nobody in particular is of CODESYS where that mends its conversions."""
    found = _findings(program, settings, progress)
    if program.is_open and any(one.code in _CONVERSIONS for one in found):
        other = replace(program, dialect="twincat")
        more = _findings(other, settings, progress)
        if len(_errors(more)) < len(_errors(found)):
            return Checked(other, [_needs_codesys(found), *more])
    return Checked(program, found)


def _errors(found: Sequence[Diagnostic]) -> list[Diagnostic]:
    return [one for one in found if one.severity is Severity.ERROR]


def _needs_codesys(found: Sequence[Diagnostic]) -> Diagnostic:
    first = next(one for one in found if one.code in _CONVERSIONS)
    return Diagnostic(
        "FB9015",
        "what converts by itself here is as in CODESYS: checked as dialect twincat",
        first.span,
        "say --dialect twincat, or --dialect iec to see what the standard does not convert",
        severity=Severity.WARNING,
    )


def _findings(program: ProgramFiles, settings: Settings, progress: Progress) -> list[Diagnostic]:
    trees: list[ast.File] = []
    found: list[Diagnostic] = []
    for path in program.paths:
        progress.step(str(path))
        try:
            document = read_document(path, program.dialect)
        except DiagnosticError as unreadable:
            found += unreadable.diagnostics
        else:
            trees.append(document.file)
            found += document.findings
    if not settings.syntax_only and trees:
        progress.step("names and types")
        rules = _rules(program.dialect, settings)
        tables = global_file(program.dialect, settings.constants, settings.tags)
        unread = _errors(found)
        _, more = check_reporting(
            [*trees, tables],
            program.dialect,
            rules=rules,
            db_numbers=settings.db_numbers,
            unread=unread,
        )
        classic = settings.cpu is not None and settings.cpu.is_classic
        found += [one for one in more if not (classic and one.code == _RESETS_ITSELF)]
        if settings.cpu is not None:
            parts = unread_parts(trees, unread)
            found += [one for one in missing_on(settings.cpu, trees) if not parts.follows(one)]
    return _in_order(found, program.paths)


def _rules(dialect: str, settings: Settings) -> Rules:
    """Those of the dialect, with what the CPU family and the setting of the compiler change."""
    rules = rules_for(dialect)
    if settings.cpu is not None:
        classic = settings.cpu.is_classic
        rules = replace(rules, iec_check=not classic, iec_check_open=False, bool_is_bits=classic)
        rules = replace(rules, narrows_unchecked=not classic)
    if settings.iec_check is not None:
        rules = replace(rules, iec_check=settings.iec_check, iec_check_open=False)
    return rules


def _in_order(found: Sequence[Diagnostic], paths: Sequence[Path]) -> list[Diagnostic]:
    order = {str(path): index for index, path in enumerate(paths)}

    def place(one: Diagnostic) -> tuple[int, int, int]:
        span = one.span
        return (
            (-1, 0, 0) if span is None else (order.get(span.source.name, 0), span.line, span.column)
        )

    return sorted(found, key=place)
