"""What a run has shown of the handshake of a gateway, as data: bits, numbers and frames in time."""

from fbgen.dataclass import dataclass
from fbgen.docs.drawing import Box, Drawing, Label, Line, Shape

_LEFT, _WIDTH, _ROW, _HIGH, _TOP = 172.0, 760.0, 34.0, 18.0, 12.0


@dataclass(frozen=True, slots=True)
class Signal:
    """A number of so many bits from one change to the next; the first is at the beginning."""

    title: str
    bits: int
    changes: tuple[tuple[float, int], ...]


@dataclass(frozen=True, slots=True)
class FrameTime:
    """Bytes on the line of the inverters, with what they say."""

    start_ms: float
    end_ms: float
    text: str


@dataclass(frozen=True, slots=True)
class Handshake:
    """A piece of a run; times are milliseconds from `begin_ms`, which is 0 of the picture."""

    gateway: str
    plant: str
    text: str
    duration_ms: float
    signals: tuple[Signal, ...]
    frames: tuple[FrameTime, ...]


def handshake_picture(seen: Handshake) -> Drawing:
    """One row for each signal, the frames below, one axis of time for all."""
    scale = _WIDTH / seen.duration_ms
    rows = len(seen.signals) + bool(seen.frames)
    bottom = _TOP + _ROW * rows
    shapes: list[Shape] = []
    step = _tick(seen.duration_ms)
    for tick in range(int(seen.duration_ms // step) + 1):
        x = _LEFT + tick * step * scale
        shapes.append(Line(((x, _TOP), (x, bottom + 4)), "line", 0.8))
        shapes.append(Label(x, bottom + 17, f"{tick * step:g}", 10, "middle", "muted"))
    shapes.append(Label(_LEFT + _WIDTH, bottom + 31, "ms", 10, "end", "muted"))
    for row, signal in enumerate(seen.signals):
        y = _TOP + _ROW * row + _HIGH + 7
        shapes.append(Label(_LEFT - 10, y - 5, signal.title, 11, "end", fixed=True))
        shapes += _wave(signal, y, scale, seen.duration_ms)
    if seen.frames:
        y = _TOP + _ROW * len(seen.signals) + 5
        shapes.append(Label(_LEFT - 10, y + 15, "line of the inverters", 11, "end"))
        for number, frame in enumerate(seen.frames, start=1):
            x, width = _LEFT + frame.start_ms * scale, (frame.end_ms - frame.start_ms) * scale
            shapes.append(Box(x, y, max(width, 14), _HIGH + 4, "fill", "accent", 3))
            shapes.append(Label(x + max(width, 14) / 2, y + 15, str(number), 11, "middle"))
    return Drawing(_LEFT + _WIDTH + 14, bottom + 38, tuple(shapes))


def _wave(signal: Signal, y: float, scale: float, end: float) -> list[Shape]:
    """A bit as a line that is high or low, a number as boxes."""
    ends = [*(time for time, _ in signal.changes[1:]), end]
    pieces = [
        (begin, last, value) for (begin, value), last in zip(signal.changes, ends, strict=True)
    ]
    if signal.bits > 1:
        found: list[Shape] = []
        for begin, last, value in pieces:
            x, width = _LEFT + begin * scale, (last - begin) * scale
            found.append(Box(x, y - _HIGH, width, _HIGH, "panel", "accent"))
            text = f"{value:0{signal.bits // 4}X}"
            if width > 8 * len(text) + 4:
                found.append(Label(x + width / 2, y - 5, text, 10.5, "middle", fixed=True))
        return found
    points: list[tuple[float, float]] = []
    for begin, last, value in pieces:
        level = y - _HIGH if value else y
        points += [(_LEFT + begin * scale, level), (_LEFT + last * scale, level)]
    return [Line(tuple(points), "accent", 1.6)]


def _tick(duration: float) -> float:
    """A round step that gives at most 12 of them."""
    return next(step for step in (1, 2, 5, 10, 20, 50, 100, 200, 500) if duration / step <= 12)
