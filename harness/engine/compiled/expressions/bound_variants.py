"""What a VARIANT, ANY or POINTER is bound to; None stands for NULL."""

from typing import Any

from fbgen.lang.types import ArrayType, Type


class Variant:
    """A type and what has it: a cell for a single value, a flat list, else the object itself."""

    __slots__ = ("kind", "target")

    def __init__(self, kind: Type, target: Any) -> None:
        self.kind = kind
        self.target = target

    @property
    def element(self) -> Type | None:
        """The type of the elements of an array."""
        return self.kind.element if isinstance(self.kind, ArrayType) else None
