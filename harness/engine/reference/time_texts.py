"""Durations, dates and times of day as text, in the form of their literals.

Parts that are zero are left out of a duration, and the fraction of a second out of a time of day.
The standard leaves the form open; this is the one that can be read back as a literal.
"""

from collections.abc import Callable, Sequence

from fbgen.lang.types import Scalar
from harness.engine.reference.calendar import (
    NS_PER_DAY,
    day_parts,
    instant_of,
    is_counted,
    time_parts,
)
from harness.engine.reference.functions import Function, Signature

_UNITS_NS = (
    *(("d", NS_PER_DAY), ("h", 3_600_000_000_000), ("m", 60_000_000_000), ("s", 1_000_000_000)),
    *(("ms", 1_000_000), ("us", 1_000), ("ns", 1)),
)


def _duration(prefix: str, nanoseconds: int, smallest: str) -> str:
    rest, text = abs(nanoseconds), ""
    for unit, size in _UNITS_NS:
        count, rest = divmod(rest, size)
        if count:
            text += f"{count}{unit}"
    return f"{prefix}#{'-' if nanoseconds < 0 else ''}{text or f'0{smallest}'}"


def _day(instant_ns: int) -> str:
    parts = day_parts(instant_ns)
    return f"{parts['year']:04d}-{parts['month']:02d}-{parts['day']:02d}"


def _clock(nanoseconds: int) -> str:
    milliseconds, fraction_ns = divmod(nanoseconds, 1_000_000)
    parts = time_parts(milliseconds)
    text = f"{parts['hour']:02d}:{parts['minute']:02d}:{parts['second']:02d}"
    if fraction_ns:
        return f"{text}.{parts['millisecond']:03d}{fraction_ns:06d}"
    return f"{text}.{parts['millisecond']:03d}" if parts["millisecond"] else text


def _stamp(instant_ns: int) -> str:
    return f"{_day(instant_ns)}-{_clock(instant_ns % NS_PER_DAY)}"


_SHOWN: dict[str, Callable[[int], str]] = {
    "TIME": lambda ms: _duration("T", ms * 1_000_000, "ms"),
    "LTIME": lambda ns: _duration("LT", ns, "ns"),
    "TIME_OF_DAY": lambda ms: f"TOD#{_clock(ms * 1_000_000)}",
    "LTIME_OF_DAY": lambda ns: f"LTOD#{_clock(ns)}",
    "DATE": lambda instant_ns: f"D#{_day(instant_ns)}",
    "LDATE": lambda instant_ns: f"LDATE#{_day(instant_ns)}",
    "DATE_AND_TIME": lambda instant_ns: f"DT#{_stamp(instant_ns)}",
    "LDT": lambda instant_ns: f"LDT#{_stamp(instant_ns)}",
}
"""By the name of the type; dates come as nanoseconds since 1970."""


def _texts(show: Callable[[int], str]) -> Function:
    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        count, kind = int(values[0]), signature.arguments[0]
        return show(instant_of(kind, count) if is_counted(kind) else count)

    return call


TIME_TEXTS: dict[str, Function] = {
    f"{kind}_TO_{text}": _texts(show)
    for kind, show in _SHOWN.items()
    for text in ("STRING", "WSTRING")
}
"""By canonical name."""
