"""Texts and places in them. Lines and columns are worked out only when somebody asks."""

from bisect import bisect_right
from dataclasses import field
from functools import cached_property
from typing import NamedTuple

from fbgen.dataclass import dataclass

TEMPLATE = "template"
"""What the origin of a template line is called."""


@dataclass(frozen=True, slots=True)
class Origin:
    """Where a piece of generated text came from: a template line, or an entry of the catalogue.

    `what` names the thing for a person, `file` and `line` the place, `source` the manual section.
    A value that was worked out from several entries has the others as `inputs`.
    """

    what: str
    file: str
    line: int
    source: str = ""
    inputs: tuple["Origin", ...] = ()

    @property
    def is_template(self) -> bool:
        """Whether it is a line of a template, and no value."""
        return self.what is TEMPLATE or self.what == TEMPLATE


@dataclass(frozen=True, eq=False)
class Source:
    """One text with its name. Offsets count characters from 0, lines and columns from 1.

    `origins` holds (offset, origin) in ascending order of offset: from that offset on, the text
    comes from that origin. Empty for texts that a person wrote.
    """

    name: str
    text: str
    origins: tuple[tuple[int, Origin | None], ...] = field(default=(), repr=False)

    @cached_property
    def _line_starts(self) -> list[int]:
        starts = [0]
        starts.extend(i + 1 for i, char in enumerate(self.text) if char == "\n")
        return starts

    @cached_property
    def origin_offsets(self) -> list[int]:
        """From which offsets on the `origins` count."""
        return [offset for offset, _ in self.origins]

    def line_column(self, offset: int) -> tuple[int, int]:
        """1-based line and column of an offset."""
        line = bisect_right(self._line_starts, offset)
        return line, offset - self._line_starts[line - 1] + 1

    def line_text(self, line: int) -> str:
        """The text of a 1-based line without its end; empty beyond the last line."""
        if not 1 <= line <= len(self._line_starts):
            return ""
        start = self._line_starts[line - 1]
        end = self._line_starts[line] if line < len(self._line_starts) else len(self.text)
        return self.text[start:end].rstrip("\r\n")

    def origin_at(self, offset: int) -> Origin | None:
        """Where the character at `offset` came from, if the text was generated."""
        index = bisect_right(self.origin_offsets, offset)
        return self.origins[index - 1][1] if index else None


class Span(NamedTuple):
    """A piece of a source: characters `start` up to, not including, `end`."""

    source: Source
    start: int
    end: int

    @property
    def line(self) -> int:
        """1-based line of the first character."""
        return self.source.line_column(self.start)[0]

    @property
    def column(self) -> int:
        """1-based column of the first character."""
        return self.source.line_column(self.start)[1]

    @property
    def end_line(self) -> int:
        """1-based line behind the last character."""
        return self.source.line_column(self.end)[0]

    @property
    def end_column(self) -> int:
        """1-based column behind the last character."""
        return self.source.line_column(self.end)[1]

    @property
    def text(self) -> str:
        """The characters themselves."""
        return self.source.text[self.start : self.end]

    @property
    def origin(self) -> Origin | None:
        """Where the text came from, if it was generated."""
        return self.source.origin_at(self.start)

    def to(self, other: "Span") -> "Span":
        """From the start of this span to the end of the other, both in one source."""
        return Span(self.source, self.start, other.end)

    def __str__(self) -> str:
        return f"{self.source.name}:{self.line}:{self.column}"
