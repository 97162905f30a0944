"""What of a program could not be read, so that the rest of it can still be checked.

A unit with a syntax error in it is left alone. What the others may ask of it is known as far as it
was read: all of its declarations if the error is behind them, else those that are there. Of a unit
that was lost altogether only the words in its place are known, which may be names.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.lang import ast
from fbgen.source import Span

_WORD = re.compile(r"\w+")
_READ_ANYWAY = "FB3010"
"""A missing semicolon: nothing is lost."""
_UNKNOWN = ("FB4001", "FB4003", "FB4004")
_OF_ALL = ("FB4205", "FB4222", "FB4235")
"""Warnings that nobody does something: what was not read may do it."""
_MARKS = '"#'


@dataclass(frozen=True, slots=True)
class UnreadParts:
    """Where a program was not read.

    `units` are the places of units with an error in them, `files` files of which nothing is clear.
    `incomplete` has the casefolded names of units that may declare more than was read, `lost` words
    that may be names of units that were not read at all.
    """

    units: tuple[Span, ...] = ()
    files: frozenset[str] = field(default=frozenset())
    incomplete: frozenset[str] = field(default=frozenset())
    lost: frozenset[str] = field(default=frozenset())

    def follows(self, finding: Diagnostic) -> bool:
        """True for a finding that an unread part may be the reason of, or that lies in one."""
        span = finding.span
        if span is None:
            return bool(self.units or self.lost or self.files)
        if span.source.name in self.files or any(_is_inside(span, unit) for unit in self.units):
            return True
        if finding.code in _OF_ALL:
            return bool(self.units or self.lost or self.files)
        if finding.code not in _UNKNOWN:
            return False
        name = span.text.strip(_MARKS).casefold()
        return bool(self.files) or name in self.lost or name in self.incomplete


NOTHING_UNREAD = UnreadParts()


def unread_parts(files: Sequence[ast.File], findings: Sequence[Diagnostic]) -> UnreadParts:
    """What the findings of the parser say about the trees."""
    wrong: dict[str, list[int]] = {}
    for one in findings:
        if one.severity is Severity.ERROR and one.span and one.code != _READ_ANYWAY:
            wrong.setdefault(one.span.source.name, []).append(one.span.start)
    if not wrong:
        return NOTHING_UNREAD
    units: list[Span] = []
    incomplete: set[str] = set()
    lost: set[str] = set()
    read = {file.source.name: file for file in files}
    for name, starts in wrong.items():
        if name not in read:
            continue
        known = sorted(_units(read[name].units), key=lambda unit: unit.span.start)
        for start in starts:
            unit = next((one for one in known if one.span.start <= start < one.span.end), None)
            if unit is None:
                lost |= _words_around(read[name], known, start)
            else:
                units.append(unit.span)
                incomplete |= _open_names(unit, start)
    return UnreadParts(
        tuple(dict.fromkeys(units)),
        frozenset(name for name in wrong if name not in read),
        frozenset(incomplete),
        frozenset(lost),
    )


def _units(units: Sequence[ast.Unit]) -> Iterator[ast.Unit]:
    for unit in units:
        if isinstance(unit, ast.Namespace):
            yield from _units(unit.units)
        else:
            yield unit


def _is_inside(span: Span, unit: Span) -> bool:
    same = span.source.name == unit.source.name
    return same and unit.start <= span.start < unit.end


def _open_names(unit: ast.Unit, start: int) -> set[str]:
    """The names of a unit if it may declare more; nothing if the error is in its statements."""
    if isinstance(unit, ast.Block) and not unit.members:
        declared = max((section.span.end for section in unit.sections), default=unit.name.span.end)
        return {unit.name.name.casefold()} if start < declared else set()
    if isinstance(unit, ast.DataBlock):
        if unit.assignments and start >= unit.assignments[0].span.start:
            return set()
        return {unit.name.name.casefold()}
    if isinstance(unit, ast.TypeDeclaration | ast.Block | ast.Interface):
        return {unit.name.name.casefold()}
    return {word.casefold() for word in _WORD.findall(unit.span.text)}


def _words_around(file: ast.File, known: Sequence[ast.Unit], start: int) -> set[str]:
    """All words between the units that were read around an error."""
    text = file.source.text
    first = max((one.span.end for one in known if one.span.end <= start), default=0)
    last = min((one.span.start for one in known if one.span.start > start), default=len(text))
    return {word.casefold() for word in _WORD.findall(text, first, last)}
