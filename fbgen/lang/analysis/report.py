"""The warnings of one block while its paths are followed: kept until the last round."""

from typing import NamedTuple

from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.lang.checked import Variable
from fbgen.source import Span


class Warned(NamedTuple):
    """One warning; `about` is the variable that it is about, if it is about one."""

    diagnostic: Diagnostic
    about: Variable | None


class Report:
    """Collects warnings. What is about a variable in `vague` is not reported.

    `vague` are variables of statements with errors: nobody knows what these do to them.
    """

    __slots__ = ("found", "vague")

    def __init__(self, vague: frozenset[Variable] = frozenset()) -> None:
        self.found: list[Warned] = []
        self.vague = vague

    def warning(
        self,
        code: str,
        message: str,
        span: Span,
        help_text: str,
        *,
        about: Variable | None = None,
        notes: tuple[Note, ...] = (),
    ) -> None:
        """Something that works and is likely a mistake."""
        if about is None or about not in self.vague:
            found = Diagnostic(code, message, span, help_text, notes, Severity.WARNING)
            self.found.append(Warned(found, about))

    def hint(self, code: str, message: str, span: Span, help_text: str) -> None:
        """Something that is no mistake here and may be one elsewhere."""
        self.found.append(
            Warned(Diagnostic(code, message, span, help_text, severity=Severity.INFO), None)
        )
