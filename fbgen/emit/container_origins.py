"""Where the lines of an XML file are from: it is read again, and its tree laid beside the first."""

from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.containers import read_text
from fbgen.lang.printer.line_origins import LineOrigins, line_origins
from fbgen.lang.walk import side_by_side
from fbgen.source import Origin, Source, Span


def origins_of_lines(
    name: str, text: str, converted: Sequence[ast.File]
) -> tuple[LineOrigins, ...]:
    """The origins of each line of a file that was written from some of these trees.

    A line in the middle of something has the origins of what begins above it.
    """
    written = {_key(unit): unit for file in converted for unit in file.units}
    document = read_text(Source(name, text), converted[0].dialect, is_xml=True)
    starts: dict[int, list[tuple[int, Origin]]] = {}
    for unit in document.file.units:
        for node, original in side_by_side(unit, written.get(_key(unit))):
            place, source = _span(node), _span(original)
            if place is not None and source is not None:
                starts.setdefault(place.line, []).extend(
                    (place.start, origin)
                    for origins in line_origins(("",), source._replace(end=source.start + 1))
                    for origin in origins
                )
    found: list[LineOrigins] = []
    current: LineOrigins = ()
    for line in range(1, text.count("\n") + 1):
        if line in starts:
            known = sorted(starts[line], key=lambda item: item[0])
            templates = [origin for _, origin in known if origin.is_template][:1]
            values = (origin for _, origin in known if not origin.is_template)
            current = tuple(dict.fromkeys((*templates, *values)))
        found.append(current)
    return tuple(found)


def _key(unit: ast.Unit) -> tuple[str, str]:
    name = getattr(unit, "name", "")
    text = name if isinstance(name, str) else name.name
    if isinstance(unit, ast.Globals):  # a list has its name in the file only
        text = next((one.names[0].name for one in unit.section.declarations), "")
    return type(unit).__name__, text.casefold()


def _span(node: object) -> Span | None:
    span = getattr(node, "span", None)
    return span if isinstance(span, Span) else None
