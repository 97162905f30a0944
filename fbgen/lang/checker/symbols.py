"""What the names of a block mean: its variables and named constants."""

from collections.abc import Callable
from typing import TypeAlias

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Variable
from fbgen.lang.types import Enumeration, Scalar, Type
from fbgen.source import Span


@dataclass(frozen=True, slots=True, eq=False)
class NamedConstant:
    """A name for a value; the value takes its place wherever the name stands."""

    span: Span
    name: str
    type: Type
    value: Scalar


@dataclass(slots=True, eq=False)
class PendingSymbol:
    """A name that nobody has asked for yet: a constant (they may name each other), or an external.

    `is_constant`: a variable that comes out of it may not be written.
    """

    span: Span
    name: str
    evaluate: Callable[[], "NamedConstant | Variable"]
    is_constant: bool
    busy: bool = False


Symbol: TypeAlias = Variable | NamedConstant
Entry: TypeAlias = Variable | NamedConstant | PendingSymbol


class Scope:
    """The names declared in one block, or the global ones, by casefolded name."""

    __slots__ = ("entries", "enumerations", "read_only")

    def __init__(self) -> None:
        self.entries: dict[str, Entry] = {}
        self.enumerations: list[Enumeration] = []
        """Those that variables have without a name of their own."""
        self.read_only: set[Variable] = set()
        """Constants that are arrays or structures: variables that nobody may write."""

    def names(self) -> list[str]:
        """All names as declared, for a help text."""
        return [entry.name for entry in self.entries.values()]
