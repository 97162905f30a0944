"""Variables as areas of bytes: for instructions, for `DB1.DBW2`, and located variables."""

from typing import Any

from fbgen.lang.checked import Address, AddressRef, VariableRef
from fbgen.lang.types import Scalar, Type
from harness.engine.compiled.addresses import spelled
from harness.engine.compiled.memory import Location, Memory
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
        return encode(self.type, self._memory.export(self.type, self._location.read()))

    def write(self, data: bytes) -> None:
        """Set the variable from its first bytes; the rest stays."""
        content = data + self.read()[len(data) :] if len(data) < self.length else data
        value = decode(self.type, content[: self.length])
        self._memory.load("area", self._location, value)


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
        raise address_out_of_range(None, spelled(address), len(image))
    return image


class BlockBytes:
    """The bytes of one data block, for absolute access to it."""

    __slots__ = ("_area",)

    def __init__(self, memory: Memory, kind: Type, data: Any) -> None:
        location = Location(kind, lambda: data, lambda _: None)
        self._area = VariableArea(memory, location)

    def read(self, node: AddressRef | VariableRef, address: Address) -> int:
        """The byte, word or double word at the address."""
        count = self._count(node, address)
        return int.from_bytes(self._area.read()[address.byte : address.byte + count], "big")

    def write(self, node: AddressRef | VariableRef, address: Address, value: int | bool) -> None:
        """Set the bit, byte, word or double word at the address."""
        count = self._count(node, address)
        data = bytearray(self._area.read())
        if address.bits == 1:
            mask = 1 << address.bit
            data[address.byte] = data[address.byte] & ~mask | (mask if value else 0)
        else:
            data[address.byte : address.byte + count] = int(value).to_bytes(count, "big")
        self._area.write(bytes(data))

    def _count(self, node: AddressRef | VariableRef, address: Address) -> int:
        count = max(1, address.bits // 8)
        if address.byte + count > self._area.length:
            raise address_out_of_range(node.span, spelled(address), self._area.length)
        return count
