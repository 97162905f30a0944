"""Durations, dates and times of day as text, in the form of their literals.

Parts that are zero are left out of a duration, and the fraction of a second out of a time of day.
The standard leaves the form open; this is the one that can be read back as a literal.
"""

from collections.abc import Callable, Sequence

from fbgen.lang.types import Scalar
from harness.engine.reference.calendar import NS_PER_DAY, day_parts, time_parts
from harness.engine.reference.functions import Function, Signature

_UNITS_NS = (
    *(("d", NS_PER_DAY), ("h", 3_600_000_000_000), ("m", 60_000_000_000), ("s", 1_000_000_000)),
    *(("ms", 1_000_000), ("us", 1_000), ("ns", 1)),
)
_FIRST_ORDINALS = {"DATE": 726_468, "STAMP": 719_163}
"""Python's numbers of 1990-01-01 and 1970-01-01."""


def _duration(prefix: str, nanoseconds: int, smallest: str) -> str:
    rest, text = abs(nanoseconds), ""
    for unit, size in _UNITS_NS:
        count, rest = divmod(rest, size)
        if count:
            text += f"{count}{unit}"
    return f"{prefix}#{'-' if nanoseconds < 0 else ''}{text or f'0{smallest}'}"


def _day(ordinal: int) -> str:
    parts = day_parts(ordinal)
    return f"{parts['year']:04d}-{parts['month']:02d}-{parts['day']:02d}"


def _clock(nanoseconds: int) -> str:
    milliseconds, fraction_ns = divmod(nanoseconds, 1_000_000)
    parts = time_parts(milliseconds)
    text = f"{parts['hour']:02d}:{parts['minute']:02d}:{parts['second']:02d}"
    if fraction_ns:
        return f"{text}.{parts['millisecond']:03d}{fraction_ns:06d}"
    return f"{text}.{parts['millisecond']:03d}" if parts["millisecond"] else text


def _stamp(prefix: str) -> Callable[[int], str]:
    def show(stamp_ns: int) -> str:
        days, rest_ns = divmod(stamp_ns, NS_PER_DAY)
        return f"{prefix}#{_day(_FIRST_ORDINALS['STAMP'] + days)}-{_clock(rest_ns)}"

    return show


_SHOWN: dict[str, Callable[[int], str]] = {
    "TIME": lambda ms: _duration("T", ms * 1_000_000, "ms"),
    "LTIME": lambda ns: _duration("LT", ns, "ns"),
    "DATE": lambda days: f"D#{_day(_FIRST_ORDINALS['DATE'] + days)}",
    "TIME_OF_DAY": lambda ms: f"TOD#{_clock(ms * 1_000_000)}",
    "LTIME_OF_DAY": lambda ns: f"LTOD#{_clock(ns)}",
    "DATE_AND_TIME": _stamp("DT"),
    "LDT": _stamp("LDT"),
}


def _texts(show: Callable[[int], str]) -> Function:
    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        return show(int(values[0]))

    return call


TIME_TEXTS: dict[str, Function] = {
    f"{kind}_TO_{text}": _texts(show)
    for kind, show in _SHOWN.items()
    for text in ("STRING", "WSTRING")
}
"""By canonical name."""
