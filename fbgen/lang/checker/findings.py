"""The errors and warnings of one check, in the order of the text."""

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace

from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.source import Span

_GAP = "FB4141"
_SHOWN = 2
"""How many more places of one unknown name are shown; of the others there is the line."""
_LISTED = 12


class Findings:
    """Collects findings; the same finding at the same place is kept once.

    `unclear` are the expressions without a type, because of an error there or in a declaration.
    """

    def __init__(self) -> None:
        self.unclear: list[Span] = []
        self._found: dict[tuple[str, Span | None, str], Diagnostic] = {}
        self._more: dict[tuple[str, str], list[Span]] = {}
        self.has_errors = False
        self._gaps: set[str] = set()
        self._unknown: dict[str, tuple[str, str]] = {}

    def error(
        self,
        code: str,
        message: str,
        span: Span | None,
        help_text: str = "",
        notes: tuple[Note, ...] = (),
    ) -> None:
        """Something that stops the work."""
        self.has_errors = True
        self._found.setdefault(
            (code, span, message), Diagnostic(code, message, span, help_text, notes)
        )

    def unknown(
        self, code: str, message: str, span: Span, help_text: Callable[[], str], name: str = ""
    ) -> None:
        """An unknown name of the whole program: one error, however often it is mentioned.

        `help_text` looks for names that are near, so it is asked for the first mention only. A
        global `name` can be mentioned in several ways, as what is called and as what has members.
        """
        self.has_errors = True
        self.unclear.append(span)
        if name:
            code, message = self._unknown.setdefault(name.casefold(), (code, message))
        if self._mentioned_first(code, message, span):
            self.error(code, message, span, help_text())

    def gap(self, message: str, span: Span, help_text: str) -> None:
        """What the controller has and the engines lack: a warning, and no program to run."""
        self.unclear.append(span)
        self._gaps.add(message)
        self.repeated_warning(_GAP, message, span, help_text)

    @property
    def keeps_from_running(self) -> bool:
        """True if there is no program to run."""
        return self.has_errors or bool(self._gaps)

    def keeping_from_running(self, sources: tuple[str, ...]) -> list[Diagnostic]:
        """The errors, and the gaps as errors, in order."""
        return [
            replace(one, severity=Severity.ERROR)
            for one in self.in_order(sources)
            if one.severity is Severity.ERROR or one.message in self._gaps
        ]

    def repeated_warning(self, code: str, message: str, span: Span, help_text: str) -> None:
        """A warning that many places have in common: one, however many there are."""
        if self._mentioned_first(code, message, span):
            self.warning(code, message, span, help_text)

    def _mentioned_first(self, code: str, message: str, span: Span) -> bool:
        places = self._more.setdefault((code, message), [])
        if span not in places[-1:]:
            places.append(span)
        return places == [span]

    def error_places(self) -> list[Span]:
        """Where errors are, and what has no meaning because of them."""
        return self.unclear + [
            one.span
            for one in self._found.values()
            if one.severity is Severity.ERROR and one.span is not None
        ]

    def warning(self, code: str, message: str, span: Span | None, help_text: str = "") -> None:
        """Something that works and is likely a mistake."""
        self._found.setdefault(
            (code, span, message),
            Diagnostic(code, message, span, help_text, severity=Severity.WARNING),
        )

    def add(self, diagnostic: Diagnostic) -> None:
        """A warning or hint that was made elsewhere."""
        key = (diagnostic.code, diagnostic.span, diagnostic.message)
        self._found.setdefault(key, diagnostic)

    def replace(self, diagnostics: Iterable[Diagnostic]) -> None:
        """Keep these findings only."""
        self._found = {(one.code, one.span, one.message): one for one in diagnostics}

    def found(self) -> Collection[Diagnostic]:
        """All findings so far, in no order."""
        return self._found.values()

    def in_order(self, sources: tuple[str, ...]) -> tuple[Diagnostic, ...]:
        """All findings by file, in the order of `sources`, then by place."""
        position = {name: index for index, name in enumerate(sources)}

        def place(diagnostic: Diagnostic) -> tuple[int, int]:
            span = diagnostic.span
            if span is None:
                return (-1, 0)
            return (position.get(span.source.name, len(position)), span.start)

        return tuple(sorted(map(self._with_mentions, self._found.values()), key=place))

    def _with_mentions(self, diagnostic: Diagnostic) -> Diagnostic:
        others = self._more.get((diagnostic.code, diagnostic.message), [])[1:]
        if not others:
            return diagnostic
        notes = [Note("and here", span) for span in others[:_SHOWN]]
        if len(others) > _SHOWN:
            notes.append(Note(_further(others[_SHOWN:])))
        return replace(diagnostic, notes=(*diagnostic.notes, *notes))


def _further(places: Sequence[Span]) -> str:
    lines = [f"{one.source.name}:{one.line}" for one in places[:_LISTED]]
    if all(one.source is places[0].source for one in places):
        lines = [str(one.line) for one in places[:_LISTED]]
    listed = ", ".join(dict.fromkeys(lines)) + (", ..." if len(places) > _LISTED else "")
    plural = "s" if len(places) > 1 else ""
    return f"and in {len(places)} more place{plural}, line{plural} {listed}"
