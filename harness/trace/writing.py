"""Trace files (JSON Lines): written.

A line for each thing, in ASCII, with the keys in the order of `harness.trace.lines`; what happened
stands in the order of its time. So the same run gives the same file, byte for byte.
"""

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from heapq import merge
from math import isfinite, isnan
from typing import TypeAlias

from harness.trace.model import Change, Channel, Frame, Mark, Place, Telegram, Trace, TraceWord

FORMAT_VERSION = 1
_Timed: TypeAlias = tuple[int, str]
_encode = json.JSONEncoder(ensure_ascii=True, allow_nan=False, separators=(",", ":")).encode


def trace_lines(trace: Trace) -> Iterator[str]:
    """The lines of a trace, each with its end."""
    yield _line(
        type="trace",
        version=FORMAT_VERSION,
        title=trace.title,
        scenario=trace.scenario or None,
        seed=trace.seed,
        engine=trace.engine,
        dialect=trace.dialect,
        writers=trace.writers,
        start_ns=trace.start_ns,
        end_ns=trace.end_ns,
    )
    for word in trace.words:
        yield _word(word)
    for number, place in enumerate(trace.places):
        yield _place(number, place)
    for number, channel in enumerate(trace.channels):
        yield _channel(number, channel)
    kinds = [channel.kind for channel in trace.channels]
    happened = merge(
        ((mark.start_ns, _mark(mark)) for mark in trace.marks),
        _changes(trace.changes, kinds),
        ((telegram.sent_ns, _telegram(telegram)) for telegram in trace.telegrams),
        ((frame.start_ns, _frame(frame)) for frame in trace.frames),
        key=lambda timed: timed[0],
    )
    for _, line in happened:
        yield line


def trace_text(traces: Iterable[Trace]) -> str:
    """A trace file with these runs, one behind the other."""
    return "".join(line for trace in traces for line in trace_lines(trace))


def _line(**values: object) -> str:
    return _encode({key: value for key, value in values.items() if value is not None}) + "\n"


def _word(word: TraceWord) -> str:
    fields = [
        {"name": item.name, "title": item.title, "low": item.low, "high": item.high}
        | ({"meanings": _meanings(item.meanings)} if item.meanings else {})
        for item in word.fields
    ]
    return _line(type="word", name=word.name, title=word.title, fields=fields)


def _meanings(meanings: Mapping[int, str]) -> dict[str, str]:
    return {str(value): meaning for value, meaning in meanings.items()}


def _place(number: int, place: Place) -> str:
    return _line(
        type="place",
        id=number,
        file=place.file,
        line=place.line,
        column=place.column,
        text=place.text,
        block=place.block or None,
        instance=place.instance or None,
    )


def _channel(number: int, channel: Channel) -> str:
    return _line(
        type="channel",
        id=number,
        path=channel.path,
        title=channel.title,
        kind=channel.kind,
        group=channel.group,
        owner=channel.owner or None,
        unit=channel.unit or None,
        bits=channel.bits or None,
        word=channel.word,
    )


def _changes(changes: Iterable[Change], kinds: Sequence[str]) -> Iterator[_Timed]:
    """By far the most lines: put together by hand, with the encoder for texts only."""
    for change in changes:
        value = change.value
        kind = kinds[change.channel]
        if kind == "bool":
            shown = "true" if value else "false"
        elif isinstance(value, float):
            shown = repr(value) if isfinite(value) else f'"{_not_finite(value)}"'
        elif isinstance(value, bytes):
            shown = f'"{octets(value)}"'
        else:
            shown = _encode(value)
        writer = "" if change.writer is None else f',"w":{change.writer}'
        line = f'{{"type":"change","t":{change.time_ns},"c":{change.channel},"v":{shown}{writer}}}'
        yield change.time_ns, line + "\n"


def _not_finite(value: float) -> str:
    if isnan(value):
        return "NaN"
    return "Infinity" if value > 0 else "-Infinity"


def octets(data: bytes) -> str:
    """Bytes as the file has them."""
    return data.hex(" ").upper()


def _frame(frame: Frame) -> str:
    return _line(
        type="frame",
        t=frame.start_ns,
        end_ns=frame.end_ns,
        line=frame.line,
        sender=frame.sender,
        to_drives=frame.to_drives,
        kind=frame.kind,
        identifier=frame.identifier,
        data=octets(frame.data),
        heard=None if frame.heard is None else octets(frame.heard),
        damaged=frame.damaged or None,
        collided=frame.collided or None,
        meaning=frame.meaning or None,
    )


def _telegram(telegram: Telegram) -> str:
    return _line(
        type="telegram",
        t=telegram.sent_ns,
        gateway=telegram.gateway,
        output=octets(telegram.output),
        received_ns=telegram.received_ns,
        input=None if telegram.input is None else octets(telegram.input),
        meaning=telegram.meaning or None,
        w=telegram.writer,
    )


def _mark(mark: Mark) -> str:
    return _line(
        type="mark",
        t=mark.start_ns,
        end_ns=mark.end_ns,
        kind=mark.kind,
        title=mark.title,
        target=mark.target or None,
        place=mark.place,
        verdict=mark.verdict,
    )
