"""Where printed lines are from: their line of the template, and the values that stand in them."""

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence

from fbgen.source import Origin, Span

LineOrigins = tuple[Origin, ...]
"""The line of the template first, then each value in its order. Empty for a text of a person."""

_WORD = re.compile(r"\w+")


def origins_of_lines(
    lines: Sequence[str], together: Sequence[int], places: Sequence[Span | None]
) -> tuple[LineOrigins, ...]:
    """Where each of the lines came from; `together` says how many have one place."""
    found: list[LineOrigins] = []
    for count in together:
        at = len(found)
        if count == 1:
            found.append(of_one_line(places[at]))
        else:
            found += line_origins(lines[at : at + count], places[at])
    return tuple(found)


def line_origins(lines: Sequence[str], place: Span | None) -> list[LineOrigins]:
    """The origins of lines that were printed together from one place.

    Of several lines each has the values whose text stands in it, and all those whose text stands in
    none, because the dialect spells it otherwise.
    """
    if place is None or not place.source.origins:
        return [() for _ in lines]
    if len(lines) == 1:
        return [of_one_line(place)]
    pieces = [(place.source.text[start:end], origin) for start, end, origin in _pieces(place)]
    values = [(text, origin) for text, origin in pieces if not origin.is_template]
    found: list[LineOrigins] = []
    for line, home in zip(lines, _homes(lines, pieces), strict=True):
        inside = (
            origin
            for text, origin in values
            if text in line or not any(text in other for other in lines)
        )
        found.append(_unique((*home, *inside)))
    return found


def values_in(place: Span) -> list[tuple[int, int]]:
    """Where the values in a place stand."""
    return [(start, end) for start, end, origin in _pieces(place) if not origin.is_template]


def of_one_line(place: Span | None) -> LineOrigins:
    """The first line of a template in the place, or the one in front of it, and all values."""
    if place is None or not place.source.origins:
        return ()
    origins = place.source.origins
    at = max(0, bisect_right(place.source.origin_offsets, place.start) - 1)
    values: list[Origin] = []
    template = origins[at][1]
    back = at
    while back and (template is None or not template.is_template):
        back -= 1
        template = origins[back][1]
    while at < len(origins) and (origins[at][0] < place.end or at == back):
        origin = origins[at][1]
        at += 1
        if origin is not None and not origin.is_template:
            values.append(origin)
        elif template is None:
            template = origin
    first = (template,) if template is not None and template.is_template else ()
    return _unique((*first, *values)) if values else first


def _pieces(place: Span) -> Iterator[tuple[int, int, Origin]]:
    """Where each piece of the place stands; in front of them the line of the template that the
    first one stands in, as an empty piece."""
    source = place.source
    origins = source.origins
    at = max(0, bisect_right(source.origin_offsets, place.start) - 1)
    back = at
    while back >= 0:
        origin = origins[back][1]
        if origin is not None and origin.is_template:
            yield place.start, place.start, origin
            break
        back -= 1
    while at < len(origins) and (origins[at][0] < place.end or at == back):
        start, origin = origins[at]
        end = origins[at + 1][0] if at + 1 < len(origins) else len(source.text)
        at += 1
        if origin is not None:
            yield max(start, place.start), min(end, max(place.end, start)), origin


def _homes(lines: Sequence[str], pieces: Sequence[tuple[str, Origin]]) -> Iterator[LineOrigins]:
    """The line of the template for each of the printed ones: the first one from the last one's on
    that has most words in common with it."""
    known: list[tuple[set[str], Origin]] = []
    for text, origin in pieces:
        if origin.is_template and not (known and known[-1][1] is origin):
            known.append((set(), origin))
        if known:
            known[-1][0].update(_WORD.findall(text))
    at = 0
    for line in lines:
        words = set(_WORD.findall(line))
        common = [len(words & theirs) for theirs, _ in known[at:]]
        best = max(common, default=0)
        if best:
            at += common.index(best)
        yield (known[at][1],) if known else ()


def _unique(origins: Iterable[Origin]) -> LineOrigins:
    return tuple(dict.fromkeys(origins))
