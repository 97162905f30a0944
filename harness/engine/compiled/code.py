"""Pieces of Python source while they are put together, and the text that they end in."""

from collections.abc import Iterable
from enum import IntEnum
from typing import NamedTuple

from fbgen.lang import checked
from fbgen.source import Span


class Level(IntEnum):
    """How tightly a piece holds together: Python's operator precedence, loosest first."""

    CONDITIONAL = 0
    OR = 1
    AND = 2
    NOT = 3
    COMPARISON = 4
    BIT_OR = 5
    BIT_XOR = 6
    BIT_AND = 7
    SHIFT = 8
    SUM = 9
    PRODUCT = 10
    SIGN = 11
    ATOM = 12


class Code(NamedTuple):
    """A Python expression.

    `low` and `high` enclose the value of a whole number. They may reach beyond the type: then the
    value is right in the lower bits only and has yet to be wrapped around. `depth` bounds how deep
    brackets and operators are nested. `safe` means that it can neither fail nor change anything,
    `pure` that it changes nothing, `simple` that it may be written twice at no cost.
    """

    text: str
    level: Level = Level.ATOM
    low: int = 0
    high: int = 0
    depth: int = 1
    safe: bool = True
    pure: bool = True
    simple: bool = False

    def at(self, level: Level) -> str:
        """The text, in parentheses if it would fall apart at this level."""
        return self.text if self.level >= level else f"({self.text})"

    def within(self, low: int, high: int) -> "Code":
        """The same piece, known to have a value from `low` to `high`."""
        return self._replace(low=low, high=high)


def deepest(codes: Iterable[Code]) -> int:
    """The greatest depth of several pieces."""
    return max((code.depth for code in codes), default=0)


class Site(NamedTuple):
    """A place in a generated line that may stop the program, and what it was in the PLC text.

    `text` is the failing Python expression, `node` what it stands for, `position` the Python text
    of the index in it where Python itself finds that it is too large.
    """

    text: str
    node: checked.Expression
    position: str = ""


class Listing:
    """Generated source, line by line, with the PLC text that each line came from.

    `reads` has, for the lines with sites, the places that stand in them with their Python text.
    """

    __slots__ = ("indent", "lines", "reads", "sites", "span", "spans")

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.spans: list[Span | None] = []
        self.sites: dict[int, list[Site]] = {}
        self.reads: dict[int, list[tuple[checked.Place, str]]] = {}
        self.indent = 0
        self.span: Span | None = None

    def add(self, text: str) -> None:
        """One more line at the present indentation, for the present `span`."""
        self.lines.append(" " * self.indent + text)
        self.spans.append(self.span)

    def note(self, sites: list[Site], reads: list[tuple[checked.Place, str]]) -> None:
        """The line that comes next may stop at one of these sites, with these places in it."""
        self.sites[len(self.lines) + 1] = sites
        self.reads[len(self.lines) + 1] = reads

    def append(self, other: "Listing") -> None:
        """All lines of another listing behind these, as they are."""
        offset = len(self.lines)
        self.lines += other.lines
        self.spans += other.spans
        self.sites.update({line + offset: sites for line, sites in other.sites.items()})
        self.reads.update({line + offset: reads for line, reads in other.reads.items()})

    @property
    def text(self) -> str:
        """The whole source."""
        return "\n".join(self.lines) + "\n"
