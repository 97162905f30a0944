"""Places in sources, each kept once and named by its number."""

from fbgen.source import Span
from harness.trace.model import Place


class Places:
    """The places that a trace refers to, in the order in which they were first named."""

    __slots__ = ("_numbers", "found")

    def __init__(self) -> None:
        self.found: list[Place] = []
        self._numbers: dict[Place, int] = {}

    def number(self, place: Place) -> int:
        """The number of a place."""
        number = self._numbers.setdefault(place, len(self.found))
        if number == len(self.found):
            self.found.append(place)
        return number

    def of(self, span: Span | None) -> int | None:
        """The number of the place where a span begins; None for none."""
        return None if span is None else self.number(place_of(span))


def place_of(span: Span, block: str = "", instance: str = "") -> Place:
    """Where a span begins, as data."""
    line = span.line
    text = span.source.line_text(line).strip()
    return Place(span.source.name, line, span.column, text, block, instance)
