"""Start values of a data block while they are collected: one assignment after the other changes one
part. Initial values are never changed; to copy them for each assignment would take a data block
with thousands of start values a time that grows with the square of their number.
"""

from typing import TypeAlias

from fbgen.lang.types import ArrayInitial, Initial, StructInitial


class OpenStruct:
    """The values of the named parts of a structure, to be changed."""

    __slots__ = ("named",)

    def __init__(self, base: "Started") -> None:
        self.named: dict[str, Started] = {}
        if isinstance(base, StructInitial):
            self.named.update(base.fields)


class OpenArray:
    """The values of the elements of an array, to be changed."""

    __slots__ = ("items",)

    def __init__(self, base: "Started", count: int) -> None:
        self.items: list[Started] = [None] * count
        if isinstance(base, ArrayInitial):
            self.items = list(base.items)


Started: TypeAlias = Initial | OpenStruct | OpenArray | None
"""What is known of the start value of some part."""


def closed(value: Started) -> Initial | None:
    """The value as it is from now on."""
    if isinstance(value, OpenStruct):
        parts = ((name, closed(inner)) for name, inner in value.named.items())
        return StructInitial(tuple((name, inner) for name, inner in parts if inner is not None))
    if isinstance(value, OpenArray):
        return ArrayInitial(tuple(closed(item) for item in value.items))
    return value
