"""The calendar: a DTL from the nanoseconds since 1970, and back.

Days are counted with the year beginning in March, so that leap days come last.
Source: TIA Portal help, "DTL (date and time)": WEEKDAY 1 is Sunday.
"""

from typing import Any

from harness.engine.compiled.library.dates import NS_PER_DAY
from harness.engine.compiled.library.stops import NoDate

_LENGTHS = (31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31)
_TO_MARCH_YEAR_0 = 719_468
"""Days from 1 March of the year 0 to 1970-01-01."""
_FIRST_YEAR, _LAST_YEAR = 1970, 2553
_NS_PER_S = 1_000_000_000


def _is_leap(year: int) -> bool:
    return year % 4 == 0 and (year % 100 != 0 or year % 400 == 0)


def stamp_of(dtl: Any) -> int:
    """The nanoseconds of a DTL; its WEEKDAY does not matter."""
    year, month, day = dtl.YEAR, dtl.MONTH, dtl.DAY
    if not (_FIRST_YEAR <= year <= _LAST_YEAR and 1 <= month <= 12 and day >= 1):
        raise NoDate
    if day > _LENGTHS[month - 1] + (month == 2 and _is_leap(year)):
        raise NoDate
    if dtl.HOUR > 23 or dtl.MINUTE > 59 or dtl.SECOND > 59 or dtl.NANOSECOND >= _NS_PER_S:
        raise NoDate
    shifted = year - (month < 3)
    days = 365 * shifted + shifted // 4 - shifted // 100 + shifted // 400
    days += (153 * ((month - 3) % 12) + 2) // 5 + day - 1 - _TO_MARCH_YEAR_0
    seconds = (dtl.HOUR * 60 + dtl.MINUTE) * 60 + dtl.SECOND
    nanoseconds: int = days * NS_PER_DAY + seconds * _NS_PER_S + dtl.NANOSECOND
    return nanoseconds


def in_parts(make: type, nanoseconds: int) -> Any:
    """A new DTL; `make` is its class."""
    dtl = make()
    days, rest = divmod(nanoseconds, NS_PER_DAY)
    dtl.WEEKDAY = (days + 4) % 7 + 1
    days += _TO_MARCH_YEAR_0
    era, of_era = divmod(days, 146_097)
    year = (of_era - of_era // 1460 + of_era // 36_524 - of_era // 146_096) // 365
    of_year = of_era - (365 * year + year // 4 - year // 100)
    month = (5 * of_year + 2) // 153
    dtl.DAY = of_year - (153 * month + 2) // 5 + 1
    dtl.MONTH = month + 3 if month < 10 else month - 9
    dtl.YEAR = era * 400 + year + (month >= 10)
    seconds, dtl.NANOSECOND = divmod(rest, _NS_PER_S)
    minutes, dtl.SECOND = divmod(seconds, 60)
    dtl.HOUR, dtl.MINUTE = divmod(minutes, 60)
    return dtl
