"""The errors and warnings of one check, in the order of the text."""

from collections.abc import Collection

from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.source import Span


class Findings:
    """Collects findings; the same finding at the same place is kept once."""

    def __init__(self) -> None:
        self._found: dict[tuple[str, Span | None, str], Diagnostic] = {}
        self.has_errors = False

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

        return tuple(sorted(self._found.values(), key=place))
