"""A trace for wave viewers: a Value Change Dump (IEEE 1364) with one nanosecond a step.

Every channel is a signal under the parts of its path. Beside them there are, for each line, who
sends now and what it says, and for the scenario the step and the faults. Texts are of the type
`string`, which GTKWave and Surfer know; an empty text is shown as `-`.
"""

from collections.abc import Iterator
from importlib.util import find_spec
from io import StringIO
from typing import NamedTuple, TypeAlias

from fbgen.diagnostics import error
from harness.trace.model import Channel, Trace, TraceValue

_NOTHING = "-"
_INTEGER_BITS = 64
_SignalValue: TypeAlias = bool | int | float | str


class _Signal(NamedTuple):
    scopes: tuple[str, ...]
    name: str
    kind: str
    bits: int
    first: _SignalValue


class _Event(NamedTuple):
    time_ns: int
    signal: int
    value: _SignalValue


def vcd_text(trace: Trace) -> str:
    """The dump of a trace. Raises DiagnosticError FB8041 as `need_pyvcd`."""
    need_pyvcd()
    from vcd import VCDWriter  # noqa: PLC0415 - an extra of fbgen

    signals, events = _Signals(trace).everything()
    file = StringIO()
    with VCDWriter(
        file,
        timescale="1 ns",
        date="",
        version="fbgen",
        comment=_shown(trace.title),
        init_timestamp=trace.start_ns,
    ) as writer:
        variables = [
            writer.register_var(one.scopes, one.name, one.kind, one.bits or None, one.first)
            for one in signals
        ]
        for event in events:
            writer.change(variables[event.signal], event.time_ns, event.value)
        writer.close(trace.end_ns)
    return file.getvalue()


def need_pyvcd() -> None:
    """Raises DiagnosticError FB8041 if the package pyvcd is not there."""
    if find_spec("vcd") is None:
        raise error(
            "FB8041",
            "a VCD file is written with the package pyvcd, which is not installed",
            None,
            "pip install 'fbgen[reports]'",
        )


class _Signals:
    """The signals of a trace and what happens to them, in the order of time."""

    def __init__(self, trace: Trace) -> None:
        self._trace = trace
        self._signals: list[_Signal] = []
        self._taken: set[tuple[tuple[str, ...], str]] = set()

    def everything(self) -> tuple[list[_Signal], list[_Event]]:
        events = [*self._channels(), *self._lines(), *self._scenario()]
        return self._signals, sorted(events, key=lambda event: event.time_ns)

    def _add(self, path: list[str], kind: str, bits: int, first: _SignalValue) -> int:
        names = [_name(part) for part in path]
        scopes, name = tuple(names[:-1]), names[-1]
        while (scopes, name) in self._taken:
            name += "_"
        self._taken.add((scopes, name))
        self._signals.append(_Signal(scopes, name, kind, bits, first))
        return len(self._signals) - 1

    def _channels(self) -> Iterator[_Event]:
        trace = self._trace
        longest = _longest(trace)
        first: dict[int, TraceValue] = {}
        for change in trace.changes:
            first.setdefault(change.channel, change.value)
        numbers: dict[int, int] = {}
        for number, channel in enumerate(trace.channels):
            if number in first:
                kind, bits = _type(channel, longest.get(number, 0))
                value = _value(first[number])
                numbers[number] = self._add(_parts(channel.path), kind, bits, value)
        for change in trace.changes:
            yield _Event(change.time_ns, numbers[change.channel], _value(change.value))

    def _lines(self) -> Iterator[_Event]:
        lines = dict.fromkeys(frame.line for frame in self._trace.frames)
        for line in lines:
            numbers = {
                True: self._add(["line", line, "to_drives"], "wire", 1, False),
                False: self._add(["line", line, "to_gateway"], "wire", 1, False),
            }
            meaning = self._add(["line", line, "frame"], "string", 0, _NOTHING)
            for frame in self._trace.frames:
                if frame.line == line:
                    text = frame.meaning or frame.data.hex(" ").upper()
                    yield _Event(frame.start_ns, numbers[frame.to_drives], True)
                    yield _Event(frame.start_ns, meaning, _shown(text))
                    yield _Event(frame.end_ns, numbers[frame.to_drives], False)
                    yield _Event(frame.end_ns, meaning, _NOTHING)

    def _scenario(self) -> Iterator[_Event]:
        marks = self._trace.marks
        if any(mark.kind == "step" for mark in marks):
            step = self._add(["scenario", "step"], "string", 0, _NOTHING)
            for mark in marks:
                if mark.kind == "step":
                    yield _Event(mark.start_ns, step, _shown(mark.title))
        faults = dict.fromkeys((m.title, m.target) for m in marks if m.kind == "fault")
        for title, target in faults:
            name = f"{title}_{target}" if target else title
            fault = self._add(["scenario", "fault", name], "wire", 1, False)
            for mark in marks:
                if mark.kind == "fault" and (mark.title, mark.target) == (title, target):
                    yield _Event(mark.start_ns, fault, True)
                    if mark.end_ns is not None:
                        yield _Event(mark.end_ns, fault, False)


def _parts(path: str) -> list[str]:
    return path.replace('"', "").split(".")


def _name(part: str) -> str:
    """A name without what ends one in the file."""
    return "".join(char if "!" <= char <= "~" else "_" for char in part)


def _type(channel: Channel, longest: int) -> tuple[str, int]:
    match channel.kind:
        case "bool":
            return "wire", 1
        case "word":
            return "wire", channel.bits
        case "integer":
            return "integer", _INTEGER_BITS
        case "real":
            return "real", 0
        case "text":
            return "string", 0
        case "bytes":
            return "wire", 8 * max(longest, 1)


def _longest(trace: Trace) -> dict[int, int]:
    """Of each channel with bytes the most that it has had."""
    longest: dict[int, int] = {}
    for change in trace.changes:
        if isinstance(change.value, bytes):
            longest[change.channel] = max(longest.get(change.channel, 0), len(change.value))
    return longest


def _value(value: TraceValue) -> _SignalValue:
    if isinstance(value, bytes):
        return int.from_bytes(value, "big")
    return _shown(value) if isinstance(value, str) else value


def _shown(text: str) -> str:
    """A text as the file can have it: ASCII, and not empty."""
    return text.encode("ascii", "backslashreplace").decode() or _NOTHING
