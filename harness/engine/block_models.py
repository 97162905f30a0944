"""Function blocks of the controller that the controller around the engine carries out itself.

A model is Python, as a stub is, but it comes with the hardware of a plant and gets the areas of the
program (ANY, VARIANT) as bytes in S7 layout. One object stands for one instance; what it remembers
is no part of snapshots of the program.
"""

from collections.abc import Callable, Mapping
from typing import Protocol

from fbgen.lang.types import Scalar


class BlockModel(Protocol):
    """One instance of a block. `areas` names those of its parameters that arrive as bytes."""

    @property
    def areas(self) -> tuple[str, ...]:
        """In upper case, as in the tables of the checker."""

    def call(self, inputs: Mapping[str, Scalar], areas: Mapping[str, bytes]) -> "Outputs":
        """One call; all by upper-case name, as far as the program gives it."""


class Outputs:
    """What a call gives: single values, and areas, whose rest stays where they are shorter."""

    __slots__ = ("areas", "values")

    def __init__(self, areas: Mapping[str, bytes] | None = None, **values: Scalar) -> None:
        self.values = values
        self.areas = areas or {}


ModelFactory = Callable[[], BlockModel]
