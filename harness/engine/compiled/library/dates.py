"""Dates and times of day with durations, in the counts that `fbgen.lang.types` describes.

Sources: IEC 61131-3 third edition, table 35; TIA Portal help, "T_ADD", "T_SUB", "T_DIFF".
"""

from collections.abc import Callable

NS_PER_MS = 1_000_000
MS_PER_DAY = 86_400_000
NS_PER_DAY = MS_PER_DAY * NS_PER_MS
DAYS_TO_1990 = 7_305
"""From 1970-01-01, where the nanoseconds start, to 1990-01-01, where the days start."""


def cut_to_ms(nanoseconds: int) -> int:
    """Nanoseconds as whole milliseconds, cut towards zero."""
    whole = abs(nanoseconds) // NS_PER_MS
    return whole if nanoseconds >= 0 else -whole


def _days_to_ns(days: int, day_ms: int) -> int:
    return (days + DAYS_TO_1990) * NS_PER_DAY + day_ms * NS_PER_MS


FUNCTIONS: dict[str, Callable[[int, int], int]] = {
    "ADD_TOD_TIME": lambda tod, time: (tod + time) % MS_PER_DAY,
    "SUB_TOD_TIME": lambda tod, time: (tod - time) % MS_PER_DAY,
    "ADD_LTOD_LTIME": lambda tod, time: (tod + time) % NS_PER_DAY,
    "SUB_LTOD_LTIME": lambda tod, time: (tod - time) % NS_PER_DAY,
    "ADD_DT_TIME": lambda stamp, time: stamp + time * NS_PER_MS,
    "SUB_DT_TIME": lambda stamp, time: stamp - time * NS_PER_MS,
    "ADD_LDT_LTIME": lambda stamp, time: stamp + time,
    "SUB_LDT_LTIME": lambda stamp, time: stamp - time,
    "SUB_TOD_TOD": lambda one, two: one - two,
    "SUB_LTOD_LTOD": lambda one, two: one - two,
    "SUB_DATE_DATE": lambda one, two: (one - two) * MS_PER_DAY,
    "SUB_DT_DT": lambda one, two: cut_to_ms(one - two),
    "SUB_LDT_LDT": lambda one, two: one - two,
    "CONCAT_DATE_TOD": _days_to_ns,
    "CONCAT_DATE_LTOD": lambda days, tod: (days + DAYS_TO_1990) * NS_PER_DAY + tod,
}
"""By canonical name; the results are still to be wrapped around into their type."""
