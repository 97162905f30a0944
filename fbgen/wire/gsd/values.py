"""Values of statements: numbers, flags, texts, bytes. What does not fit is FB1303."""

from collections.abc import Iterable
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.source import Span
from fbgen.wire.gsd.keywords import KEYWORDS
from fbgen.wire.gsd.lines import Kind, Token
from fbgen.wire.gsd.statements import Statement, number_of

LONGEST_TEXT = 256


@dataclass(slots=True)
class Values:
    """The statements of one place by their keywords, and what was wrong with their values.

    A keyword that stands twice has the value of its last line, as in the tools that read such
    files; with two different values it is FB1307.
    """

    statements: Iterable[Statement]
    findings: list[Diagnostic]
    known: dict[str, Statement] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for statement in self.statements:
            if not statement.keyword or statement.index:
                continue
            earlier = self.known.get(statement.key)
            if earlier is not None and _plain(earlier) != _plain(statement):
                self.findings.append(_twice(statement, earlier))
            self.known[statement.key] = statement

    def number(self, keyword: str, default: int, highest: int = 0xFFFF) -> int:
        """A number from 0 to `highest`; the default where the keyword is missing or wrong."""
        found = self.optional_number(keyword, highest)
        return default if found is None else found

    def optional_number(self, keyword: str, highest: int = 0xFFFF) -> int | None:
        """As `number`; None where the keyword is missing or wrong."""
        statement = self.known.get(keyword.lower())
        if statement is None:
            return None
        if len(statement.value) == 1 and statement.value[0].kind is Kind.WORD:
            value = number_of(statement.value[0].text)
            if value is not None and value <= highest:
                return value
        self.findings.append(not_a(f"a number from 0 to {highest}", statement))
        return None

    def flag(self, keyword: str, *, default: bool = False) -> bool:
        """0 or 1; any other number counts as 1."""
        return self.number(keyword, int(default)) != 0

    def text(self, keyword: str) -> str:
        """A text; "" where the keyword is missing or wrong."""
        statement = self.known.get(keyword.lower())
        if statement is None:
            return ""
        if len(statement.value) == 1 and statement.value[0].kind is Kind.TEXT:
            return statement.value[0].text[:LONGEST_TEXT].strip()
        if not any(one.kind is Kind.OPEN for one in statement.value):
            self.findings.append(not_a("a text in quotes", statement))
        return ""


def octets_of(
    tokens: Iterable[Token], statement: Statement, findings: list[Diagnostic]
) -> bytes | None:
    """Numbers up to 255 with commas between them, or none; None and FB1303 for anything else."""
    values = bytearray()
    for token in tokens:
        if token.text == "," and token.kind is Kind.SIGN:
            continue
        value = number_of(token.text) if token.kind is Kind.WORD else None
        if value is None or value > 0xFF:
            findings.append(not_a("bytes such as 0x30,0x20", statement, token.span))
            return None
        values.append(value)
    return bytes(values)


def numbers_of(tokens: Iterable[Token]) -> list[int]:
    """All numbers in a value, each with the minus that stands in front of it and behind no number.

    `-10--3` holds -10 and -3, `0-10` holds 0 and 10.
    """
    found: list[int] = []
    sign, after_number = 1, False
    for token in tokens:
        value = number_of(token.text) if token.kind is Kind.WORD else None
        if value is not None:
            found.append(sign * value)
            sign, after_number = 1, True
        elif token.text == "-" and not after_number:
            sign = -1
        else:
            after_number = False
    return found


def not_a(expected: str, statement: Statement, span: Span | None = None) -> Diagnostic:
    """FB1303: what stands there, and what the keyword takes."""
    place = span or statement.value_span
    shown = place.text.partition("\n")[0] if statement.value else "nothing"
    name = KEYWORDS.get(statement.key, statement.keyword)
    return Diagnostic(
        "FB1303", f"{name} takes {expected}, not {shown[:40]}", place, f"write {expected}"
    )


def _twice(statement: Statement, earlier: Statement) -> Diagnostic:
    return Diagnostic(
        "FB1307",
        f"{statement.keyword} is given twice with different values",
        statement.span,
        "the last one counts here; which one another tool takes is not said anywhere",
        (Note("first here", earlier.span),),
        Severity.WARNING,
    )


def _plain(statement: Statement) -> tuple[str, ...]:
    return tuple(token.text for token in statement.value)
