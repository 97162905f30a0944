"""Dates and times of day with durations. What a type of dates counts stands in `COUNTS` only.

Sources: IEC 61131-3 third edition, table 35; TIA Portal help, "T_ADD", "T_SUB", "T_DIFF".
"""

from collections.abc import Callable

from fbgen.lang.types import DATE, DATE_AND_TIME, LDATE, LDT, PC_DATE, PC_DATE_AND_TIME, Elementary

NS_PER_MS = 1_000_000
NS_PER_S = 1_000 * NS_PER_MS
MS_PER_DAY = 86_400_000
NS_PER_DAY = MS_PER_DAY * NS_PER_MS
START_ON_S7 = 7_305 * NS_PER_DAY
"""From 1970-01-01 to 1990-01-01."""
COUNTS: dict[Elementary, tuple[int, int]] = {
    DATE: (START_ON_S7, NS_PER_DAY),
    DATE_AND_TIME: (0, 1),
    LDT: (0, 1),
    LDATE: (0, 1),
    PC_DATE: (0, NS_PER_S),
    PC_DATE_AND_TIME: (0, NS_PER_S),
}
"""Nanoseconds since 1970-01-01 where the count of a type begins, and of what it counts."""
DAYS = (DATE, PC_DATE, LDATE)


def instant_of(kind: Elementary, count: int) -> int:
    """Nanoseconds since 1970-01-01 of a value."""
    first, unit = COUNTS[kind]
    return count * unit + first


def cut_to_ms(nanoseconds: int) -> int:
    """Nanoseconds as whole milliseconds, cut towards zero."""
    whole = abs(nanoseconds) // NS_PER_MS
    return whole if nanoseconds >= 0 else -whole


def _whole_units(time_ms: int, unit: int) -> int:
    """A TIME in units of so many nanoseconds, cut towards zero."""
    whole = abs(time_ms) * NS_PER_MS // unit
    return whole if time_ms >= 0 else -whole


FUNCTIONS: dict[str, Callable[[int, int], int]] = {
    "ADD_TOD_TIME": lambda tod, time: (tod + time) % MS_PER_DAY,
    "SUB_TOD_TIME": lambda tod, time: (tod - time) % MS_PER_DAY,
    "ADD_LTOD_LTIME": lambda tod, time: (tod + time) % NS_PER_DAY,
    "SUB_LTOD_LTIME": lambda tod, time: (tod - time) % NS_PER_DAY,
    "ADD_LDT_LTIME": lambda stamp, time: stamp + time,
    "SUB_LDT_LTIME": lambda stamp, time: stamp - time,
    "SUB_TOD_TOD": lambda one, two: one - two,
    "SUB_LTOD_LTOD": lambda one, two: one - two,
    "SUB_LDT_LDT": lambda one, two: one - two,
}
"""By canonical name; the results are still to be wrapped around into their type."""

OF_UNITS: dict[str, Callable[[int, int, int], int]] = {
    "ADD_DT_TIME": lambda stamp, time, unit: stamp + _whole_units(time, unit),
    "SUB_DT_TIME": lambda stamp, time, unit: stamp - _whole_units(time, unit),
    "SUB_DATE_DATE": lambda one, two, unit: cut_to_ms((one - two) * unit),
    "SUB_DT_DT": lambda one, two, unit: cut_to_ms((one - two) * unit),
}
"""The same with the unit of the first operand, in nanoseconds."""
