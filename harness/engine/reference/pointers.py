"""References: cells that hold the storage they refer to."""

from fbgen.lang.types import ReferenceType
from harness.engine.interface import State, Value
from harness.engine.reference.storage import Storage


class Pointed(int):
    """The value of a reference: 1, and what it refers to; 0 for nothing."""

    storage: Storage | None

    def __new__(cls, storage: Storage | None) -> "Pointed":
        self = super().__new__(cls, storage is not None)
        self.storage = storage
        return self

    def __repr__(self) -> str:
        """As it reads from outside."""
        return repr(bool(self))


class ReferenceCell(Storage):
    """A variable that is a reference."""

    __slots__ = ("_kind", "_storage")

    def __init__(self, kind: ReferenceType) -> None:
        self._kind = kind
        self._storage: Storage | None = None

    @property
    def kind(self) -> ReferenceType:
        """The type of the reference."""
        return self._kind

    def read(self) -> Pointed:
        """What it refers to."""
        return Pointed(self._storage)

    def write(self, value: Value) -> None:
        """Refer to something else; from outside comes FALSE, which is nothing."""
        self._storage = value.storage if isinstance(value, Pointed) else None

    def snapshot(self) -> State:
        """What it refers to."""
        return self._storage

    def restore(self, state: State) -> None:
        """What it referred to."""
        assert state is None or isinstance(state, Storage)
        self._storage = state
