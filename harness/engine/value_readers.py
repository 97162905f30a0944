"""Several values of a running program at once, again and again: what a recorder looks at."""

from collections.abc import Callable, Sequence
from typing import TypeAlias

from fbgen.lang.types import Scalar
from harness.engine.interface import Engine

Reader: TypeAlias = Callable[[], tuple[Scalar, ...]]
"""Gives the values now, in the order of the paths."""


def value_reader(engine: Engine, paths: Sequence[str]) -> Reader:
    """A reader of single values. Raises DiagnosticError for what `global_value` does not know."""
    values = [engine.global_value(path) for path in paths]
    assert all(isinstance(value, bool | int | float | str) for value in values)

    def read() -> tuple[Scalar, ...]:
        return tuple([engine.global_value(path) for path in paths])  # type: ignore[misc]

    return read
