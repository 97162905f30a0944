"""What fbgen says when something is wrong: a code, a place, what is there and how to mend it.

Every error that a user can cause is a `Diagnostic`. Functions that can find several collect them
and raise one `DiagnosticError` with all of them. `docs/reference/diagnostics/CODE.md` explains
each code with a failing and a fixed example; `fbgen explain CODE` prints it.

Ranges of codes: FB1 catalogue, YAML, GSD, FB2 plant file, FB3 reading PLC text, FB4 checking PLC
text, FB5 generating, FB6 running PLC text, FB7 plant simulation, FB8 scenarios, FB9 command line
and files. A code is never used again for something else.
"""

from collections.abc import Iterable
from enum import Enum

from fbgen.dataclass import dataclass
from fbgen.excerpt import harmless, shown_line
from fbgen.source import Span


class Severity(Enum):
    """How bad it is: only errors stop the work."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"


@dataclass(frozen=True, slots=True)
class Note:
    """A second place that belongs to a diagnostic, such as the first of two duplicates."""

    message: str
    span: Span | None = None


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One finding. `message` says what is there, `help` how to mend it."""

    code: str
    message: str
    span: Span | None = None
    help: str = ""
    notes: tuple[Note, ...] = ()
    severity: Severity = Severity.ERROR

    def as_json(self) -> dict[str, object]:
        """The finding as plain data; lines and columns count from 1, `end` is exclusive."""
        data: dict[str, object] = {
            "code": self.code,
            "severity": self.severity.value,
            "message": self.message,
        }
        if self.help:
            data["help"] = self.help
        if self.span is not None:
            data |= _place(self.span)
        if self.notes:
            data["notes"] = [
                {"message": note.message} | (_place(note.span) if note.span else {})
                for note in self.notes
            ]
        return data


class DiagnosticError(Exception):
    """Raised with every finding that stopped the work."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("\n".join(render(diagnostic) for diagnostic in self.diagnostics))

    def __reduce__(
        self,
    ) -> "tuple[type[DiagnosticError], tuple[tuple[Diagnostic, ...]], dict[str, object]]":
        """So that it goes from one process to another, with its notes."""
        return type(self), (self.diagnostics,), self.__dict__


def error(code: str, message: str, span: Span | None = None, help: str = "") -> DiagnosticError:  # noqa: A002
    """The exception for a single finding, ready to raise."""
    return DiagnosticError([Diagnostic(code, message, span, help)])


def render(diagnostic: Diagnostic) -> str:
    """The finding for a person, with the source line and carets under the place.

    error[FB3001]: found 'THEN', expected an expression
      --> pump.scl:12:8
       |
    12 |     IF THEN
       |        ^^^^
       = help: write the condition between IF and THEN
    """
    lines = [f"{diagnostic.severity.value}[{diagnostic.code}]: {harmless(diagnostic.message)}"]
    gutter = 0
    if diagnostic.span is not None:
        gutter = len(str(diagnostic.span.line))
        lines += _excerpt(diagnostic.span, gutter)
    for note in diagnostic.notes:
        lines.append(f"{' ' * gutter} = note: {harmless(note.message)}")
        if note.span is not None:
            lines += _excerpt(note.span, max(gutter, len(str(note.span.line))))
    if diagnostic.help:
        lines.append(f"{' ' * gutter} = help: {harmless(diagnostic.help)}")
    return "\n".join(lines)


def _excerpt(span: Span, gutter: int) -> list[str]:
    line = span.line
    shown = shown_line(span)
    lines = [f"{' ' * gutter}--> {harmless(str(span))}"]
    if origin := span.origin:
        lines.append(f"{' ' * gutter}  = from {origin.what} ({origin.file}:{origin.line})")
    lines += [
        f"{' ' * gutter} |",
        f"{line:>{gutter}} | {shown.text}",
        f"{' ' * gutter} | {shown.pad}{shown.carets}",
    ]
    return lines


def _place(span: Span) -> dict[str, object]:
    return {
        "file": span.source.name,
        "line": span.line,
        "column": span.column,
        "end_line": span.end_line,
        "end_column": span.end_column,
    }
