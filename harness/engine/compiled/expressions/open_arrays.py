"""ARRAY[*]: an array together with its bounds, as it is handed over."""

from collections.abc import Sequence
from typing import Any

from harness.engine.compiled.library.stops import IndexOutside


class OpenArray:
    """The elements of an array, the last index fastest, and the bounds of its dimensions."""

    __slots__ = ("bounds", "elements")

    def __init__(self, elements: list[Any], bounds: Sequence[tuple[int, int]]) -> None:
        self.elements = elements
        self.bounds = bounds

    def at(self, index: int) -> int:
        """The position of an element of an array of one dimension."""
        first, last = self.bounds[0]
        if first <= index <= last:
            return index - first
        raise IndexOutside(index, 1, (first, last))

    def at_all(self, *indices: int) -> int:
        """The position of an element."""
        position = 0
        for dimension, (index, (first, last)) in enumerate(
            zip(indices, self.bounds, strict=True), 1
        ):
            if not first <= index <= last:
                raise IndexOutside(index, dimension, (first, last))
            position = position * (last - first + 1) + index - first
        return position
