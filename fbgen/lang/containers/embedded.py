"""Code that is taken out of a file of another kind, and still knows its lines and columns there.

text = Assembly("pump.TcPOU", container)
text.add_content(element)        # what the element holds, with entities and CDATA resolved
text.add("\\nEND_METHOD\\n")       # what the container says in another way
source = text.source()
"""

import re
from bisect import bisect_right
from collections.abc import Iterable
from dataclasses import field
from typing import TYPE_CHECKING

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.source import Source

if TYPE_CHECKING:
    from fbgen.lang.containers.xml_tree import Element

_CONTENT = re.compile(
    r"<!\[CDATA\[(.*?)\]\]>|<!--.*?-->|<\?.*?\?>|&(#[0-9]+|#x[0-9A-Fa-f]+|\w+);|([^<&]+)|<[^>]*>",
    re.DOTALL,
)
_ENTITIES = {"lt": "<", "gt": ">", "amp": "&", "quot": '"', "apos": "'"}


@dataclass(frozen=True, eq=False)
class EmbeddedSource(Source):
    """A text whose pieces come from a container; places are shown there.

    `pieces` holds (offset here, offset there, step) in ascending order: from that offset on, each
    character here is `step` characters there: 1, or 0 for what the container only implies.
    """

    container: Source = field(default_factory=lambda: Source("", ""), repr=False)
    pieces: tuple[tuple[int, int, int], ...] = field(default=(), repr=False)

    def container_offset(self, offset: int) -> int:
        """Where a character of this text stands in the container."""
        index = bisect_right(self.pieces, offset, key=lambda piece: piece[0]) - 1
        if index < 0:
            return 0
        here, there, step = self.pieces[index]
        return min(there + (offset - here) * step, len(self.container.text))

    def line_column(self, offset: int) -> tuple[int, int]:
        """1-based line and column in the container."""
        return self.container.line_column(self.container_offset(offset))

    def line_text(self, line: int) -> str:
        """A line of the container."""
        return self.container.line_text(line)


class Assembly:
    """Puts a text together."""

    def __init__(self, container: Source) -> None:
        self._container = container
        self._texts: list[str] = []
        self._pieces: list[tuple[int, int, int]] = []
        self._length = 0
        self._there = 0

    def add(self, text: str, there: int | None = None) -> None:
        """A text that stands in the container at `there`, or that only the container implies."""
        step = 0 if there is None else 1
        self._there = self._there if there is None else there
        self._pieces.append((self._length, self._there, step))
        self._texts.append(text)
        self._length += len(text)
        self._there += len(text) * step

    def add_at(self, text: str, there: int) -> None:
        """A text that only the container implies, by something that stands at `there`."""
        self._there = there
        self.add(text)

    def add_content(self, element: "Element") -> None:
        """What stands between the tags of an element without children."""
        for piece in _CONTENT.finditer(element.raw):
            at = element.inner_start + piece.start()
            if piece[1] is not None:
                self.add(piece[1], at + len("<![CDATA["))
            elif piece[2] is not None:
                self.add(_character(piece[2]), at)
                self._there = element.inner_start + piece.end()
            elif piece[3] is not None:
                self.add(piece[3], at)

    def add_attribute(self, element: "Element", name: str) -> None:
        """The value of an attribute."""
        self.add(element.get(name), _place_of_attribute(element, name))

    def source(self) -> EmbeddedSource:
        """The text with its places."""
        name, text = self._container.name, "".join(self._texts)
        return EmbeddedSource(name, text, (), self._container, tuple(self._pieces))


def content(element: "Element") -> str:
    """What stands between the tags of an element without children."""
    assembly = Assembly(element.source)
    assembly.add_content(element)
    return assembly.source().text


def _character(entity: str) -> str:
    if entity.startswith("#"):
        digits, base = (entity[2:], 16) if entity[1] in "xX" else (entity[1:], 10)
        return chr(int(digits, base))
    return _ENTITIES[entity]


def _place_of_attribute(element: "Element", name: str) -> int:
    tag = element.source.text[element.start : element.inner_start]
    match = re.search(rf"\s(?:[\w.-]+:)?{re.escape(name)}\s*=\s*[\"']", tag)
    return element.start + (match.end() if match else 0)


def in_order(findings: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    """Findings as they stand in the container, those without a place in front."""
    return tuple(sorted(findings, key=_line_column))


def _line_column(finding: Diagnostic) -> tuple[int, int]:
    return (finding.span.line, finding.span.column) if finding.span else (0, 0)
