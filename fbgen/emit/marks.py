"""Origin marks in a rendered text: which template line or catalogue entry each piece came from.

`fbgen.lang.origins` defines the marks and takes them out again.
"""

import re

from fbgen.lang.origins import END, START, mark, strip_marks
from fbgen.source import Origin, Source

_MARK = re.compile(f"{START}([0-9]*){END}")
_LONGEST_INDEX = 9


class OriginTable:
    """The origins of one generator run, each with its index."""

    def __init__(self) -> None:
        self._origins: list[Origin] = []
        self._indices: dict[Origin, int] = {}
        self._seen: dict[int, tuple[Origin, int]] = {}
        self._lines: set[int] = set()

    def line_mark(self, origin: Origin) -> str:
        """The mark of a template line."""
        index = self._index(origin)
        self._lines.add(index)
        return mark(index)

    def marked(self, text: str, origin: Origin | None) -> str:
        """A text between the mark of its origin and a mark of its end."""
        return f"{mark(self._index(origin))}{text}{mark(None)}" if origin is not None else text

    def source(self, name: str, marked: str) -> Source:
        """The clean text with its origins; behind a value its template line goes on.

        A mark that a template made up itself counts as the end of a value.
        """
        line = ""

        def back_to_line(found: re.Match[str]) -> str:
            nonlocal line
            if len(found[1]) > _LONGEST_INDEX or int(found[1] or 0) >= len(self._origins):
                return line
            if found[1] and int(found[1]) in self._lines:
                line = found[0]
            return found[0] if found[1] else line

        text, origins = strip_marks(_MARK.sub(back_to_line, marked), self._origins)
        return Source(name, text, origins)

    def _index(self, origin: Origin) -> int:
        seen = self._seen.get(id(origin))
        if seen is not None:
            return seen[1]
        index = self._indices.get(origin)
        if index is None:
            index = self._indices[origin] = len(self._origins)
            self._origins.append(origin)
        self._seen[id(origin)] = (origin, index)
        return index


def without_marks(text: str) -> str:
    """A user's text with the characters of marks replaced, so that it cannot forge one."""
    return text.replace(START, "?").replace(END, "?")


def is_marked(text: str) -> bool:
    """Whether a text was rendered already, as what a macro returns."""
    return START in text
