"""Drawings as SVG inside a page; colours are classes, so that they follow day and night."""

from collections.abc import Iterator

from markupsafe import Markup

from fbgen.docs.drawing import PRINTED, Box, Drawing, Line, Shape


def svg(drawing: Drawing, title: str) -> Markup:
    """The picture; it shrinks with the page."""
    inner = Markup("").join(part for shape in drawing.shapes for part in _shape(shape))
    return Markup(
        '<svg class="drawing" role="img" aria-label="{}" viewBox="0 0 {} {}" width="{}">{}</svg>'
    ).format(title, _n(drawing.width), _n(drawing.height), _n(drawing.width), inner)


_STYLE = (
    "svg{font-family:Helvetica,Arial,sans-serif}.line{fill:none}.strong{font-weight:bold}"
    ".fixed{font-family:monospace}"
)


def svg_file(drawing: Drawing, title: str) -> bytes:
    """The picture as a file of its own, with the colours of the day on white."""
    style = _STYLE + "".join(
        f".s-{name}{{stroke:{value}}}.f-{name}{{fill:{value}}}.t-{name}{{fill:{value}}}"
        for name, value in PRINTED.items()
    )
    head = Markup('<svg xmlns="http://www.w3.org/2000/svg"')
    whole = svg(drawing, title).replace(Markup("<svg"), head, 1)
    begin, end = whole.split(">", 1)
    return f"{begin}><style>{style}</style>{end}\n".encode()


def _shape(shape: Shape) -> Iterator[Markup]:
    if isinstance(shape, Box):
        yield Markup(
            '<rect class="f-{} s-{}" x="{}" y="{}" width="{}" height="{}" rx="{}"/>'
        ).format(
            shape.fill,
            shape.edge,
            *map(_n, (shape.x, shape.y, shape.width, shape.height, shape.round)),
        )
    elif isinstance(shape, Line):
        points = " ".join(f"{_n(x)},{_n(y)}" for x, y in shape.points)
        dashes = Markup(' stroke-dasharray="4 3"') if shape.dashed else ""
        yield Markup('<polyline class="line s-{}" points="{}" stroke-width="{}"{}/>').format(
            shape.colour, points, _n(shape.width), dashes
        )
        if shape.arrow:
            yield _head(shape)
    else:
        names = f"t-{shape.colour}{' fixed' if shape.fixed else ''}"
        names += " strong" if shape.strong else ""
        yield Markup(
            '<text class="{}" x="{}" y="{}" font-size="{}" text-anchor="{}">{}</text>'
        ).format(names, *map(_n, (shape.x, shape.y, shape.size)), shape.anchor, shape.text)


def _head(line: Line) -> Markup:
    """The tip of an arrow."""
    (x0, y0), (x, y) = line.points[-2], line.points[-1]
    length = ((x - x0) ** 2 + (y - y0) ** 2) ** 0.5 or 1.0
    ux, uy = (x - x0) / length, (y - y0) / length
    corners: tuple[tuple[float, float], ...] = ((x, y), (x - 7 * ux - 3 * uy, y - 7 * uy + 3 * ux))
    corners += ((x - 7 * ux + 3 * uy, y - 7 * uy - 3 * ux),)
    points = " ".join(f"{_n(px)},{_n(py)}" for px, py in corners)
    return Markup('<polygon class="f-{}" points="{}"/>').format(line.colour, points)


def _n(value: float) -> str:
    """A coordinate, to a tenth of a point."""
    return f"{value:.1f}".rstrip("0").rstrip(".")
