"""A variable as an area of bytes, for system instructions (ANY, VARIANT)."""

from fbgen.lang.layout import no_layout
from fbgen.lang.types import Type
from fbgen.source import Span
from harness.engine.interface import Value
from harness.engine.layout import decode, encode, size_bytes
from harness.engine.reference.storage import InstanceStorage, Storage


class StorageArea:
    """The bytes of a storage in S7 layout; implements `environment.Area`."""

    __slots__ = ("_storage",)

    def __init__(self, storage: Storage, span: Span) -> None:
        if isinstance(storage, InstanceStorage):
            raise no_layout(span, storage.kind)
        self._storage = storage

    @property
    def type(self) -> Type:
        """The declared type of the variable."""
        return self._storage.kind

    @property
    def length(self) -> int:
        """Its length in bytes."""
        return size_bytes(self._storage.kind)

    def read(self) -> bytes:
        """All bytes of the variable."""
        stretch = self._storage.stretch
        if stretch is not None:
            return stretch.read()
        return encode(self._storage.kind, self._storage.read())

    def write(self, data: bytes) -> None:
        """Set the variable from its first bytes; the rest stays, what is too much is left out."""
        kind, stretch = self._storage.kind, self._storage.stretch
        if stretch is not None:
            stretch.write(data)
            return
        memory = bytearray(self.read())
        memory[: len(data)] = data[: len(memory)]
        value: Value = decode(kind, bytes(memory))
        self._storage.write(value)
