"""DTL to and from nanoseconds since 1970. Source: TIA Portal help, "DTL"."""

from collections.abc import Mapping
from datetime import UTC, datetime, timedelta

from fbgen.source import Span
from harness.engine.faults import no_date
from harness.engine.interface import Value

_EPOCH = datetime(1970, 1, 1, tzinfo=UTC)
_LAST_YEAR = 2553
_NS_PER_S = 1_000_000_000


def stamp_of(parts: Mapping[str, Value], span: Span) -> int:
    """The instant of a DTL; WEEKDAY does not matter. Raises FB6032."""
    numbers = {name: int(str(value)) for name, value in parts.items()}
    names = ("YEAR", "MONTH", "DAY", "HOUR", "MINUTE", "SECOND")
    try:
        moment = datetime(*(numbers[name] for name in names), tzinfo=UTC)  # type: ignore[arg-type,misc]  # six whole numbers
    except ValueError:
        raise no_date(span) from None
    if not _EPOCH.year <= moment.year <= _LAST_YEAR or numbers["NANOSECOND"] >= _NS_PER_S:
        raise no_date(span)
    return (moment - _EPOCH) // timedelta(seconds=1) * _NS_PER_S + numbers["NANOSECOND"]


def parts_of(nanoseconds: int) -> dict[str, Value]:
    """The parts of an instant."""
    seconds, rest = divmod(nanoseconds, _NS_PER_S)
    moment = _EPOCH + timedelta(seconds=seconds)
    return {
        "YEAR": moment.year,
        "MONTH": moment.month,
        "DAY": moment.day,
        "WEEKDAY": moment.isoweekday() % 7 + 1,
        "HOUR": moment.hour,
        "MINUTE": moment.minute,
        "SECOND": moment.second,
        "NANOSECOND": rest,
    }
