"""Standard functions on dates, times of day and the S5TIME.

A time of day goes on at midnight with zero; everything else wraps around in its width.
Sources: IEC 61131-3 third edition, tables 35 and 36; STEP 7 help, "Format of the data type S5TIME"
(three decimal digits and the time base).
"""

from collections.abc import Callable, Sequence

from fbgen.lang.types import Elementary, Scalar
from fbgen.source import Span
from harness.engine.faults import not_decimal, value_out_of_range
from harness.engine.reference.arithmetic import divided, wrap
from harness.engine.reference.calendar import (
    CALENDAR_FUNCTIONS,
    count_of,
    instant_of,
    unit_of,
)
from harness.engine.reference.functions import Function, Signature

_NS_PER_MS = 1_000_000
_MS_PER_DAY = 86_400_000
_NS_PER_DAY = _MS_PER_DAY * _NS_PER_MS
S5_BASES_MS = (10, 100, 1_000, 10_000)


def _two(values: Sequence[Scalar]) -> tuple[int, int]:
    left, right = values
    assert isinstance(left, int)
    assert isinstance(right, int)
    return left, right


def _result(signature: Signature, number: int) -> Scalar:
    assert isinstance(signature.result, Elementary)
    return wrap(signature.result, number)


def _of_two(calculate: Callable[[int, int], int]) -> Function:
    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        return _result(signature, calculate(*_two(values)))

    return call


def _moved(sign: int) -> Function:
    """A date and time, later or earlier by a TIME, whose part below the unit is cut off."""

    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        stamp, time_ms = _two(values)
        units = divided(time_ms * _NS_PER_MS, unit_of(signature.arguments[0]), signature.span)
        return _result(signature, stamp + sign * units)

    return call


def _difference(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """Between two dates, with a time or without; nanoseconds to milliseconds cut towards zero."""
    later, earlier = _two(values)
    distance_ns = (later - earlier) * unit_of(signature.arguments[0])
    return _result(signature, divided(distance_ns, _NS_PER_MS, signature.span))


def _with_time(tick_ns: int) -> Function:
    """A date and a time of day that counts in `tick_ns`."""

    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        count, time = _two(values)
        instant_ns = instant_of(signature.arguments[0], count) + time * tick_ns
        assert isinstance(signature.result, Elementary)
        return _result(signature, count_of(signature.result, instant_ns))

    return call


def decimal_digits(value: int, span: Span) -> int:
    """The number in the low three decimal digits. Raises FB6014."""
    digits = [value >> shift & 15 for shift in (8, 4, 0)]
    if max(digits) > 9:
        raise not_decimal(span, value)
    return digits[0] * 100 + digits[1] * 10 + digits[2]


def coded(number: int) -> int:
    """A number below 1000 in three decimal digits."""
    return number // 100 << 8 | number // 10 % 10 << 4 | number % 10


def _s5time_to_time(values: Sequence[Scalar], signature: Signature) -> Scalar:
    value = values[0]
    assert isinstance(value, int)
    return decimal_digits(value, signature.span) * S5_BASES_MS[value >> 12 & 3]


def _time_to_s5time(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """The finest base that holds the time; what is below it is cut. Raises FB6006."""
    value = values[0]
    assert isinstance(value, int)
    for code, base_ms in enumerate(S5_BASES_MS):
        if 0 <= value // base_ms <= 999:
            return code << 12 | coded(value // base_ms)
    raise value_out_of_range(signature.span, value, signature.result)


DATE_FUNCTIONS: dict[str, Function] = {
    "ADD_TOD_TIME": _of_two(lambda day_ms, time_ms: (day_ms + time_ms) % _MS_PER_DAY),
    "SUB_TOD_TIME": _of_two(lambda day_ms, time_ms: (day_ms - time_ms) % _MS_PER_DAY),
    "ADD_LTOD_LTIME": _of_two(lambda day_ns, time_ns: (day_ns + time_ns) % _NS_PER_DAY),
    "SUB_LTOD_LTIME": _of_two(lambda day_ns, time_ns: (day_ns - time_ns) % _NS_PER_DAY),
    "ADD_DT_TIME": _moved(1),
    "SUB_DT_TIME": _moved(-1),
    "ADD_LDT_LTIME": _of_two(lambda stamp_ns, time_ns: stamp_ns + time_ns),
    "SUB_LDT_LTIME": _of_two(lambda stamp_ns, time_ns: stamp_ns - time_ns),
    "SUB_TOD_TOD": _of_two(lambda later_ms, earlier_ms: later_ms - earlier_ms),
    "SUB_LTOD_LTOD": _of_two(lambda later_ns, earlier_ns: later_ns - earlier_ns),
    "SUB_DATE_DATE": _difference,
    "SUB_DT_DT": _difference,
    "SUB_LDT_LDT": _of_two(lambda later_ns, earlier_ns: later_ns - earlier_ns),
    "CONCAT_DATE_TOD": _with_time(_NS_PER_MS),
    "S5TIME_TO_TIME": _s5time_to_time,
    "TIME_TO_S5TIME": _time_to_s5time,
    "CONCAT_DATE_LTOD": _with_time(1),
    **CALENDAR_FUNCTIONS,
}
"""By canonical name."""
