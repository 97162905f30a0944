"""Origin marks in a rendered text: which template line or catalogue entry each piece came from.

`fbgen.lang.origins` defines the marks and takes them out again.
"""

from fbgen.lang.origins import END, START, mark, strip_marks
from fbgen.source import TEMPLATE, Origin, Source


class TemplateLines:
    """The lines of templates with their marks: `t` and a number, the same in every run."""

    def __init__(self) -> None:
        self.origins: dict[str, Origin] = {}
        self._keys: dict[tuple[str, int], str] = {}

    def mark(self, place: str, number: int) -> str:
        """The mark of a line of a template."""
        key = self._keys.get((place, number))
        if key is None:
            key = self._keys[place, number] = f"t{len(self._keys)}"
            self.origins[key] = Origin(TEMPLATE, place, number)
        return mark(key)


class OriginTable:
    """The origins of one generator run: lines of templates, and values, each with its key."""

    def __init__(self, lines: TemplateLines) -> None:
        self._lines = lines
        self._known_lines = 0
        self._origins: dict[str, Origin] = {}
        self._keys: dict[Origin, str] = {}
        self._seen: dict[int, tuple[Origin, str]] = {}

    def marked(self, text: str, origin: Origin | None) -> str:
        """A text between the mark of its origin and a mark of its end."""
        return f"{self._mark(origin)}{text}{mark()}" if origin is not None else text

    def source(self, name: str, marked: str) -> Source:
        """The clean text with its origins; behind a value its template line goes on."""
        if len(self._lines.origins) > self._known_lines:
            self._origins |= self._lines.origins
            self._known_lines = len(self._lines.origins)
        text, origins = strip_marks(marked, self._origins)
        return Source(name, text, origins)

    def _mark(self, origin: Origin) -> str:
        seen = self._seen.get(id(origin))
        if seen is not None:
            return seen[1]
        key = self._keys.get(origin)
        if key is None:
            key = self._keys[origin] = str(len(self._keys))
            self._origins[key] = origin
        self._seen[id(origin)] = (origin, mark(key))
        return mark(key)


def without_marks(text: str) -> str:
    """A user's text with the characters of marks replaced, so that it cannot forge one."""
    return text.replace(START, "?").replace(END, "?")


def is_marked(text: str) -> bool:
    """Whether a text was rendered already, as what a macro returns."""
    return START in text
