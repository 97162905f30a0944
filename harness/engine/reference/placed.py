"""Variables that lie in bytes: cells of a memory that others may reach as well."""

from fbgen.lang.types import Elementary, Scalar, StringType
from harness.engine.interface import State, Value
from harness.engine.layout import Layout
from harness.engine.reference.storage import Storage


class ByteCell(Storage):
    """A scalar at a bit of a memory. The memory is remembered by whoever it belongs to."""

    __slots__ = ("_bit", "_kind", "_layout", "_memory")

    def __init__(
        self, kind: Elementary | StringType, layout: Layout, memory: bytearray, bit: int
    ) -> None:
        self._kind = kind
        self._layout = layout
        self._memory = memory
        self._bit = bit

    @property
    def kind(self) -> Elementary | StringType:
        """The type of the scalar."""
        return self._kind

    def place(self) -> tuple[bytearray, int]:
        """The memory and the bit."""
        return self._memory, self._bit

    def read(self) -> Scalar:
        """What the bytes mean as a value of the type."""
        value = self._layout.read(self._memory, self._bit, self._kind)
        assert isinstance(value, bool | int | float | str)
        return value

    def write(self, value: Value) -> None:
        """Set the bytes; a text that is too long loses its end."""
        if isinstance(self._kind, StringType):
            value = str(value)[: self._kind.length]
        self._layout.write(self._memory, self._bit, self._kind, value)

    def snapshot(self) -> State:
        """The value is in the memory."""
        return None

    def restore(self, state: State) -> None:
        """The value is in the memory."""

    def reset(self, fresh: Storage, warm: bool) -> None:
        """The bytes of a fresh cell, as they are."""
        assert isinstance(fresh, ByteCell)
        if self._kind.name == "BOOL":
            self.write(fresh.read())
            return
        start, size = self._bit >> 3, self._layout.size_bytes(self._kind)
        first = fresh._bit >> 3
        self._memory[start : start + size] = fresh._memory[first : first + size]
