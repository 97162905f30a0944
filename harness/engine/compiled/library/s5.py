"""S_PULSE, S_PEXT, S_ODT, S_ODTS, S_OFFDT on the timers T; S_CU, S_CD, S_CUD on the counters C.

Source: STEP 7 V5, S7-SCL manual, "Counters" and "Timers".
"""

from collections.abc import Callable, Mapping
from typing import Any

from harness.engine.compiled.library.decimals import digits_of, word_of

_BASES_NS = (10_000_000, 100_000_000, 1_000_000_000, 10_000_000_000)
_IDLE = (False, False, 0, 0, 0)
"""A timer: S before, ended, the instant of its end (0: it does not run), time base, its unit."""
_ZERO = (0, False, False, False)
"""A counter: its count, then CU, CD and S before."""


class S5Counters:
    """The timers and counters of a controller, by number, as plain tuples."""

    __slots__ = ("counts", "times")

    def __init__(self) -> None:
        self.times: dict[int, tuple[bool, bool, int, int, int]] = {}
        self.counts: dict[int, tuple[int, bool, bool, bool]] = {}

    def snapshot(self) -> tuple[tuple[tuple[int, Any], ...], ...]:
        """Everything, in the order of the numbers."""
        return tuple(sorted(self.times.items())), tuple(sorted(self.counts.items()))

    def restore(self, state: Any) -> None:
        """Back to a snapshot."""
        self.times, self.counts = (dict(part) for part in state)


_Inputs = Mapping[str, Any]
_Results = Mapping[str, Any]


def _timer(kind: str) -> Callable[[S5Counters, _Inputs, int], _Results]:
    def run(memory: S5Counters, inputs: _Inputs, now_ns: int) -> _Results:
        number = inputs["T_NO"]
        before, ended, end_ns, base, start_ns = memory.times.get(number, _IDLE)
        signal, reset = inputs.get("S", False), inputs.get("R", False)
        runs = end_ns != 0
        if runs and now_ns >= end_ns:
            runs, ended = False, True
        begins = before and not signal if kind == "S_OFFDT" else signal and not before
        if kind == "S_ODTS" and ended:
            begins = False
        if reset:
            runs = ended = False
        elif begins:
            word = inputs.get("TV", 0)
            units, base = digits_of(word), word >> 12 & 3
            start_ns, end_ns = now_ns, now_ns + units * _BASES_NS[base]
            runs = units > 0
            ended = not runs
        elif (kind == "S_OFFDT" and signal) or (kind in ("S_PULSE", "S_ODT") and before > signal):
            runs = ended = False
        left = 0
        if runs:
            unit = _BASES_NS[base]
            left = (end_ns - start_ns) // unit - (now_ns - start_ns) // unit
        memory.times[number] = (signal, ended, end_ns if runs else 0, base, start_ns)
        if kind in ("S_PULSE", "S_PEXT"):
            on = runs
        elif kind == "S_OFFDT":
            on = (signal or runs) and not reset
        else:
            on = ended
        return {"ret_val": base << 12 | word_of(left) if runs else 0, "bi": left, "q": on}

    return run


def _count(memory: S5Counters, inputs: _Inputs, now_ns: int) -> _Results:
    number = inputs["C_NO"]
    count, up_before, down_before, set_before = memory.counts.get(number, _ZERO)
    up, down, sets = (inputs.get(name, False) for name in ("CU", "CD", "S"))
    if up and not up_before and count < 999:
        count += 1
    if down and not down_before and count > 0:
        count -= 1
    if sets and not set_before:
        count = digits_of(inputs.get("PV", 0))
    if inputs.get("R", False):
        count = 0
    memory.counts[number] = (count, up, down, sets)
    return {"ret_val": word_of(count), "cv": count, "q": count > 0}


S5: dict[str, Callable[[S5Counters, _Inputs, int], _Results]] = {
    **{name: _timer(name) for name in ("S_PULSE", "S_PEXT", "S_ODT", "S_ODTS", "S_OFFDT")},
    **dict.fromkeys(("S_CU", "S_CD", "S_CUD"), _count),
}
"""By canonical name."""
