"""The timers T and counters C of the controller, called from SCL.

A timer counts the units of its S5TIME (three digits and a base of 10 ms to 10 s); a call gives what
is left, in BCD with the base, and in BI as a plain number of units. R wins. A counter holds 0 to
999; R wins over S, S over counting. Source: STEP 7 V5, S7-SCL manual, "Counters" and "Timers".
"""

from collections.abc import Callable, Mapping
from dataclasses import astuple

from fbgen.dataclass import dataclass
from harness.engine.interface import State, Value
from harness.engine.reference.date_functions import S5_BASES_MS, coded, decimal_digits
from harness.engine.reference.routine_operands import Operands

_NS_PER_MS = 1_000_000
_MOST = 999


@dataclass(slots=True)
class _Timer:
    """`began_ns` is None unless it runs. `ended`: it ran to its end since the last start."""

    previous: bool = False
    began_ns: int | None = None
    units: int = 0
    base: int = 0
    ended: bool = False

    def left(self, now_ns: int) -> int:
        """The units that are left."""
        if self.began_ns is None:
            return 0
        passed = (now_ns - self.began_ns) // (S5_BASES_MS[self.base] * _NS_PER_MS)
        return max(self.units - passed, 0)


@dataclass(slots=True)
class _Counter:
    previous_up: bool = False
    previous_down: bool = False
    previous_set: bool = False
    count: int = 0


class S5Memory:
    """The timers and counters of one controller, by number; those not used yet stand at zero."""

    __slots__ = ("counters", "timers")

    def __init__(self) -> None:
        self.timers: dict[int, _Timer] = {}
        self.counters: dict[int, _Counter] = {}

    def snapshot(self) -> State:
        """All that differs from the start."""
        timers = sorted((number, astuple(one)) for number, one in self.timers.items())
        counters = sorted((number, astuple(one)) for number, one in self.counters.items())
        return tuple(timers), tuple(counters)

    def restore(self, state: State) -> None:
        """Back to a snapshot."""
        assert isinstance(state, tuple)
        timers, counters = state
        self.timers = {number: _Timer(*saved) for number, saved in timers}
        self.counters = {number: _Counter(*saved) for number, saved in counters}

    def reset(self) -> None:
        """Everything at zero."""
        self.timers.clear()
        self.counters.clear()


Routine = Callable[[Operands, S5Memory, int], Mapping[str, Value]]


def _timing(
    starts: Callable[[bool, bool], bool], stops: bool, output: str, keeps: bool = False
) -> Routine:
    """A kind of timer.

    `starts` says when it starts, from S before and now; `stops`: it stops when S becomes FALSE.
    `output` names when Q is TRUE. `keeps`: once it has ended, only R lets it start again.
    """

    def run(operands: Operands, memory: S5Memory, now_ns: int) -> Mapping[str, Value]:
        timer = memory.timers.setdefault(operands.whole("T_NO"), _Timer())
        before, signal = timer.previous, operands.flag("S")
        timer.previous = signal
        if timer.began_ns is not None and timer.left(now_ns) == 0:
            timer.began_ns, timer.ended = None, True
        if operands.flag("R"):
            timer.began_ns, timer.ended = None, False
        elif starts(before, signal) and not (timer.ended and keeps):
            word = operands.whole("TV")
            timer.units = decimal_digits(word, operands.span)
            timer.base = word >> 12 & 3
            timer.ended = timer.units == 0
            timer.began_ns = None if timer.ended else now_ns
        elif (stops and before and not signal) or (output == "off delay" and signal):
            timer.began_ns, timer.ended = None, False
        left = timer.left(now_ns)
        is_on = {
            "running": left > 0,
            "ended": timer.ended and (signal or not stops),
            "off delay": (signal or left > 0) and not operands.flag("R"),
        }[output]
        value = timer.base << 12 | coded(left) if timer.began_ns is not None else 0
        return {"ret_val": value, "bi": left, "q": is_on}

    return run


def _rises(before: bool, now: bool) -> bool:
    return now and not before


def _falls(before: bool, now: bool) -> bool:
    return before and not now


def _count(operands: Operands, memory: S5Memory, now_ns: int) -> Mapping[str, Value]:
    counter = memory.counters.setdefault(operands.whole("C_NO"), _Counter())
    up, down, sets = operands.flag("CU"), operands.flag("CD"), operands.flag("S")
    if up and not counter.previous_up:
        counter.count = min(counter.count + 1, _MOST)
    if down and not counter.previous_down:
        counter.count = max(counter.count - 1, 0)
    if sets and not counter.previous_set:
        counter.count = decimal_digits(operands.whole("PV"), operands.span)
    if operands.flag("R"):
        counter.count = 0
    counter.previous_up, counter.previous_down, counter.previous_set = up, down, sets
    return {"ret_val": coded(counter.count), "cv": counter.count, "q": counter.count > 0}


S5_ROUTINES: dict[str, Routine] = {
    "S_PULSE": _timing(_rises, stops=True, output="running"),
    "S_PEXT": _timing(_rises, stops=False, output="running"),
    "S_ODT": _timing(_rises, stops=True, output="ended"),
    "S_ODTS": _timing(_rises, stops=False, output="ended", keeps=True),
    "S_OFFDT": _timing(_falls, stops=False, output="off delay"),
    **dict.fromkeys(("S_CU", "S_CD", "S_CUD"), _count),
}
"""By canonical name."""
