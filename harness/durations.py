"""Times as people write them: a number with its unit, `500 ms`, as integer nanoseconds."""

import re
from decimal import Decimal
from typing import Annotated

from pydantic import AfterValidator, BeforeValidator
from pydantic.json_schema import WithJsonSchema

from harness.kernel import NS_PER_MS, NS_PER_S, NS_PER_US

LONGEST_NS = 24 * 3600 * NS_PER_S
"""Longer is a slip of the pen: a day takes minutes to simulate."""

_UNITS = {
    "us": NS_PER_US,
    "ms": NS_PER_MS,
    "s": NS_PER_S,
    "min": 60 * NS_PER_S,
    "h": 3600 * NS_PER_S,
}
_DURATION = re.compile(r"([0-9]{1,12}(?:\.[0-9]{1,12})?) ?(us|ms|s|min|h)")


def read_duration(value: object) -> int:
    """The nanoseconds of `1.5 s`. Raises ValueError for what is no time of a scenario."""
    match = _DURATION.fullmatch(value) if isinstance(value, str) else None
    if match is None:
        raise ValueError(
            f"'{value}' is no time: write a number with its unit (us, ms, s, min, h), "
            "such as 500 ms or 2 s"
        )
    time_ns = Decimal(match[1]) * _UNITS[match[2]]
    if time_ns > LONGEST_NS:
        raise ValueError(f"'{value}' is too long: a step takes 24 h at most")
    if time_ns != int(time_ns):
        raise ValueError(f"'{value}' is too fine: the plant's clock counts nanoseconds")
    return int(time_ns)


def _more_than_nothing(time_ns: int) -> int:
    if not time_ns:
        raise ValueError("a wait of nothing: give it a time, or leave the step out")
    return time_ns


DurationNs = Annotated[
    int,
    BeforeValidator(read_duration),
    WithJsonSchema({"type": "string", "pattern": f"^{_DURATION.pattern}$"}),
]
"""A time such as `500 ms`, as integer nanoseconds."""

PositiveDurationNs = Annotated[DurationNs, AfterValidator(_more_than_nothing)]
"""A time that is not 0."""


def show_duration(time_ns: int) -> str:
    """A time for a person: `500 ms`, `2.5 s`."""
    if time_ns < NS_PER_S:
        return f"{time_ns / NS_PER_MS:g} ms"
    return f"{time_ns / NS_PER_S:g} s"
