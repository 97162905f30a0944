"""What could not be lowered, each thing once."""

from fbgen.diagnostics import Diagnostic
from fbgen.source import Span


class Findings:
    """Collects diagnostics; the same message twice is one finding. `dialect` is the target."""

    def __init__(self, dialect: str) -> None:
        self.dialect = dialect
        self.all: list[Diagnostic] = []
        self._seen: set[tuple[str, str]] = set()

    def report(self, code: str, message: str, place: Span, hint: str) -> None:
        """Note what is refused, and what to write in its place."""
        if (code, message) not in self._seen:
            self._seen.add((code, message))
            self.all.append(Diagnostic(code, message, place, hint))

    def refuse(self, what: str, place: Span, hint: str) -> None:
        """Note something that the target has no counterpart for."""
        self.report("FB3051", f"{what} has no counterpart in dialect {self.dialect}", place, hint)
