"""The calendar: a DTL from the nanoseconds since 1970, and back.

Source: TIA Portal help, "DTL (date and time)": WEEKDAY 1 is Sunday.
"""

from typing import Any

from harness.engine.compiled.library.calendar import day_of, days_of
from harness.engine.compiled.library.dates import NS_PER_DAY
from harness.engine.compiled.library.stops import NoDate, NoSuchDate

_FIRST_YEAR, _LAST_YEAR = 1970, 2553
_NS_PER_S = 1_000_000_000


def stamp_of(dtl: Any) -> int:
    """The nanoseconds of a DTL; its WEEKDAY does not matter."""
    if not _FIRST_YEAR <= dtl.YEAR <= _LAST_YEAR:
        raise NoDate
    try:
        days = days_of(dtl.YEAR, dtl.MONTH, dtl.DAY)
    except NoSuchDate:
        raise NoDate from None
    if dtl.HOUR > 23 or dtl.MINUTE > 59 or dtl.SECOND > 59 or dtl.NANOSECOND >= _NS_PER_S:
        raise NoDate
    seconds = (dtl.HOUR * 60 + dtl.MINUTE) * 60 + dtl.SECOND
    nanoseconds: int = days * NS_PER_DAY + seconds * _NS_PER_S + dtl.NANOSECOND
    return nanoseconds


def in_parts(make: type, nanoseconds: int) -> Any:
    """A new DTL; `make` is its class."""
    dtl = make()
    days, rest = divmod(nanoseconds, NS_PER_DAY)
    dtl.WEEKDAY = (days + 4) % 7 + 1
    dtl.YEAR, dtl.MONTH, dtl.DAY = day_of(days)
    seconds, dtl.NANOSECOND = divmod(rest, _NS_PER_S)
    minutes, dtl.SECOND = divmod(seconds, 60)
    dtl.HOUR, dtl.MINUTE = divmod(minutes, 60)
    return dtl
