"""Cells: references to single values, for in-outs and areas that Python cannot refer to itself."""

from typing import Any, Protocol

from fbgen.lang.types import Scalar
from harness.engine.compiled.library.stops import NullReference


class Cell(Protocol):
    """Something that holds one value."""

    value: Scalar


class ValueCell:
    """A value with no other place to be."""

    __slots__ = ("value",)

    def __init__(self, value: Scalar) -> None:
        self.value = value


class AttributeCell:
    """An attribute of an object."""

    __slots__ = ("_name", "_owner")

    def __init__(self, owner: object, name: str) -> None:
        self._owner = owner
        self._name = name

    def __eq__(self, other: object) -> bool:
        """True for cells of the same attribute."""
        return (
            isinstance(other, AttributeCell)
            and self._owner is other._owner
            and self._name == other._name
        )

    __hash__ = None  # type: ignore[assignment]  # the way Python marks what cannot be hashed

    @property
    def owner(self) -> Any:
        """The object."""
        return self._owner

    @property
    def name(self) -> str:
        """The name of the attribute."""
        return self._name

    @property
    def value(self) -> Scalar:
        """The attribute."""
        content: Scalar = getattr(self._owner, self._name)
        return content

    @value.setter
    def value(self, content: Scalar) -> None:
        setattr(self._owner, self._name, content)


class ElementCell:
    """An element of an array."""

    __slots__ = ("_elements", "_position")

    def __init__(self, elements: list[Scalar], position: int) -> None:
        self._elements = elements
        self._position = position

    def __eq__(self, other: object) -> bool:
        """True for cells of the same element."""
        return (
            isinstance(other, ElementCell)
            and self._elements is other._elements
            and self._position == other._position
        )

    __hash__ = None  # type: ignore[assignment]  # the way Python marks what cannot be hashed

    @property
    def elements(self) -> list[Scalar]:
        """The array."""
        return self._elements

    @property
    def position(self) -> int:
        """Where the element is in the array."""
        return self._position

    @property
    def value(self) -> Scalar:
        """The element."""
        return self._elements[self._position]

    @value.setter
    def value(self, content: Scalar) -> None:
        self._elements[self._position] = content


def same(left: object, right: object) -> bool:
    """True for two references to the same variable, or to nothing."""
    if left is right:
        return True
    return isinstance(left, AttributeCell | ElementCell) and left == right


def target(reference: object) -> object:
    """The structure, array or instance that a reference refers to."""
    if reference is None:
        raise NullReference
    return reference
