"""What generating and running the Python of a program needs of its surroundings."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from harness.engine.compiled.library.timers import Clock
from harness.engine.environment import Environment, StandaloneEnvironment

_GENERATOR_DEPTH = 60_000
"""Python calls that the generator may nest; they need no C stack."""


@contextmanager
def room_for_generation() -> Iterator[None]:
    """Let the generator nest its calls as deep as the program is nested."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, _GENERATOR_DEPTH))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)


def clock_of(environment: Environment) -> Clock:
    """What timers read the time from; a kernel has it as a plain attribute, which is faster."""
    return environment.kernel if isinstance(environment, StandaloneEnvironment) else environment
