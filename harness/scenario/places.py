"""Places in scenario files, for findings."""

from collections.abc import Iterable
from dataclasses import replace

from fbgen.catalog import Located
from fbgen.diagnostics import Diagnostic
from fbgen.source import Span


def value_span(model: Located, field: str, key: str) -> Span | None:
    """Where the value of a key of a mapping stands."""
    return model.item_span_of(field, key)


def key_span(model: Located, field: str, key: str) -> Span | None:
    """Where a key of a mapping stands: the last time that it is written before its value."""
    value = model.item_span_of(field, key)
    if value is None:
        return None
    start = value.source.text.rfind(key, 0, value.start)
    return Span(value.source, start, start + len(key)) if start >= 0 else value


def at(span: Span | None, found: Iterable[Diagnostic]) -> list[Diagnostic]:
    """Findings of parts that know nothing of the file, at their place in it."""
    return [item if span is None else replace(item, span=span) for item in found]
