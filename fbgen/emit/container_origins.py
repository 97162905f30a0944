"""Where the lines of an XML file are from: it is read again, and its tree laid beside the first."""

from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.containers import read_text
from fbgen.lang.walk import side_by_side
from fbgen.source import Origin, Source, Span


def origins_of_lines(
    name: str, text: str, converted: Sequence[ast.File]
) -> tuple[Origin | None, ...]:
    """One origin or None for each line of a file that was written from some of these trees.

    A line in the middle of something has the origin of what begins above it.
    """
    written = {_key(unit): unit for file in converted for unit in file.units}
    document = read_text(Source(name, text), converted[0].dialect, is_xml=True)
    first: dict[int, tuple[int, Origin | None]] = {}
    for unit in document.file.units:
        for node, original in side_by_side(unit, written.get(_key(unit))):
            place, source = _span(node), _span(original)
            if place is not None and source is not None:
                known = first.get(place.line)
                if known is None or place.start < known[0]:
                    first[place.line] = (place.start, source.origin)
    origins: list[Origin | None] = []
    current: Origin | None = None
    for line in range(1, text.count("\n") + 1):
        current = first.get(line, (0, current))[1] or current
        origins.append(current)
    return tuple(origins)


def _key(unit: ast.Unit) -> tuple[str, str]:
    name = getattr(unit, "name", "")
    text = name if isinstance(name, str) else name.name
    return type(unit).__name__, "" if isinstance(unit, ast.Globals) else text.casefold()


def _span(node: object) -> Span | None:
    span = getattr(node, "span", None)
    return span if isinstance(span, Span) else None
