"""What a stub of a scenario gives: the same at each call, a value for each call, or by the clock.

stubs:
  READ_LEVEL:
    RET_VAL: [16#7001, 16#7002, 0]        # call by call; the last one stays
    level: {0 s: 35, 500 ms: 80}          # from these instants on
"""

from bisect import bisect_right
from collections.abc import Callable, Mapping
from typing import Annotated, Any, TypeAlias

from pydantic import Discriminator, Field, Tag

from harness.durations import DurationNs
from harness.engine.stubs import Stub
from harness.scenario.scalars import Scalar, ScalarValue


def _kind(value: Any) -> str:
    if isinstance(value, list | tuple):
        return "values call by call"
    return "values by the clock" if isinstance(value, dict) else "a value"


StubTable: TypeAlias = Scalar | tuple[Scalar, ...] | dict[int, Scalar]
StubValue = Annotated[
    Annotated[ScalarValue, Tag("a value")]
    | Annotated[tuple[ScalarValue, ...], Field(min_length=1), Tag("values call by call")]
    | Annotated[dict[DurationNs, ScalarValue], Field(min_length=1), Tag("values by the clock")],
    Discriminator(_kind),
]
"""One output of a stub."""


def stub_of(
    outputs: Mapping[str, StubTable],
    read: Callable[[Scalar], Scalar],
    now_ns: Callable[[], int],
) -> Stub:
    """A stub that gives what the tables say; `read` makes values of what stands in the file."""
    sources = {name: _source(table, read, now_ns) for name, table in outputs.items()}
    calls = 0

    def stub(**_: object) -> Mapping[str, Scalar]:
        nonlocal calls
        calls += 1
        return {name: source(calls - 1) for name, source in sources.items()}

    return stub


def _source(
    table: StubTable, read: Callable[[Scalar], Scalar], now_ns: Callable[[], int]
) -> Callable[[int], Scalar]:
    """Gives an output by the number of the call, from 0."""
    if isinstance(table, tuple):
        values = [read(value) for value in table]
        return lambda call: values[min(call, len(values) - 1)]
    if isinstance(table, dict):
        instants = sorted(table)
        by_instant = [read(table[instant]) for instant in instants]
        return lambda _: by_instant[max(bisect_right(instants, now_ns()) - 1, 0)]
    value = read(table)
    return lambda _: value
