"""Handshakes of gateways for the reference: from a run of the example plants, as plain data."""

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from fbgen.docs.handshake import FrameTime, Handshake, Signal

if TYPE_CHECKING:
    from fbgen.docs.program import PlantProgram
    from harness.trace import Frame, Trace

_MS = 1_000_000
_TELEGRAM_TEXT = (
    "The PLC posts a telegram: trigger and bit 14 of the control word change, the gateway sends "
    "the frame, the inverter answers, the status word acknowledges."
)
_CHANNEL_TEXT = (
    "A parameter is read: the number first, then the request, the response, and both back to idle."
)


def handshakes(programs: Iterable["PlantProgram"], gateways: Sequence[str]) -> Iterator[Handshake]:
    """One for each of these types of gateways that an example plant has."""
    from fbgen.resources import shipped
    from harness.installation import PlantSetup, plant

    waiting = list(gateways)
    for program in programs:
        if not waiting:
            return
        entry = next(iter(program.plant.gateways), None)
        if entry is None or entry.type not in waiting:
            continue
        waiting.remove(entry.type)
        path = shipped("examples") / program.plant.name / "plant.yaml"
        installation = plant(path, PlantSetup(seed=1, program=program.program, sources=()))
        recorder = installation.record()
        installation.start()
        installation.run_for(400 * _MS)
        trace = recorder.finish()
        if trace.telegrams:
            yield _of_telegrams(trace, entry.type, entry.name)
        else:
            yield _of_channel(trace, entry.type, entry.name)


def _of_telegrams(trace: "Trace", kind: str, gateway: str) -> Handshake:
    """The second telegram: the first one is that which goes out after power-up."""
    first = trace.telegrams[1]
    received = first.received_ns
    assert received is not None, "the example is answered"
    span = first.sent_ns - 10 * _MS, received + 15 * _MS
    own = f"gateway.{gateway}"
    signals = (
        _bit(trace, f"{own}.control", 14, "control bit 14", span),
        _bit(trace, f"{own}.control", 15, "control bit 15", span),
        _number(trace, f"{own}.trigger", "trigger", 8, span),
        _bit(trace, f"{own}.status", 14, "status bit 14", span),
        _bit(trace, f"{own}.status", 15, "status bit 15", span),
    )
    return _handshake(trace, kind, _TELEGRAM_TEXT, span, signals, trace.frames)


def _of_channel(trace: "Trace", kind: str, gateway: str) -> Handshake:
    own = f"gateway.{gateway}"
    number = trace.channel(f"{own}.output.a_number")
    begin = next(one.time_ns for one in trace.changes if one.channel == number and one.value)
    span = begin - 10 * _MS, begin + 60 * _MS
    signals = (
        _number(trace, f"{own}.output.a_number", "number out", 16, span),
        _number(trace, f"{own}.output.a_action", "request", 16, span),
        _number(trace, f"{own}.input.a_number", "number in", 16, span),
        _number(trace, f"{own}.input.a_response", "response", 16, span),
        _number(trace, f"{own}.input.a_data", "data in", 16, span),
    )
    asked = signals[0].changes[-1][1].to_bytes(2)
    frames = [one for one in trace.frames if one.start_ns >= begin and asked in one.data]
    return _handshake(trace, kind, _CHANNEL_TEXT, span, signals, frames[:2])


def _handshake(
    trace: "Trace",
    kind: str,
    text: str,
    span: tuple[int, int],
    signals: tuple[Signal, ...],
    sent: Iterable["Frame"],
) -> Handshake:
    begin, end = span
    frames = tuple(
        FrameTime((one.start_ns - begin) / _MS, (one.end_ns - begin) / _MS, _frame_text(one))
        for one in sent
        if begin <= one.start_ns and one.end_ns <= end
    )
    return Handshake(kind, trace.title, text, (end - begin) / _MS, signals, frames)


def _frame_text(frame: "Frame") -> str:
    who = "gateway" if frame.to_drives else frame.sender or "inverter"
    meaning = f": {frame.meaning}" if frame.meaning else ""
    return f"{frame.data.hex(' ').upper()} from {who}{meaning}"


def _bit(trace: "Trace", path: str, bit: int, title: str, span: tuple[int, int]) -> Signal:
    changes = [(time, value >> bit & 1) for time, value in _values(trace, path, span)]
    return Signal(title, 1, tuple(_only_changes(changes)))


def _number(trace: "Trace", path: str, title: str, bits: int, span: tuple[int, int]) -> Signal:
    return Signal(title, bits, tuple(_only_changes(_values(trace, path, span))))


def _values(trace: "Trace", path: str, span: tuple[int, int]) -> list[tuple[float, int]]:
    """The value at the beginning, and each change in between."""
    channel = trace.channel(path)
    found: list[tuple[float, int]] = [(0.0, 0)]
    for change in trace.changes:
        if change.channel == channel and change.time_ns <= span[1]:
            assert isinstance(change.value, int)
            time = max(0.0, (change.time_ns - span[0]) / _MS)
            found = [*(one for one in found if one[0] < time), (time, change.value)]
    return found


def _only_changes(values: Iterable[tuple[float, int]]) -> Iterator[tuple[float, int]]:
    last = None
    for time, value in values:
        if value != last:
            yield time, value
        last = value
