"""The calendar in whole numbers: days since 1970 to year, month and day, and back.

Years are counted from March on, so that the leap day is the last of its year; eras of 400 years all
have the same number of days. Source: the rules of the Gregorian calendar; IEC 61131-3 third
edition, table 36.
"""

from harness.engine.compiled.library.dates import NS_PER_DAY, NS_PER_MS
from harness.engine.compiled.library.stops import NoSuchDate

_ERA = 146_097
"""Days in 400 years."""
_TO_1970 = 719_468
"""Days from 0000-03-01 to 1970-01-01."""
_LENGTHS = (31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)


def day_of(days: int) -> tuple[int, int, int]:
    """Year, month and day of a number of days since 1970-01-01."""
    era, day = divmod(days + _TO_1970, _ERA)
    year = (day - day // 1460 + day // 36_524 - day // (_ERA - 1)) // 365
    day -= 365 * year + year // 4 - year // 100
    month = (5 * day + 2) // 153
    day -= (153 * month + 2) // 5
    month = month + 3 if month < 10 else month - 9
    return year + 400 * era + (month <= 2), month, day + 1


def days_of(year: int, month: int, day: int) -> int:
    """Days since 1970-01-01."""
    leap = month == 2 and year % 4 == 0 and (year % 100 != 0 or year % 400 == 0)
    if not 1 <= year <= 9999 or not 1 <= month <= 12:
        raise NoSuchDate(f"{year}-{month}-{day}")
    if not 1 <= day <= _LENGTHS[month - 1] + leap:
        raise NoSuchDate(f"{year}-{month}-{day}")
    year -= month <= 2
    era, year = divmod(year, 400)
    month = month - 3 if month > 2 else month + 9
    return (
        era * _ERA
        + year * 365
        + year // 4
        - year // 100
        + (153 * month + 2) // 5
        + day
        - 1
        - _TO_1970
    )


def ms_of(hour: int, minute: int, second: int, millisecond: int) -> int:
    """Milliseconds since midnight."""
    inside = 0 <= hour < 24 and 0 <= minute < 60 and 0 <= second < 60 and 0 <= millisecond < 1000
    if not inside:
        raise NoSuchDate(f"{hour}:{minute}:{second}.{millisecond}")
    return ((hour * 60 + minute) * 60 + second) * 1000 + millisecond


def time_of(milliseconds: int) -> tuple[int, int, int, int]:
    """Hour, minute, second and millisecond."""
    seconds, millisecond = divmod(milliseconds, 1000)
    return seconds // 3600, seconds // 60 % 60, seconds % 60, millisecond


def concat_ltod(hour: int, minute: int, second: int, millisecond: int) -> int:
    """CONCAT_LTOD."""
    return ms_of(hour, minute, second, millisecond) * NS_PER_MS


def concat_stamp(counted: tuple[int, int, int], year: int, month: int, day: int, *time: int) -> int:
    """CONCAT_DATE, CONCAT_DT, CONCAT_LDT.

    `counted` are where the count of the result begins, its unit, and its largest value.
    """
    first, unit, last = counted
    instant = days_of(year, month, day) * NS_PER_DAY + (concat_ltod(*time) if time else 0)
    count = (instant - first) // unit
    if not 0 <= count <= last:
        raise NoSuchDate(f"{year}-{month}-{day}")
    return count


def weekday_of_stamp(stamp: int) -> int:
    """DAY_OF_WEEK of a stamp: 1970-01-01 was a Thursday."""
    return (stamp // NS_PER_DAY + 4) % 7
