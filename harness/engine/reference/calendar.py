"""The calendar: dates and times of day put together and taken apart.

Source: IEC 61131-3 third edition, table 36. What the types count, and from when on, stands in
`_COUNTS` and nowhere else. The date arithmetic is that of Python's `datetime`.
"""

from collections.abc import Callable, Mapping, Sequence
from datetime import date

from fbgen.lang.types import (
    DATE,
    DATE_AND_TIME,
    LDATE,
    LDT,
    PC_DATE,
    PC_DATE_AND_TIME,
    Elementary,
    Scalar,
    Type,
)
from harness.engine.faults import no_such_date
from harness.engine.interface import Value
from harness.engine.reference.functions import Function, Signature
from harness.engine.reference.routine_operands import Operands

_FIRST_STAMP = date(1970, 1, 1).toordinal()
NS_PER_MS = 1_000_000
_NS_PER_S = 1_000 * NS_PER_MS
NS_PER_DAY = 86_400 * _NS_PER_S
_COUNTS = {
    DATE: ((date(1990, 1, 1).toordinal() - _FIRST_STAMP) * NS_PER_DAY, NS_PER_DAY),
    PC_DATE: (0, _NS_PER_S),
    LDATE: (0, 1),
    DATE_AND_TIME: (0, 1),
    PC_DATE_AND_TIME: (0, _NS_PER_S),
    LDT: (0, 1),
}
"""Where the count of a type begins, in nanoseconds since 1970-01-01, and what it counts."""
_UNITS = (("hour", 3_600_000), ("minute", 60_000), ("second", 1_000), ("millisecond", 1))


def is_counted(kind: Type) -> bool:
    """True for dates, with a time or without."""
    return kind in _COUNTS


def instant_of(kind: Type, count: int) -> int:
    """Nanoseconds since 1970-01-01."""
    assert isinstance(kind, Elementary)
    first, unit = _COUNTS[kind]
    return first + count * unit


def count_of(kind: Elementary, instant_ns: int) -> int:
    """What a variable of the type holds; not yet wrapped around in its width."""
    first, unit = _COUNTS[kind]
    if kind in (DATE, PC_DATE, LDATE):
        instant_ns -= instant_ns % NS_PER_DAY
    return (instant_ns - first) // unit


def unit_of(kind: Type) -> int:
    """The nanoseconds between one value of the type and the next."""
    assert isinstance(kind, Elementary)
    return _COUNTS[kind][1]


def first_on_s7() -> int:
    """What a DATE_AND_TIME of S7 starts with: the first day that a DATE has."""
    return instant_of(DATE, 0)


def day_parts(instant_ns: int) -> dict[str, int]:
    """Year, month and day."""
    day = date.fromordinal(_FIRST_STAMP + instant_ns // NS_PER_DAY)
    return {"year": day.year, "month": day.month, "day": day.day}


def time_parts(milliseconds: int) -> dict[str, int]:
    """Hours down to milliseconds."""
    parts = {}
    for name, unit in _UNITS:
        parts[name], milliseconds = divmod(milliseconds, unit)
    return parts


def stamp_parts(stamp_ns: int) -> dict[str, int]:
    """Year down to millisecond."""
    return day_parts(stamp_ns) | time_parts(stamp_ns % NS_PER_DAY // NS_PER_MS)


def weekday(stamp_ns: int) -> int:
    """0 on Sundays to 6 on Saturdays."""
    return (_FIRST_STAMP + stamp_ns // NS_PER_DAY) % 7


def stamp_of_parts(parts: Mapping[str, int], nanoseconds: int) -> int:
    """Nanoseconds since 1970 of year, month, day, hour, minute, second; ValueError if none."""
    day = date(parts["year"], parts["month"], parts["day"]).toordinal() - _FIRST_STAMP
    seconds = (parts["hour"] * 60 + parts["minute"]) * 60 + parts["second"]
    return day * NS_PER_DAY + seconds * 1_000_000_000 + nanoseconds


def _splitting(
    parts: Callable[[int], Mapping[str, int]],
) -> Callable[[Operands], Mapping[str, Value]]:
    def split(operands: Operands) -> Mapping[str, Value]:
        value, kind = operands.whole("IN"), operands.kinds["IN"]
        return parts(instant_of(kind, value) if is_counted(kind) else value)

    return split


SPLITTING: dict[str, Callable[[Operands], Mapping[str, Value]]] = {
    "SPLIT_DATE": _splitting(day_parts),
    "SPLIT_TOD": _splitting(time_parts),
    "SPLIT_LTOD": _splitting(lambda tod_ns: time_parts(tod_ns // NS_PER_MS)),
    "SPLIT_DT": _splitting(stamp_parts),
    "SPLIT_LDT": _splitting(stamp_parts),
}
"""By canonical name."""


def _day_number(numbers: Sequence[int], signature: Signature) -> int:
    """Days since 1970-01-01 of a year, month and day. Raises FB6015."""
    year, month, day = numbers
    try:
        return date(year, month, day).toordinal() - _FIRST_STAMP
    except (ValueError, OverflowError):
        raise no_such_date(signature.span, f"{year}-{month}-{day}") from None


def _milliseconds(numbers: Sequence[int], signature: Signature) -> int:
    """Milliseconds since midnight. Raises FB6015."""
    limits = (23, 59, 59, 999)
    if any(not 0 <= number <= limit for number, limit in zip(numbers, limits, strict=True)):
        hour, minute, second, millisecond = numbers
        raise no_such_date(signature.span, f"{hour}:{minute}:{second}.{millisecond}")
    return sum(number * unit for number, (_, unit) in zip(numbers, _UNITS, strict=True))


def _in_range(instant_ns: int, numbers: Sequence[int], signature: Signature) -> int:
    kind = signature.result
    assert isinstance(kind, Elementary)
    value = count_of(kind, instant_ns)
    if not kind.minimum <= value <= kind.maximum:
        raise no_such_date(signature.span, "-".join(str(number) for number in numbers))
    return value


def _whole(values: Sequence[Scalar]) -> list[int]:
    return [int(value) for value in values]


def _concat_date(values: Sequence[Scalar], signature: Signature) -> Scalar:
    numbers = _whole(values)
    return _in_range(_day_number(numbers, signature) * NS_PER_DAY, numbers, signature)


def _concat_tod(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return _milliseconds(_whole(values), signature)


def _concat_ltod(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return _milliseconds(_whole(values), signature) * NS_PER_MS


def _concat_stamp(values: Sequence[Scalar], signature: Signature) -> Scalar:
    numbers = _whole(values)
    days = _day_number(numbers[:3], signature)
    rest_ns = _milliseconds(numbers[3:], signature) * NS_PER_MS
    return _in_range(days * NS_PER_DAY + rest_ns, numbers[:3], signature)


def _day_of_week(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return weekday(instant_of(signature.arguments[0], int(values[0])))


CALENDAR_FUNCTIONS: dict[str, Function] = {
    "CONCAT_DATE": _concat_date,
    "CONCAT_TOD": _concat_tod,
    "CONCAT_LTOD": _concat_ltod,
    "CONCAT_DT": _concat_stamp,
    "CONCAT_LDT": _concat_stamp,
    "DAY_OF_WEEK": _day_of_week,
}
"""By canonical name."""
