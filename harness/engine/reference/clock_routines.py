"""The calendar clock, the system time, and what works on the running scan.

The local time is the system time: the controller has no time zone. DATE_AND_TIME has milliseconds.
Sources as for `fbgen.lang.checker.supplied.routines.clock`; the units of DTL: TIA
Portal help, "DTL".
"""

from collections.abc import Callable, Mapping

from fbgen.dataclass import dataclass
from fbgen.lang.types import DATE_AND_TIME, Elementary, StructType
from harness.engine.faults import stop_requested
from harness.engine.interface import Value
from harness.engine.reference.calendar import (
    NS_PER_MS,
    count_of,
    instant_of,
    stamp_of_parts,
    stamp_parts,
    weekday,
)
from harness.engine.reference.routine_operands import Operands
from harness.engine.services import Services

_NS_PER_S = 1_000_000_000
_INVALID_DATE = 0x8080


@dataclass(frozen=True, slots=True)
class Clocked:
    """The controller at the instant of a call; `retrigger` starts the watchdog anew."""

    services: Services
    now_ns: int
    retrigger: Callable[[], None]


Routine = Callable[[Operands, Clocked], Mapping[str, Value]]


def _reading(output: str) -> Routine:
    def read(operands: Operands, clocked: Clocked) -> Mapping[str, Value]:
        stamp_ns = clocked.services.calendar_ns + clocked.now_ns
        kind = operands.kinds.get(output)
        if isinstance(kind, StructType):
            return {output.casefold(): _as_structure(stamp_ns), "ret_val": 0}
        if kind == DATE_AND_TIME:
            stamp_ns -= stamp_ns % NS_PER_MS
        assert isinstance(kind, Elementary)
        return {output.casefold(): count_of(kind, stamp_ns), "ret_val": 0}

    return read


def _as_structure(stamp_ns: int) -> dict[str, Value]:
    parts: dict[str, Value] = {
        name: number for name, number in stamp_parts(stamp_ns).items() if name != "millisecond"
    }
    return parts | {"weekday": weekday(stamp_ns) + 1, "nanosecond": stamp_ns % _NS_PER_S}


def _setting(name: str) -> Routine:
    def write(operands: Operands, clocked: Clocked) -> Mapping[str, Value]:
        value = operands.values[name]
        if isinstance(value, Mapping):
            parts = {key.casefold(): int(str(part)) for key, part in value.items()}
            try:
                stamp_ns = stamp_of_parts(parts, parts["nanosecond"])
            except (ValueError, OverflowError):
                return {"ret_val": _INVALID_DATE}
        else:
            stamp_ns = instant_of(operands.kinds[name], operands.whole(name))
        clocked.services.calendar_ns = stamp_ns - clocked.now_ns
        return {"ret_val": 0}

    return write


def _tick(operands: Operands, clocked: Clocked) -> Mapping[str, Value]:
    return {"ret_val": clocked.now_ns // NS_PER_MS % (1 << 31)}


def _runtime(operands: Operands, clocked: Clocked) -> Mapping[str, Value]:
    """Seconds since the last call with this memory, which holds the instant plus a second."""
    before, now = operands.real("MEM"), (clocked.now_ns + _NS_PER_S) / _NS_PER_S
    return {"mem": now, "ret_val": now - before if before else 0.0}


def _retrigger(operands: Operands, clocked: Clocked) -> Mapping[str, Value]:
    clocked.retrigger()
    return {}


def _stop(operands: Operands, clocked: Clocked) -> Mapping[str, Value]:
    """Raises FB6016."""
    raise stop_requested(operands.span)


CLOCK_ROUTINES: dict[str, Routine] = {
    "RD_SYS_T": _reading("OUT"),
    "RD_LOC_T": _reading("OUT"),
    "READ_CLK": _reading("CDT"),
    "WR_SYS_T": _setting("IN"),
    "WR_LOC_T": _setting("LOCTIME"),
    "SET_CLK": _setting("PDT"),
    "TIME_TCK": _tick,
    "RUNTIME": _runtime,
    "RE_TRIGR": _retrigger,
    "STP": _stop,
}
"""By canonical name."""
