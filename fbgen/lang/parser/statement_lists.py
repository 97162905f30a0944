"""Lists of statements: where they begin and end, and how to go on behind a broken one.

Source: IEC 61131-3, statements of ST; published sources for jump labels inside CASE that look like
the labels of its arms.
"""

from collections.abc import Callable, Mapping
from typing import Any, TypeVar

from fbgen.lang.ast import Statement, Trivia, TriviaList
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.parser.cursor import Unexpected
from fbgen.lang.parser.declarations import BLOCK_ENDS, UNITS, DeclarationParser
from fbgen.lang.parser.expressions import SOFT_KEYWORDS
from fbgen.lang.parser.places import NAMES
from fbgen.lang.parser.unread import UnreadParser
from fbgen.source import Source

ASSIGNMENTS = frozenset({":=", "+=", "-=", "*=", "/=", "?="})
"""Kinds of tokens that assign."""

JUMPS = {"GOTO": Feature.GOTO, "JMP": Feature.JUMPS}
"""Kinds of tokens in front of a label to go to."""

ENDS = (
    frozenset(f"END_{unit}" for unit in UNITS)
    | {"END_IF", "END_CASE", "END_FOR", "END_WHILE", "END_REPEAT", "END_REGION", "END_RESOURCE"}
    | {"END_VAR", "END_STRUCT", "END_CONST", "END_LABEL", "ELSE", "ELSIF", "UNTIL"}
    | {"END_UNION", "END_GET", "END_SET", "__CATCH", "__FINALLY", "__ENDTRY"}
)
"""Kinds of tokens that end something."""

STARTS = words("IF CASE FOR WHILE REPEAT REGION EXIT CONTINUE RETURN GOTO JMP __TRY")
"""Words that only a statement begins with."""

_LABEL_PARTS = NAMES | {".", "+", "-", "literal"}
_OPENERS = {
    "ELSE": "IF or CASE",
    "ELSIF": "IF",
    "UNTIL": "REPEAT",
    **dict.fromkeys(("__CATCH", "__FINALLY", "__ENDTRY"), "__TRY"),
}
READERS: dict[str, Callable[[Any], Statement]] = {}
"""Who reads the statement that begins with a token of this kind; see `enter`."""

_S = TypeVar("_S")


def enter(readers: Mapping[str, Callable[[Any], Statement]]) -> None:
    """Make known who reads the statements that begin with these kinds of tokens."""
    READERS.update(readers)


