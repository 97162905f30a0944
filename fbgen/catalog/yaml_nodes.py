"""YAML text -> plain Python data that still knows where every key and value stands.

Used for the catalogue, plant files and scenario files. `fbgen.catalog.yaml_events` reads the text,
and is imported with PyYAML when there is one to read: what is kept from an earlier run needs
neither.
"""

from fbgen.dataclass import dataclass
from fbgen.source import Source, Span


class YamlInt(int):
    """An integer that remembers how it was written."""

    text: str


class YamlFloat(float):
    """A floating-point number that remembers how it was written."""

    text: str


class YamlMapping(dict[str, object]):
    """A mapping with the places of its keys and values."""

    __slots__ = ("key_spans", "span", "value_spans")

    def __init__(self, span: Span) -> None:
        super().__init__()
        self.span = span
        self.key_spans: dict[str, Span] = {}
        self.value_spans: dict[str, Span] = {}


class YamlSequence(list[object]):
    """A sequence with the places of its items."""

    __slots__ = ("item_spans", "span")

    def __init__(self, span: Span) -> None:
        super().__init__()
        self.span = span
        self.item_spans: list[Span] = []


@dataclass(frozen=True, slots=True)
class Document:
    """One YAML file: its text, its data and the place of the whole."""

    source: Source
    data: object
    span: Span


def load_yaml(source: Source) -> Document:
    """The data of one YAML text. Raises DiagnosticError with everything found in the text.

    FB1001 syntax, FB1002 limits, FB1003 not plain YAML, FB1004 duplicate keys.
    """
    from fbgen.catalog.yaml_events import read  # noqa: PLC0415 - see above

    return read(source)


def locate(document: Document, path: tuple[int | str, ...]) -> tuple[Span, object]:
    """The place and value under a path of keys and indexes.

    Steps that name nothing (such as the tag of a union) are passed over; a path that leads beyond
    the data ends at the last value that is there.
    """
    value, span = document.data, document.span
    for step in path:
        if isinstance(value, YamlMapping) and isinstance(step, str) and step in value:
            span = value.value_spans[step]
            value = value[step]
        elif isinstance(value, YamlSequence) and isinstance(step, int) and step < len(value):
            span = value.item_spans[step]
            value = value[step]
    return span, value
