"""Durations, dates and times of day as text, in the form of their literals."""

from collections.abc import Callable

from harness.engine.compiled.library.calendar import day_of, time_of
from harness.engine.compiled.library.dates import NS_PER_DAY, NS_PER_MS

_STEPS = (("ns", 1000), ("us", 1000), ("ms", 1000), ("s", 60), ("m", 60), ("h", 24))
"""The units from below, and how many of each make one of the next."""


def _duration(mark: str, count: int, steps: tuple[tuple[str, int], ...]) -> str:
    rest, parts = abs(count), []
    for unit, size in steps:
        rest, here = divmod(rest, size)
        if here:
            parts.append(f"{here}{unit}")
    if rest:
        parts.append(f"{rest}d")
    sign = "-" if count < 0 else ""
    return f"{mark}#{sign}{''.join(reversed(parts)) or '0' + steps[0][0]}"


def _date(days: int) -> str:
    year, month, day = day_of(days)
    return f"{year:04}-{month:02}-{day:02}"


def _time_of_day(nanoseconds: int) -> str:
    milliseconds, finer = divmod(nanoseconds, NS_PER_MS)
    hour, minute, second, millisecond = time_of(milliseconds)
    tail = f".{millisecond:03}" if millisecond or finer else ""
    tail += f"{finer:06}" if finer else ""
    return f"{hour:02}:{minute:02}:{second:02}{tail}"


def _stamp(stamp: int) -> str:
    days, rest = divmod(stamp, NS_PER_DAY)
    return f"{_date(days)}-{_time_of_day(rest)}"


FUNCTIONS: dict[str, Callable[[int], str]] = {
    "TIME": lambda count: _duration("T", count, _STEPS[2:]),
    "LTIME": lambda count: _duration("LT", count, _STEPS),
    "DATE": lambda instant: "D#" + _date(instant // NS_PER_DAY),
    "LDATE": lambda instant: "LDATE#" + _date(instant // NS_PER_DAY),
    "TIME_OF_DAY": lambda count: "TOD#" + _time_of_day(count * NS_PER_MS),
    "LTIME_OF_DAY": lambda count: "LTOD#" + _time_of_day(count),
    "DATE_AND_TIME": lambda stamp: "DT#" + _stamp(stamp),
    "LDT": lambda stamp: "LDT#" + _stamp(stamp),
}
"""By the name of the type; dates come as nanoseconds since 1970."""
