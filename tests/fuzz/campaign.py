"""Runs a target on mutated inputs, each with a seed of its own that replays it."""

from collections.abc import Callable
from random import Random
from time import monotonic

from fbgen.diagnostics import DiagnosticError
from tests.fuzz.mutation import mutated
from tests.fuzz.targets import Target

_LONGEST_S = 10.0
"""An input of at most 20 kB takes longer only if something grows out of proportion."""


class Breakage(Exception):  # noqa: N818 - it is what the fuzzer looks for, not an error of its own
    """An input that broke the target."""

    def __init__(self, seed: int, data: bytes, reason: str) -> None:
        super().__init__(f"seed {seed}: {reason}")
        self.seed = seed
        self.data = data
        self.reason = reason


def fuzz(target: Target, seed: int, goes_on: Callable[[int], bool]) -> int:
    """Try inputs from `seed` on while `goes_on(count)`; how many. Raises Breakage."""
    count = 0
    while goes_on(count):
        data = mutated(Random(seed + count), target.corpus)
        start = monotonic()
        try:
            target.run(data)
        except DiagnosticError:
            pass
        except Exception as broken:
            raise Breakage(seed + count, data, f"{type(broken).__name__}: {broken}") from broken
        if (took := monotonic() - start) > _LONGEST_S:
            raise Breakage(seed + count, data, f"it took {took:.1f} s")
        count += 1
    return count