class StatementListParser(DeclarationParser, UnreadParser):
    """Reads lists of statements. `open_lists` has, per open statement, what can end its lists."""

    def __init__(self, source: Source, dialect: Dialect) -> None:
        super().__init__(source, dialect)
        self.open_lists: list[frozenset[str]] = []
        self.has_goto = "GOTO" in self.kinds or "JMP" in self.kinds
        self.jump_targets: frozenset[str] = frozenset()

    def body(self, end: str) -> tuple[Statement, ...]:
        """The statements of a block up to its end, which is not read."""
        self.jump_targets = self._targets_of_jumps(end) if self.has_goto else frozenset()
        return self.inside({end}, self.statements)

    def _targets_of_jumps(self, end: str) -> frozenset[str]:
        kinds = self.kinds
        try:
            last = kinds.index(end, self.at)
        except ValueError:
            last = len(kinds)
        return frozenset(
            self.texts[at + 1].casefold() for at in range(self.at, last - 1) if kinds[at] in JUMPS
        )

    def inside(self, ends: set[str], read: Callable[[], _S]) -> _S:
        """Read one level deeper, where the list of statements ends with one of `ends`."""
        self.deeper()
        self.open_lists.append(frozenset(ends))
        try:
            return read()
        finally:
            self.open_lists.pop()
            self.depth -= 1

    def statements(self) -> tuple[Statement, ...]:
        """Statements up to an end, which is not read."""
        statements: list[Statement] = []
        kinds, depth, levels = self.kinds, self.depth, len(self.open_lists)
        while True:
            start = self.at
            kind = kinds[start]
            if kind in READERS:
                try:
                    statements.append(READERS[kind](self))
                except Unexpected:
                    self.recover(start, depth, levels)
            elif self._at_end(kind):
                return tuple(statements)

    def arm_statements(self) -> tuple[Statement, ...]:
        """Statements up to the next label of the CASE, or its end."""
        statements: list[Statement] = []
        kinds, depth, levels = self.kinds, self.depth, len(self.open_lists)
        while True:
            start = self.at
            kind = kinds[start]
            if (kind in _LABEL_PARTS or kind in SOFT_KEYWORDS) and self._at_case_label():
                return tuple(statements)
            if kind in READERS:
                try:
                    statements.append(READERS[kind](self))
                except Unexpected:
                    self.recover(start, depth, levels)
            elif self._at_end(kind):
                return tuple(statements)

    def recover(self, start: int, depth: int, levels: int) -> None:
        """Go back to this level of nesting and on to the next statement.

        A statement that begins with a misspelt keyword is read again with the right one.
        """
        self.depth = depth
        del self.open_lists[levels:]
        if self.at <= start + 1 and (meant := self.meant(start)):
            self.at = start + meant.before
            self.kinds[self.at] = meant.keyword
        else:
            self.skip_statement(start)

    def _at_end(self, kind: str) -> bool:
        """Whether the list ends here. Anything that is neither end nor statement is skipped."""
        if kind in self.open_lists[-1] or kind == "end":
            return True
        soft = self.kinds[self.at + 1] in (":=", ".", "[", "(")
        if kind in UNITS and not soft:
            return True
        if kind in ENDS:
            if any(kind in ends for ends in self.open_lists):
                return True
            if kind == "END_REGION" and Feature.REGIONS not in self.dialect.features:
                self.missing_feature(Feature.REGIONS, self.token_span(self.at))
                self.skip_line()
                return False
            if kind in BLOCK_ENDS and self.is_last_of_unit():
                return True
            opener = _OPENERS.get(kind) or kind.removeprefix("END_")
            self._last_finding_at = self.at
            self.report(
                "FB3008",
                f"{kind} without {opener}",
                self.token_span(self.at),
                f"remove it, or write the {opener} that it ends",
            )
            self.at += 1
            self.accept(";")
            return False
        if soft and self.word(self.at):
            self.kinds[self.at] = "name"
            return False
        start = self.at
        self.unexpected("a statement", "statements begin with a variable, a block or a keyword")
        self.skip_statement(start)
        return False

    def skip_statement(self, start: int) -> None:
        """Go to the next place where a statement can begin or a list can end."""
        if self.at == start:
            self.at += 1
        kinds = self.kinds
        while True:
            kind = kinds[self.at]
            if kind == ";":
                self.at += 1
                return
            if kind == "end" or kind in ENDS or kind in STARTS or kind in UNITS:
                return
            if kind in NAMES and self.starts_line(self.at) and self._begins_statement():
                return
            self.at += 1

    def _begins_statement(self) -> bool:
        """Whether a name at the start of a line is followed as in an assignment or a call."""
        at = self.at + 1
        while self.kinds[at] == "." and self.kinds[at + 1] != "end":
            at += 2
        return self.kinds[at] in ASSIGNMENTS or self.kinds[at] in ("(", "[")

    # --- ends ---------------------------------------------------------------------------------

    def is_last_of_unit(self) -> bool:
        """Whether nothing of the same unit stands behind this token."""
        at = self.at + 1
        while self.kinds[at] == ";":
            at += 1
        return self.kinds[at] in UNITS or self.kinds[at] in ("end", "END_NAMESPACE")

    def end(self, end: str, first: int, hint: str = "") -> None:
        """Read END_x and its semicolon; `hint` is the help where it is missing."""
        if self.accept(end):
            if not self.accept(";") and not self.dialect.has(Feature.BARE_ENDS):
                self.missing_semicolon(end)
        elif self.kinds[self.at] in ENDS | UNITS | {"end"}:
            self.missing_end(end, first, hint)
        else:
            raise self.failed(end, hint or f"write {end}; where it ends")

    def finish(self, leading: TriviaList) -> tuple[TriviaList, Trivia | None]:
        return self.settle(leading) if self.extra_at <= self.at else (leading, None)

    def semicolon(self) -> None:
        if self.kinds[self.at] == ";":
            self.at += 1
        else:
            self.missing_semicolon("the statement")

    # --- labels of CASE ------------------------------------------------------------------------

    def _at_case_label(self) -> bool:
        """Whether the next tokens are a label of a CASE rather than a statement or a jump label."""
        kinds, at = self.kinds, self.at
        if kinds[at] == "literal":
            return True
        while kinds[at] in _LABEL_PARTS or (kinds[at] in SOFT_KEYWORDS and at == self.at):
            at += 1
        if kinds[at] not in (":", ",", "..") or (at > self.at and self.at_peripheral_mark(at)):
            return False
        is_jump_label = (
            at == self.at + 1
            and kinds[at] == ":"
            and self.texts[self.at].casefold() in self.jump_targets
        )
        return not is_jump_label
