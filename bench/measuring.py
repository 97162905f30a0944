"""Measuring on a machine that others use too.

A figure is the smallest of many short windows, and the empty loop is measured between them in
windows of the same length: both then stand for the same undisturbed processor, and their ratio
hardly depends on the machine.
"""

from collections.abc import Callable
from dataclasses import dataclass
from gc import disable, enable
from time import perf_counter

_WINDOW_S = 0.001
_WINDOWS = 500
_LONGEST_WINDOW_S = 0.1


@dataclass(frozen=True, slots=True)
class Figure:
    """One measured cost. `turns` is how many turns of the empty loop it takes."""

    name: str
    seconds: float
    turns: float
    limit: str = ""

    def __str__(self) -> str:
        text = f"{self.name:<52} {_readable(self.seconds):>12} {self.turns:>12,.1f} turns"
        return f"{text}   {self.limit}".rstrip()


def _readable(seconds: float) -> str:
    for factor, unit in ((1e9, "ns"), (1e6, "us"), (1e3, "ms")):
        if seconds * factor < 1000:
            return f"{seconds * factor:.1f} {unit}"
    return f"{seconds:.2f} s"


def _empty_loop(turns: int) -> float:
    start = perf_counter()
    for _ in range(turns):
        pass
    return (perf_counter() - start) / turns


def _repeated(action: Callable[[], object], count: int) -> float:
    start = perf_counter()
    for _ in range(count):
        action()
    return (perf_counter() - start) / count


def measure(
    name: str, action: Callable[[], object], limit: str = "", per: int = 1, windows: int = _WINDOWS
) -> Figure:
    """What one call of `action` costs, divided by `per`; the loop around it is taken off."""
    action()
    once = min(_repeated(action, 1) for _ in range(3))
    count = max(1, int(_WINDOW_S / once))
    turns = int(min(max(once, _WINDOW_S), _LONGEST_WINDOW_S) / _empty_loop(1_000))
    costs: list[float] = []
    loops: list[float] = []
    disable()
    try:
        for _ in range(windows):
            loops.append(_empty_loop(turns))
            costs.append(_repeated(action, count))
    finally:
        enable()
    turn = min(loops)
    seconds = (min(costs) - turn) / per
    return Figure(name, seconds, seconds / turn, limit)
