"""Pictures of lines, boxes and texts, in points; the origin is the upper left corner.

Colours are roles, which each format has its own colours for.
"""

from typing import Literal

from fbgen.dataclass import dataclass

Colour = Literal["ink", "muted", "line", "panel", "accent", "fill", "warning"]
Anchor = Literal["start", "middle", "end"]


@dataclass(frozen=True, slots=True)
class Line:
    """A line through points, with an arrow at its end if asked for."""

    points: tuple[tuple[float, float], ...]
    colour: Colour = "ink"
    width: float = 1.0
    arrow: bool = False
    dashed: bool = False


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle; `round` is the radius of its corners."""

    x: float
    y: float
    width: float
    height: float
    fill: Colour = "panel"
    edge: Colour = "line"
    round: float = 0.0


@dataclass(frozen=True, slots=True)
class Label:
    """A line of text; `y` is its base line."""

    x: float
    y: float
    text: str
    size: float = 11.0
    anchor: Anchor = "start"
    colour: Colour = "ink"
    fixed: bool = False
    strong: bool = False


Shape = Line | Box | Label


@dataclass(frozen=True, slots=True)
class Drawing:
    """A picture with its size."""

    width: float
    height: float
    shapes: tuple[Shape, ...]


PRINTED: dict[Colour, str] = {
    "ink": "#1c2530",
    "muted": "#566272",
    "line": "#b9c2cd",
    "panel": "#ffffff",
    "accent": "#0b56ad",
    "fill": "#dcebfb",
    "warning": "#fdeedd",
}
"""The colours on paper, for formats that do not follow day and night."""
