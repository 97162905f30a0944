"""Whole commands as fresh processes, in a warm environment."""

import subprocess
import sys
from collections.abc import Iterator
from time import perf_counter

from bench.measuring import Figure, measure

_RUNS = 7


def figures() -> Iterator[Figure]:
    """What a user waits for."""
    empty = measure("", lambda: [None for _ in range(1000)], per=1000)
    turn = empty.seconds / max(empty.turns, 1e-9)
    for arguments, limit in (
        (("--help",), "at most 0.3 s"),
        (("demo",), "at most 2 s"),
        (("decode", "tospbdp001.status", "9F00"), ""),
    ):
        best = min(_seconds(arguments) for _ in range(_RUNS))
        yield Figure(f"fbgen {' '.join(arguments)}", best, best / turn, limit)


def _seconds(arguments: tuple[str, ...]) -> float:
    start = perf_counter()
    command = [sys.executable, "-m", "fbgen.cli", *arguments]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return perf_counter() - start
