"""The cyclic data of a layout as two rows of bytes, out and in."""

from collections.abc import Iterator, Sequence

from fbgen.catalog import CyclicField, Layout
from fbgen.docs.drawing import Box, Drawing, Label, Shape

_BYTE, _ROW, _LEFT, _HEIGHT = 62.0, 74.0, 46.0, 34.0
_IN_A_LINE = 10
"""Bytes side by side; longer data go on in the next line."""


def frame_picture(layout: Layout) -> Drawing:
    """Fields as boxes with their names, offsets from 0 above them."""
    shapes: list[Shape] = []
    y = 8.0
    widest = 0
    for title, fields in (("out", layout.output), ("in", layout.input)):
        shapes.append(Label(4, y + 36, title, 12, strong=True))
        length = fields[-1].end if fields else 0
        widest = max(widest, min(length, _IN_A_LINE))
        shapes += _fields(fields, y)
        y += _ROW * max(1, -(-length // _IN_A_LINE))
    return Drawing(_LEFT + _BYTE * widest + 8, y, tuple(shapes))


def _fields(fields: Sequence[CyclicField], y: float) -> Iterator[Shape]:
    for field in fields:
        start = field.offset
        while start < field.end:
            line, column = divmod(start, _IN_A_LINE)
            count = min(field.end - start, _IN_A_LINE - column)
            yield from _part(field, start, count, _LEFT + _BYTE * column, y + _ROW * line)
            start += count


def _part(field: CyclicField, start: int, count: int, x: float, y: float) -> Iterator[Shape]:
    """As much of a field as is in one line."""
    width = _BYTE * count
    yield Box(x, y + 16, width, _HEIGHT, "panel" if field.pad else "fill")
    for index in range(count):
        place = x + _BYTE * index + _BYTE / 2
        yield Label(place, y + 12, str(start + index), 10, "middle", "muted", fixed=True)
    name = field.name if len(field.name) * 6.2 < width else field.name[: int(width / 6.2) - 1] + "."
    yield Label(x + width / 2, y + 16 + 21, name, 10.5, "middle", fixed=True)
