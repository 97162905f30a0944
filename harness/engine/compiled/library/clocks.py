"""The calendar clock and the system time.

Sources: TIA Portal help, "RD_SYS_T", "TIME_TCK", "RUNTIME", "DTL"; the controller has no time zone.
"""

from collections.abc import Callable, Mapping
from typing import Any

from fbgen.lang.types import DATE_AND_TIME, Elementary, StructType, Type
from harness.engine.compiled.library import calendar
from harness.engine.compiled.library.dates import COUNTS, NS_PER_DAY, NS_PER_MS, instant_of
from harness.engine.compiled.library.stops import NoSuchDate
from harness.engine.services import Services

_NS_PER_S = 1_000_000_000
_ERROR_DATE = 0x8080

Results = Mapping[str, Any]
_Clock = Callable[[Mapping[str, Any], Mapping[str, Type], Services, int], Results]


def _dtl(stamp: int) -> dict[str, int]:
    days, rest = divmod(stamp, NS_PER_DAY)
    year, month, day = calendar.day_of(days)
    hour, minute, second, _ = calendar.time_of(rest // NS_PER_MS)
    return {
        "YEAR": year,
        "MONTH": month,
        "DAY": day,
        "WEEKDAY": calendar.weekday_of_stamp(stamp) + 1,
        "HOUR": hour,
        "MINUTE": minute,
        "SECOND": second,
        "NANOSECOND": rest % _NS_PER_S,
    }


def _of_dtl(parts: Mapping[str, int]) -> int:
    by_key = {name.upper(): number for name, number in parts.items()}
    days = calendar.days_of(by_key["YEAR"], by_key["MONTH"], by_key["DAY"])
    seconds = by_key["HOUR"] * 3600 + by_key["MINUTE"] * 60 + by_key["SECOND"]
    return days * NS_PER_DAY + seconds * _NS_PER_S + by_key["NANOSECOND"]


def _reader(output: str) -> _Clock:
    def read(
        inputs: Mapping[str, Any], kinds: Mapping[str, Type], services: Services, now_ns: int
    ) -> Results:
        stamp = services.calendar_ns + now_ns
        kind = kinds.get(output)
        given: Any = stamp
        if isinstance(kind, StructType):
            given = _dtl(stamp)
        elif kind == DATE_AND_TIME:
            given = stamp // NS_PER_MS * NS_PER_MS
        elif isinstance(kind, Elementary):
            first, unit = COUNTS[kind]
            given = (stamp - first) // unit
        return {output.casefold(): given, "ret_val": 0}

    return read


def _writer(name: str) -> _Clock:
    def write(
        inputs: Mapping[str, Any], kinds: Mapping[str, Type], services: Services, now_ns: int
    ) -> Results:
        given, kind = inputs[name], kinds[name]
        try:
            stamp = instant_of(kind, given) if isinstance(kind, Elementary) else _of_dtl(given)
        except NoSuchDate:
            return {"ret_val": _ERROR_DATE}
        services.calendar_ns = stamp - now_ns
        return {"ret_val": 0}

    return write


def _ticks(
    inputs: Mapping[str, Any], kinds: Mapping[str, Type], services: Services, now_ns: int
) -> Results:
    return {"ret_val": now_ns // NS_PER_MS & 0x7FFF_FFFF}


def _runtime(
    inputs: Mapping[str, Any], kinds: Mapping[str, Type], services: Services, now_ns: int
) -> Results:
    now = (now_ns + _NS_PER_S) / _NS_PER_S
    before = inputs["MEM"]
    return {"mem": now, "ret_val": 0.0 if before == 0 else now - before}


CLOCKS: dict[str, _Clock] = {
    "RD_SYS_T": _reader("OUT"),
    "RD_LOC_T": _reader("OUT"),
    "READ_CLK": _reader("CDT"),
    "WR_SYS_T": _writer("IN"),
    "WR_LOC_T": _writer("LOCTIME"),
    "SET_CLK": _writer("PDT"),
    "TIME_TCK": _ticks,
    "RUNTIME": _runtime,
}
"""By canonical name."""
