"""References: cells that hold the storage they refer to."""

from fbgen.lang.types import ReferenceType
from fbgen.source import Span
from harness.engine.interface import State, Value
from harness.engine.reference.storage import Storage


class Pointed(int):
    """The value of a reference: 1, and what it refers to; 0 for nothing."""

    _storage: Storage | None

    def __new__(cls, storage: Storage | None) -> "Pointed":
        self = super().__new__(cls, storage is not None)
        self._storage = storage
        return self

    def find(self, _span: Span | None) -> Storage | None:
        """What it refers to."""
        return self._storage

    def __repr__(self) -> str:
        """As it reads from outside."""
        return repr(bool(self))


NOTHING = Pointed(None)
"""What a reference starts with."""


class ReferenceCell(Storage):
    """A variable that is a reference."""

    __slots__ = ("_kind", "_pointed")

    def __init__(self, kind: ReferenceType) -> None:
        self._kind = kind
        self._pointed = NOTHING

    @property
    def kind(self) -> ReferenceType:
        """The type of the reference."""
        return self._kind

    def read(self) -> Pointed:
        """What it refers to."""
        return self._pointed

    def write(self, value: Value) -> None:
        """Refer to something else; from outside comes FALSE, which is nothing."""
        self._pointed = value if isinstance(value, Pointed) else NOTHING

    def snapshot(self) -> State:
        """What it refers to."""
        return self._pointed

    def restore(self, state: State) -> None:
        """What it referred to."""
        assert isinstance(state, Pointed)
        self._pointed = state
