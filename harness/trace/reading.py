"""Trace files (JSON Lines): read back, checked line by line."""

from collections.abc import Iterator, Sequence
from dataclasses import field
from math import inf, nan
from typing import NoReturn

from pydantic import ValidationError

from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.source import Source, Span
from harness.trace.lines import (
    ChangeLine,
    ChannelLine,
    FrameLine,
    Line,
    MarkLine,
    PlaceLine,
    TelegramLine,
    TraceFileLine,
    TraceLine,
    WordLine,
)
from harness.trace.model import (
    Change,
    Channel,
    Frame,
    Mark,
    Place,
    Telegram,
    Trace,
    TraceValue,
    TraceWord,
    WordField,
)

_NOT_FINITE = {"NaN": nan, "Infinity": inf, "-Infinity": -inf}


def read_traces(source: Source) -> Iterator[Trace]:
    """The runs of a trace file, in their order.

    Raises DiagnosticError FB8040 at the first line that is none of a trace.
    """
    run: _Run | None = None
    offset = 0
    for text in source.text.splitlines(keepends=True):
        span = Span(source, offset, offset + len(text.rstrip()))
        offset += len(text)
        if not text.strip():
            continue
        line = _parsed(text, span)
        if isinstance(line, TraceLine):
            if run is not None:
                yield run.trace()
            run = _Run(line)
        elif run is None:
            raise _wrong(f"a {line.type} line stands before the first trace line", span)
        else:
            run.add(line, span)
    if run is not None:
        yield run.trace()


def _parsed(text: str, span: Span) -> Line:
    try:
        return TraceFileLine.model_validate_json(text).root
    except ValidationError as wrong:
        first = wrong.errors(include_url=False, include_context=False)[0]
        where = ".".join(str(part) for part in first["loc"][1:])
        message = first["msg"][:1].lower() + first["msg"][1:]
        _raise(f"{where}: {message}" if where else message, span)


def _wrong(message: str, span: Span) -> DiagnosticError:
    advice = "docs/reference/trace.md and schemas/trace.schema.json say what a line can be"
    return error("FB8040", f"this is no line of a trace: {message}", span, advice)


def _raise(message: str, span: Span) -> NoReturn:
    raise _wrong(message, span) from None


@dataclass(slots=True)
class _Run:
    """A run while its lines come in."""

    head: TraceLine
    words: list[TraceWord] = field(default_factory=list)
    places: list[Place] = field(default_factory=list)
    channels: list[Channel] = field(default_factory=list)
    changes: list[Change] = field(default_factory=list)
    frames: list[Frame] = field(default_factory=list)
    telegrams: list[Telegram] = field(default_factory=list)
    marks: list[Mark] = field(default_factory=list)

    def add(self, line: Line, span: Span) -> None:
        """The next line, which is none that begins a run."""
        match line:
            case ChangeLine():
                _known(line.c, self.channels, "channel", span)
                _known(line.w, self.places, "place", span)
                value = _value(line.v, self.channels[line.c], span)
                self.changes.append(Change(line.t, line.c, value, line.w))
            case FrameLine():
                self.frames.append(_frame(line))
            case TelegramLine():
                _known(line.w, self.places, "place", span)
                self.telegrams.append(_telegram(line))
            case MarkLine():
                _known(line.place, self.places, "place", span)
                self.marks.append(
                    Mark(
                        *(line.t, line.kind, line.title, line.end_ns),
                        *(line.target, line.place, line.verdict),
                    )
                )
            case WordLine():
                self.words.append(_word(line))
            case PlaceLine():
                _in_order(line.id, self.places, "place", span)
                self.places.append(
                    Place(
                        *(line.file, line.line, line.column, line.text),
                        *(line.block, line.instance),
                    )
                )
            case ChannelLine():
                _in_order(line.id, self.channels, "channel", span)
                self.channels.append(
                    Channel(
                        *(line.path, line.title, line.kind, line.group),
                        *(line.owner, line.unit, line.bits, line.word),
                    )
                )

    def trace(self) -> Trace:
        """The run, complete."""
        head = self.head
        return Trace(
            head.title,
            head.scenario,
            head.seed,
            head.engine,
            head.dialect,
            head.writers,
            head.start_ns,
            head.end_ns,
            tuple(self.words),
            tuple(self.places),
            tuple(self.channels),
            tuple(self.changes),
            tuple(self.frames),
            tuple(self.telegrams),
            tuple(self.marks),
        )


def _known(number: int | None, known: Sequence[object], what: str, span: Span) -> None:
    if number is not None and number >= len(known):
        raise _wrong(f"there is no {what} {number} before it", span)


def _in_order(number: int, known: Sequence[object], what: str, span: Span) -> None:
    if number != len(known):
        raise _wrong(f"{what} {number} stands where {what} {len(known)} belongs", span)


def _value(value: bool | int | float | str, channel: Channel, span: Span) -> TraceValue:
    match channel.kind, value:
        case ("bool", bool()) | ("text", str()):
            return value
        case ("word" | "integer", int()) if not isinstance(value, bool):
            return value
        case "real", (int() | float()) if not isinstance(value, bool):
            return float(value)
        case "real", str() if value in _NOT_FINITE:
            return _NOT_FINITE[value]
        case "bytes", str():
            try:
                return bytes.fromhex(value)
            except ValueError:
                pass
    raise _wrong(f"{channel.path} is of kind {channel.kind} and never {value!r}", span)


def _octets(text: str | None) -> bytes | None:
    return None if text is None else bytes.fromhex(text)


def _frame(line: FrameLine) -> Frame:
    return Frame(
        line.t,
        line.end_ns,
        line.line,
        line.sender,
        line.to_drives,
        line.kind,
        bytes.fromhex(line.data),
        _octets(line.heard),
        line.damaged,
        line.collided,
        line.meaning,
        line.identifier,
    )


def _telegram(line: TelegramLine) -> Telegram:
    return Telegram(
        line.t,
        line.gateway,
        bytes.fromhex(line.output),
        line.received_ns,
        _octets(line.input),
        line.meaning,
        line.w,
    )


def _word(line: WordLine) -> TraceWord:
    return TraceWord(
        line.name,
        line.title,
        tuple(
            WordField(
                *(item.name, item.title, item.low, item.high),
                {int(value): meaning for value, meaning in item.meanings.items()},
            )
            for item in line.fields
        ),
    )
