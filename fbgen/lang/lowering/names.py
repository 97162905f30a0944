"""Names that IEC 61131-3 takes.

Source: IEC 61131-3 second edition, identifiers: letters, digits and single underscores, no digit
in front, no underscore at the end; case does not matter.
"""

import re

from fbgen.lang.dialects.dialect import Dialect
from fbgen.lang.lowering.findings import Findings
from fbgen.source import Span

_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def is_identifier(name: str) -> bool:
    """Whether IEC and classic STEP 7 take the name as it stands."""
    return bool(_PLAIN.fullmatch(name)) and not name.endswith("_") and "__" not in name


class Names:
    """Checks names and makes new ones that nobody uses yet."""

    def __init__(self, dialect: Dialect, findings: Findings) -> None:
        self._dialect = dialect
        self._findings = findings
        self._used: set[str] = set()

    def reserve(self, name: str) -> None:
        """Note a global name, so that no new one meets it."""
        self._used.add(name.casefold())

    def new(self, wish: str) -> str:
        """A global name close to the wish that is still free."""
        name, number = wish, 2
        while name.casefold() in self._used:
            name, number = f"{wish}{number}", number + 1
        self.reserve(name)
        return name

    def check_declared(self, name: str, place: Span) -> str:
        """The name of a variable, reported if IEC does not take it or a block or type has it."""
        if name.casefold() in self._used:
            self._findings.report(
                "FB3050",
                f"the name '{name}' is that of a block, a type or a data block too",
                place,
                "give one of them another name; IEC keeps all names in one list",
            )
        return self.check(name, place)

    def check(self, name: str, place: Span) -> str:
        """The name, reported if IEC does not take it."""
        problem = self._problem(name)
        if problem:
            self._findings.report(
                "FB3050",
                f"the name '{name}' {problem}",
                place,
                "rename it: letters, digits and single underscores between them",
            )
        return name

    def _problem(self, name: str) -> str:
        if not name.isascii():
            return "has characters beyond ASCII"
        if not _PLAIN.fullmatch(name):
            return "is no identifier"
        if name.startswith("_") or name.endswith("_") or "__" in name:
            return "has an underscore at its edge or two in a row"
        if name.upper() in self._dialect.reserved:
            return f"is a reserved word of dialect {self._dialect.name}"
        if len(name) > self._dialect.identifier_length:
            return f"is longer than {self._dialect.identifier_length} characters"
        return ""
