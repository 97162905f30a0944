"""A trace as columns of numbers, for the timing diagram of the HTML report.

A hundred thousand events are to fit into a page that a mail can carry: times are differences to the
event before, texts are numbers of a list, and a column that says nothing is left out. What reads it
is `page/trace.js`; both sides name the same keys.
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from math import isfinite, isnan

from harness.report.texts import Texts
from harness.trace import Change, Channel, Frame, Mark, Place, Telegram, Trace, TraceWord
from harness.trace.model import TraceValue

_EXACT = 1 << 53
"""Up to here the page's numbers are exact; larger ones travel as texts."""
_NONE = -1


def trace_columns(trace: Trace) -> dict[str, object]:
    """The trace as plain data."""
    texts = Texts()
    changes: list[list[Change]] = [[] for _ in trace.channels]
    for change in trace.changes:
        changes[change.channel].append(change)
    words = {word.name: number for number, word in enumerate(trace.words)}
    return {
        "title": trace.title,
        "start": trace.start_ns,
        "end": trace.end_ns,
        "writers": trace.writers,
        "words": [_word(word) for word in trace.words],
        "places": [_place(place, texts) for place in trace.places],
        "channels": [
            _channel(channel, found, words, texts)
            for channel, found in zip(trace.channels, changes, strict=True)
        ],
        "frames": _frames(trace.frames, texts),
        "telegrams": _telegrams(trace.telegrams, texts),
        "marks": [_mark(mark) for mark in trace.marks],
        "texts": texts.found,
    }


def _word(word: TraceWord) -> list[object]:
    return [
        word.title,
        [
            [item.name, item.title, item.low, item.high]
            + ([{str(value): text for value, text in item.meanings.items()}] * bool(item.meanings))
            for item in word.fields
        ],
    ]


def _place(place: Place, texts: Texts) -> list[object]:
    number = texts.number
    return [
        *(number(place.file), place.line, place.column),
        *(number(place.text), number(place.block), number(place.instance)),
    ]


def _channel(
    channel: Channel, changes: Sequence[Change], words: dict[str, int], texts: Texts
) -> dict[str, object]:
    values = [change.value for change in changes]
    written: list[object] = [channel.path, channel.title, channel.kind, channel.group]
    written += [channel.owner, channel.unit, words.get(channel.word or "", _NONE)]
    data: dict[str, object] = {"is": written, "t": _differences(c.time_ns for c in changes)}
    if any(_needs_text(value) for value in values):
        data["s"] = [texts.number(_as_text(value)) for value in values]
    else:
        data["v"] = [int(value) if isinstance(value, bool) else value for value in values]
    if any(change.writer is not None for change in changes):
        data["w"] = [_NONE if change.writer is None else change.writer for change in changes]
    return data


def _needs_text(value: TraceValue) -> bool:
    if isinstance(value, float):
        return not isfinite(value)
    return isinstance(value, (str, bytes)) or abs(value) > _EXACT


def _as_text(value: TraceValue) -> str:
    if isinstance(value, float) and not isfinite(value):
        return "NaN" if isnan(value) else "Infinity" if value > 0 else "-Infinity"
    return value.hex(" ").upper() if isinstance(value, bytes) else str(value)


def _differences(times: Iterable[int]) -> list[int]:
    return [later - earlier for earlier, later in pairwise((0, *times))]


def _frames(frames: Sequence[Frame], texts: Texts) -> dict[str, object]:
    number = texts.number
    return {
        "t": _differences(frame.start_ns for frame in frames),
        "d": [frame.end_ns - frame.start_ns for frame in frames],
        "line": [number(frame.line) for frame in frames],
        "from": [_NONE if frame.sender is None else number(frame.sender) for frame in frames],
        "down": [int(frame.to_drives) for frame in frames],
        "kind": [number(frame.kind) for frame in frames],
        "data": [number(_as_text(frame.data)) for frame in frames],
        "heard": [
            _NONE if frame.heard is None else number(_as_text(frame.heard)) for frame in frames
        ],
        "hurt": [int(frame.damaged) + 2 * int(frame.collided) for frame in frames],
        "says": [number(frame.meaning) for frame in frames],
        "id": [_NONE if frame.identifier is None else frame.identifier for frame in frames],
    }


def _telegrams(telegrams: Sequence[Telegram], texts: Texts) -> dict[str, object]:
    number = texts.number
    return {
        "t": _differences(item.sent_ns for item in telegrams),
        "d": [
            _NONE if item.received_ns is None else item.received_ns - item.sent_ns
            for item in telegrams
        ],
        "gateway": [number(item.gateway) for item in telegrams],
        "out": [number(_as_text(item.output)) for item in telegrams],
        "in": [_NONE if item.input is None else number(_as_text(item.input)) for item in telegrams],
        "says": [number(item.meaning) for item in telegrams],
        "w": [_NONE if item.writer is None else item.writer for item in telegrams],
    }


def _mark(mark: Mark) -> list[object]:
    return [
        *(mark.start_ns, mark.end_ns, mark.kind, mark.title, mark.target),
        *(_NONE if mark.place is None else mark.place, mark.verdict),
    ]
