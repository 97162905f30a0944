"""Comments that allow a warning in one place: `// fbgen: allow FB4230`, with a reason behind it.

Behind code, the comment speaks of its own line; on a line of its own, of the next statement,
declaration or section; above a block, of the whole block. An error cannot be allowed. What a
comment allows and nobody finds is reported, so that such comments do not stay for ever.
"""

import re
from collections.abc import Collection, Iterator, Sequence
from typing import Any

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.lang import ast
from fbgen.lang.walk import walk
from fbgen.nearest import nearest
from fbgen.pages import pages, severity_of
from fbgen.source import Span

_COMMENT = re.compile(
    r"\bfbgen:\s*allow\s+"
    r"(?P<codes>\w+(?:\s*,\s*FB\w+)*)",
    re.ASCII | re.IGNORECASE,
)
_COMMENTS = (ast.TriviaKind.LINE_COMMENT, ast.TriviaKind.BLOCK_COMMENT)
_TOUCHABLE = frozenset(
    kind
    for kind in vars(ast).values()
    if isinstance(kind, type)
    and {"span", "leading"} <= set(getattr(kind, "__slots__", ()))
    and kind is not ast.Argument
) | {ast.Globals}
"""What a comment can stand above: statements, declarations, sections, blocks."""


@dataclass(slots=True)
class _Allowance:
    """One code that a comment allows from `start` to `end`."""

    code: str
    place: Span
    start: int
    end: int
    used: bool = False

    def covers(self, diagnostic: Diagnostic) -> bool:
        """True if the comment speaks of this finding."""
        span = diagnostic.span
        return (
            diagnostic.code == self.code
            and span is not None
            and span.source is self.place.source
            and self.start <= span.start < self.end
        )


def without_allowed(
    findings: Collection[Diagnostic], files: Sequence[ast.File]
) -> Collection[Diagnostic]:
    """The findings that no comment allows, and FB4290 to FB4292 for comments that are wrong."""
    allowances: list[_Allowance] = []
    wrong: list[Diagnostic] = []
    for file in files:
        if _COMMENT.search(file.source.text):
            for comment in _comments(file):
                _read(comment, file, allowances, wrong)
    if not allowances and not wrong:
        return findings
    kept: list[Diagnostic] = []
    for finding in findings:
        silenced = False
        if finding.severity is not Severity.ERROR:
            for one in allowances:
                if one.covers(finding):
                    silenced = one.used = True
        if not silenced:
            kept.append(finding)
    return [*kept, *wrong, *(_unneeded(one) for one in allowances if not one.used)]


def _comments(file: ast.File) -> Iterator[ast.Trivia]:
    for item in walk(file):
        if isinstance(item, ast.Trivia) and item.kind in _COMMENTS:
            yield item


def _read(
    comment: ast.Trivia, file: ast.File, allowances: list[_Allowance], wrong: list[Diagnostic]
) -> None:
    found = _COMMENT.search(comment.text)
    if found is None:
        return
    start, end = _scope(comment, file)
    for code in re.split(r"\s*,\s*", found["codes"]):
        key = code.upper()
        if key not in pages():
            wrong.append(_unknown(comment, code))
        elif severity_of(key) is Severity.ERROR:
            wrong.append(_not_allowable(comment, key))
        else:
            allowances.append(_Allowance(key, comment.span, start, end))


def _scope(comment: ast.Trivia, file: ast.File) -> tuple[int, int]:
    """From where to where, as offsets, a comment speaks."""
    source, span = file.source, comment.span
    line = source.line_text(span.line)
    begin = span.start - (span.column - 1)
    if line[: span.column - 1].strip():
        return begin, begin + len(line)
    best: tuple[int, int] | None = None
    item: Any
    for item in walk(file):
        if type(item) in _TOUCHABLE:
            start, end = item.span.start, item.span.end
            if start >= span.end and (best is None or (start, -end) < (best[0], -best[1])):
                best = start, end
    return best or (span.start, span.end)


def _unknown(comment: ast.Trivia, code: str) -> Diagnostic:
    return Diagnostic(
        "FB4290",
        f"there is no warning with the code '{code}' to allow",
        comment.span,
        nearest(code.upper(), pages()),
        severity=Severity.WARNING,
    )


def _not_allowable(comment: ast.Trivia, code: str) -> Diagnostic:
    return Diagnostic(
        "FB4292",
        f"{code} is an error and cannot be allowed",
        comment.span,
        f"mend it: fbgen explain {code}",
        severity=Severity.WARNING,
    )


def _unneeded(one: _Allowance) -> Diagnostic:
    return Diagnostic(
        "FB4291",
        f"nothing here gives {one.code}, so it need not be allowed",
        one.place,
        "remove the code from the comment",
        severity=Severity.WARNING,
    )
