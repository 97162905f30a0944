"""Variables as areas of bytes: for instructions, for `DB1.DBW2`, and located variables."""

from typing import Any

from fbgen.lang.checked import Address
from fbgen.lang.types import Scalar, Type
from harness.engine.compiled.data.cells import Cell
from harness.engine.compiled.data.memory import Location, Memory
from harness.engine.compiled.library.placed import ByteArray, ByteStructure
from harness.engine.environment import Environment
from harness.engine.faults import address_out_of_range
from harness.engine.layout import decode, encode, size_bytes


class VariableArea:
    """A variable handed to an instruction."""

    __slots__ = ("_location", "_memory")

    def __init__(self, memory: Memory, location: Location) -> None:
        self._memory = memory
        self._location = location

    @property
    def type(self) -> Type:
        """The declared type of the variable."""
        return self._location.kind

    @property
    def length(self) -> int:
        """Its length in bytes."""
        return size_bytes(self.type)

    def read(self) -> bytes:
        """All bytes of the variable."""
        data = self._location.read()
        if isinstance(data, ByteArray | ByteStructure):
            return data.read()
        return encode(self.type, self._memory.export(self.type, data))

    def write(self, data: bytes) -> None:
        """Set the variable from its first bytes; the rest stays."""
        target = self._location.read()
        if isinstance(target, ByteArray | ByteStructure):
            target.write(data[: target.size])
            return
        content = data + self.read()[len(data) :] if len(data) < self.length else data
        value = decode(self.type, content[: self.length])
        self._memory.load("area", self._location, value)


def fixed_location(kind: Type, data: Any) -> Location:
    """Where a structure, an array or an instance is."""
    return Location(kind, lambda: data, lambda _: None)


def cell_location(kind: Type, cell: Cell) -> Location:
    """Where a single value is."""

    def write(value: Any) -> None:
        cell.value = value

    return Location(kind, lambda: cell.value, write)


def read_located(environment: Environment, address: Address, kind: Type) -> Scalar:
    """The value of a variable with an absolute address, as it stands in the image."""
    image = _image(environment, address)
    if address.bits == 1:
        return bool(image[address.byte] >> address.bit & 1)
    data = bytes(image[address.byte : address.byte + address.bits // 8])
    value = decode(kind, data)
    assert isinstance(value, bool | int | float | str)
    return value


def write_located(environment: Environment, address: Address, kind: Type, value: Scalar) -> None:
    """Put a value where a variable with an absolute address is."""
    image = _image(environment, address)
    if address.bits == 1:
        mask = 1 << address.bit
        image[address.byte] = image[address.byte] & ~mask | (mask if value else 0)
    else:
        image[address.byte : address.byte + address.bits // 8] = encode(kind, value)


def _image(environment: Environment, address: Address) -> bytearray:
    image = {
        "I": environment.inputs,
        "Q": environment.outputs,
        "M": environment.markers,
    }[address.area]
    if address.byte + max(1, address.bits // 8) > len(image):
        raise address_out_of_range(None, address.spelled, len(image))
    return image
