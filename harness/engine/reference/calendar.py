"""The calendar: dates and times of day put together and taken apart.

Source: IEC 61131-3 third edition, table 36. Days count from 1990-01-01, stamps are nanoseconds
since 1970-01-01. The date arithmetic is that of Python's `datetime`.
"""

from collections.abc import Callable, Mapping, Sequence
from datetime import date

from fbgen.lang.types import DATE, Elementary, Scalar
from harness.engine.faults import no_such_date
from harness.engine.interface import Value
from harness.engine.reference.functions import Function, Signature
from harness.engine.reference.routine_operands import Operands

_FIRST_DAY = date(1990, 1, 1).toordinal()
_FIRST_STAMP = date(1970, 1, 1).toordinal()
NS_PER_MS = 1_000_000
NS_PER_DAY = 86_400_000 * NS_PER_MS
_UNITS = (("hour", 3_600_000), ("minute", 60_000), ("second", 1_000), ("millisecond", 1))


def day_parts(ordinal: int) -> dict[str, int]:
    """Year, month and day of Python's day number."""
    day = date.fromordinal(ordinal)
    return {"year": day.year, "month": day.month, "day": day.day}


def time_parts(milliseconds: int) -> dict[str, int]:
    """Hours down to milliseconds."""
    parts = {}
    for name, unit in _UNITS:
        parts[name], milliseconds = divmod(milliseconds, unit)
    return parts


def stamp_parts(stamp_ns: int) -> dict[str, int]:
    """Year down to millisecond."""
    days, rest_ns = divmod(stamp_ns, NS_PER_DAY)
    return day_parts(_FIRST_STAMP + days) | time_parts(rest_ns // NS_PER_MS)


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
        return parts(operands.whole("IN"))

    return split


SPLITTING: dict[str, Callable[[Operands], Mapping[str, Value]]] = {
    "SPLIT_DATE": _splitting(lambda days: day_parts(_FIRST_DAY + days)),
    "SPLIT_TOD": _splitting(time_parts),
    "SPLIT_LTOD": _splitting(lambda tod_ns: time_parts(tod_ns // NS_PER_MS)),
    "SPLIT_DT": _splitting(stamp_parts),
    "SPLIT_LDT": _splitting(stamp_parts),
}
"""By canonical name."""


def _day_number(numbers: Sequence[int], signature: Signature) -> int:
    """Python's number of a day given by year, month and day. Raises FB6015."""
    year, month, day = numbers
    try:
        return date(year, month, day).toordinal()
    except (ValueError, OverflowError):
        raise no_such_date(signature.span, f"{year}-{month}-{day}") from None


def _milliseconds(numbers: Sequence[int], signature: Signature) -> int:
    """Milliseconds since midnight. Raises FB6015."""
    limits = (23, 59, 59, 999)
    if any(not 0 <= number <= limit for number, limit in zip(numbers, limits, strict=True)):
        hour, minute, second, millisecond = numbers
        raise no_such_date(signature.span, f"{hour}:{minute}:{second}.{millisecond}")
    return sum(number * unit for number, (_, unit) in zip(numbers, _UNITS, strict=True))


def _in_range(value: int, numbers: Sequence[int], signature: Signature) -> int:
    kind = signature.result
    assert isinstance(kind, Elementary)
    if not kind.minimum <= value <= kind.maximum:
        raise no_such_date(signature.span, "-".join(str(number) for number in numbers))
    return value


def _whole(values: Sequence[Scalar]) -> list[int]:
    return [int(value) for value in values]


def _concat_date(values: Sequence[Scalar], signature: Signature) -> Scalar:
    numbers = _whole(values)
    return _in_range(_day_number(numbers, signature) - _FIRST_DAY, numbers, signature)


def _concat_tod(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return _milliseconds(_whole(values), signature)


def _concat_ltod(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return _milliseconds(_whole(values), signature) * NS_PER_MS


def _concat_stamp(values: Sequence[Scalar], signature: Signature) -> Scalar:
    numbers = _whole(values)
    days = _day_number(numbers[:3], signature) - _FIRST_STAMP
    rest_ns = _milliseconds(numbers[3:], signature) * NS_PER_MS
    return _in_range(days * NS_PER_DAY + rest_ns, numbers[:3], signature)


def _day_of_week(values: Sequence[Scalar], signature: Signature) -> Scalar:
    value = int(values[0])
    if signature.arguments[0] == DATE:
        return (_FIRST_DAY + value) % 7
    return weekday(value)


CALENDAR_FUNCTIONS: dict[str, Function] = {
    "CONCAT_DATE": _concat_date,
    "CONCAT_TOD": _concat_tod,
    "CONCAT_LTOD": _concat_ltod,
    "CONCAT_DT": _concat_stamp,
    "CONCAT_LDT": _concat_stamp,
    "DAY_OF_WEEK": _day_of_week,
}
"""By canonical name."""
