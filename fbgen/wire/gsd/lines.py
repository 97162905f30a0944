"""The lines of a GSD file: where its PROFIBUS part begins, comments, continued lines, tokens.

A GSD file (EN 50170 volume 2, device database files; PROFIBUS guideline 2.122) is read line by
line. What stands in front of `#Profibus_DP`, and behind another `#` line, is for others. A `;`
begins a comment, a backslash at the end of a line continues it in the next one. How vendors write
is seen from public files: spaces anywhere, `Text (0)`, texts behind `@`, comments behind the
backslash.
"""

import re
from collections.abc import Iterator
from enum import Enum, auto

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.source import Source, Span

_BEGIN = re.compile(r"^[ \t]*#[ \t]*Profibus_DP\b[^\n]*", re.IGNORECASE | re.MULTILINE)
_SECTION = re.compile(r"^[ \t]*#[^\n]*", re.MULTILINE)
_TOKEN = re.compile(
    r"""
      (?P<SPACE>[^\S\n]+)
    | (?P<COMMENT>;[^\n]*)
    | (?P<JOIN>\\[^\S\n]*(?:;[^\n]*)?(?:\n|\Z))
    | (?P<END>\n)
    | (?P<TEXT>"(?:[^"\n\\]|\\[ \t]*\n|\\)*")
    | (?P<OPEN>"[^\n]*)
    | (?P<FAMILY>@[^\n;]*)
    | (?P<WORD>[A-Za-z0-9_.]+)
    | (?P<SIGN>[=(),\-])
    | (?P<OTHER>.)
    """,
    re.VERBOSE,
)
_CONTINUED = re.compile(r"\\[ \t]*\n")


class Kind(Enum):
    """What a token is. FAMILY: the texts behind `@`; OPEN: a text without its second quote."""

    TEXT = auto()
    OPEN = auto()
    FAMILY = auto()
    WORD = auto()
    SIGN = auto()
    OTHER = auto()


@dataclass(frozen=True, slots=True)
class Token:
    """A token with its place. The text of a TEXT is what stands between the quotes."""

    kind: Kind
    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Line:
    """A line with what continues it; it has one token at least."""

    tokens: tuple[Token, ...]

    @property
    def span(self) -> Span:
        """From its first token to the last."""
        return self.tokens[0].span.to(self.tokens[-1].span)


def gsd_lines(source: Source) -> Iterator[Line]:
    """The lines of the PROFIBUS DP part. Raises DiagnosticError FB1301 where there is none."""
    begins = [match.end() for match in _BEGIN.finditer(source.text)]
    if not begins:
        raise DiagnosticError([_no_gsd(source)])
    others = [match.start() for match in _SECTION.finditer(source.text)]
    for begin in begins:
        end = next((start for start in others if start >= begin), len(source.text))
        yield from _lines(source, begin, end)


def unreadable(line: Line, reason: str) -> Diagnostic:
    """FB1302: a line that says nothing."""
    return Diagnostic(
        "FB1302",
        reason,
        line.span,
        "the line is ignored; a comment begins with ;",
        severity=Severity.WARNING,
    )


def _lines(source: Source, begin: int, end: int) -> Iterator[Line]:
    tokens: list[Token] = []
    for match in _TOKEN.finditer(source.text, begin, end):
        name = match.lastgroup or ""
        if name == "END":
            if tokens:
                yield Line(tuple(tokens))
            tokens = []
        elif name in Kind.__members__:
            tokens.append(_token(Kind[name], match[0], Span(source, match.start(), match.end())))
    if tokens:
        yield Line(tuple(tokens))


def _token(kind: Kind, text: str, span: Span) -> Token:
    if kind is Kind.TEXT:
        text = _CONTINUED.sub("", text[1:-1])
    return Token(kind, text, span)


def _no_gsd(source: Source) -> Diagnostic:
    stripped = source.text.lstrip()
    if stripped.startswith(("<?xml", "<ISO15745")):
        what = "it is XML, as GSDML files of PROFINET devices are"
    elif "\0" in source.text:
        what = "it is no text"
    else:
        what = "the line #Profibus_DP is missing"
    first = source.text.partition("\n")[0]
    return Diagnostic(
        "FB1301",
        f"{source.name} is no GSD file: {what}",
        Span(source, 0, len(first)),
        "name the GSD file of a PROFIBUS DP slave: its data begin with #Profibus_DP",
    )
