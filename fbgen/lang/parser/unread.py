"""What is no statement: slips with a hint, and parts of the languages that are refused by name.

What begins with one of the words below is right in other tools. The finding stands at the word, and
reading goes on behind what it begins.
"""

from collections.abc import Iterator

from fbgen.lang.ast import Expression, Name
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.parser.cursor import Cursor, Unexpected
from fbgen.lang.parser.meant_words import Meant, meant_keyword

UNREAD_SECTIONS = words("VAR_ACCESS VAR_CONFIG VAR_GENERIC")
"""Sections with connections between the parts of a project, and what no S7 has."""

_CHART = words("INITIAL_STEP STEP TRANSITION")
_LIST = words("LD LDN ST STN CAL CALC CALCN JMPC JMPCN RETC RETCN")
_BODY_ENDS = words(
    "END_FUNCTION_BLOCK END_FUNCTION END_PROGRAM END_CLASS END_METHOD END_ACTION END_GET END_SET "
    "end"
)


class UnreadParser(Cursor):
    """Says why something is no statement."""

    def meant(self, start: int) -> Meant | None:
        """The keyword that the statement from a token on must begin with."""
        return meant_keyword(self.kinds, self.texts, self._line_from(start))

    def _line_from(self, start: int) -> Iterator[int]:
        """The tokens from one on that are in its line."""
        yield start
        at = start + 1
        while not self.starts_line(at) and self.kinds[at] != "end":
            yield at
            at += 1

    def no_statement(self, target: Expression, first: int) -> Unexpected:
        """Report what begins with this target, token number `first`, and is no statement."""
        if self.kinds[self.at] == "=":
            return self.failed("':='", "an assignment is written ':=', '=' compares")
        if isinstance(target, Name) and (refusal := self._refusal(target.name, first)):
            return refusal
        if isinstance(target, Name) and target.name.upper() in ("REGION", "END_REGION"):
            self.missing_feature(Feature.REGIONS, target.span)
            self.skip_line()
            self._last_finding_at = self.at
            return Unexpected()
        meant = self.meant(first) if self.at == first + 1 else None
        return self.failed(
            "':=' or '('",
            f"write {meant.keyword}"
            if meant
            else "a statement is an assignment 'x := 1;' or a call 'f(x := 1);'",
        )

    def skip_line(self) -> None:
        """Step over the rest of the line, at least one token, but not beyond the end."""
        if self.kinds[self.at] != "end":
            self.at += 1
        while self.kinds[self.at] != "end" and not self.starts_line(self.at):
            self.at += 1

    def _refusal(self, name: str, first: int) -> Unexpected | None:
        """The refusal of a statement that begins with this name, if it is one to be refused."""
        word = name.upper()
        if word in _CHART:
            refusal = self.unread(
                "a sequential function chart",
                self.token_span(first),
                "write the steps as a CASE over a step number",
            )
            self._go_to_end_of_body()
        elif word in _LIST and self.kinds[self.at] in ("name", "literal", "address"):
            refusal = self.unread(
                "an instruction list", self.token_span(first), "write the block in structured text"
            )
            self._go_to_end_of_body()
        else:
            return None
        self._last_finding_at = self.at
        return refusal

    def _go_to_end_of_body(self) -> None:
        while self.kinds[self.at] not in _BODY_ENDS:
            self.at += 1
