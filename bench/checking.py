"""`fbgen check` on programs of many sizes: time, memory, and what one statement costs."""

import gc
import tracemalloc
from collections.abc import Iterator
from time import process_time

from bench.measuring import Figure, measure
from bench.plc_text import plc_text
from fbgen.lang.ast import File
from fbgen.lang.checker import check_reporting
from fbgen.lang.parser import parse_recovering
from fbgen.source import Source

_SIZES = (1_000, 10_000, 30_000, 100_000)
_RUNS = 3


def figures() -> Iterator[Figure | str]:
    """Reading and checking, by the size of the program."""
    empty = measure("", lambda: [None for _ in range(1000)], per=1000)
    turn = empty.seconds / max(empty.turns, 1e-9)
    for size in _SIZES:
        text = plc_text(size)
        lines = text.count("\n")
        best, checking = min(_seconds(text) for _ in range(_RUNS))
        limit = "at most 2.5 s" if size == 30_000 else ""
        yield Figure(f"fbgen check of {lines:,} lines", best, best / turn, limit)
        cost = checking / lines
        yield Figure("  of it names, types and paths, a line", cost, cost / turn)
    for size in _SIZES[:3]:
        yield _memory(size)


def _seconds(text: str) -> tuple[float, float]:
    """Seconds of the processor for everything, and for the checker alone."""
    gc.collect()
    start = process_time()
    file = _read(text)
    middle = process_time()
    findings = check_reporting([file], "tia")[1]
    end = process_time()
    assert not findings, "the program of the bench has no mistakes"
    return end - start, end - middle


def _read(text: str) -> File:
    return parse_recovering(Source("bench.scl", text), "tia")[0]


def _memory(size: int) -> str:
    """The most memory at one time."""
    text = plc_text(size)
    lines = text.count("\n")
    tracemalloc.start()
    check_reporting([_read(text)], "tia")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    return f"peak memory at {lines:,} lines: {peak / 1e6:.0f} MB, {peak / lines:,.0f} bytes a line"
