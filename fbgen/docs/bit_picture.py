"""A word as a row of 16 boxes with the names of its bits above or below."""

from fbgen.catalog import BitField, Word
from fbgen.docs.drawing import Box, Drawing, Label, Line, Shape

_CELL, _TOP, _HEIGHT, _STEP = 38.0, 8.0, 26.0, 15.0
_LEFT = 8.0
_LETTER = 7.0


def bit_picture(word: Word) -> Drawing:
    """The bits from 15 to 0; every name has a line of its own, so that none covers another."""
    fields = sorted(word.bits, key=lambda field: field.low)
    shapes: list[Shape] = []
    for bit in range(16):
        x = _x(bit)
        defined = word.defined >> bit & 1
        shapes.append(Box(x, _TOP, _CELL, _HEIGHT, "fill" if defined else "panel"))
        shapes.append(_number(bit, bool(defined)))
    bottom = _TOP + _HEIGHT
    for index, field in enumerate(fields):
        y = bottom + _STEP * (index + 1)
        shapes += _name(field, y, bottom)
    longest = max((len(_text(field)) for field in fields), default=0)
    width = _LEFT * 2 + _CELL * 16 + 10 + _LETTER * longest
    return Drawing(width, bottom + _STEP * (len(fields) + 1), tuple(shapes))


def _text(field: BitField) -> str:
    return f"{field.bit} {field.name}"


def _number(bit: int, defined: bool) -> Label:
    x = _x(bit) + _CELL / 2
    return Label(x, _TOP + 17, str(bit), 12, "middle", "ink" if defined else "muted", fixed=True)


def _name(field: BitField, y: float, bottom: float) -> list[Shape]:
    """A line down from the field's boxes, and to the right to its name."""
    left, right = _x(field.high), _x(field.low) + _CELL
    x = (left + right) / 2
    shapes: list[Shape] = []
    if field.high != field.low:
        shapes.append(Line(((left + 2, bottom + 3), (right - 2, bottom + 3)), "accent", 2))
    end = _LEFT + _CELL * 16 + 6
    shapes.append(Line(((x, bottom + 3), (x, y - 4), (end, y - 4)), "line"))
    shapes.append(Label(end + 4, y, _text(field), 11, colour="ink", fixed=True))
    return shapes


def _x(bit: int) -> float:
    return _LEFT + _CELL * (15 - bit)
