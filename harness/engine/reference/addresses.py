"""Absolute addresses that are worked out while the program runs."""

from collections.abc import Callable

from fbgen.lang.checked import Address, Expression, MemoryRef
from fbgen.lang.types import Elementary, Type
from fbgen.source import Span
from harness.engine.faults import address_out_of_range, no_data_block, unknown_area
from harness.engine.layout import S7
from harness.engine.reference.frames import Frame
from harness.engine.reference.memory import Memory, MemoryCell, spelling
from harness.engine.reference.storage import Storage

_AREAS = {
    1: ("I", True),
    2: ("Q", True),
    0x81: ("I", False),
    0x82: ("Q", False),
    0x83: ("M", False),
    0x84: ("DB", False),
}


class Addresses:
    """Finds what lies at an address."""

    __slots__ = ("_index", "_memory", "_view")

    def __init__(
        self,
        memory: Memory,
        index: Callable[[Expression, Frame], int],
        view: Callable[[Type, bytearray, int], Storage],
    ) -> None:
        self._memory = memory
        self._index = index
        self._view = view

    def find(self, place: MemoryRef, frame: Frame) -> Storage:
        """The storage at the address. Raises FB6010, FB6011 and FB6040."""
        code = self._index(place.area, frame)
        number = 0 if place.db is None else self._index(place.db, frame)
        byte = self._index(place.byte, frame)
        bit = 0 if place.bit is None else self._index(place.bit, frame)
        if code not in _AREAS:
            raise unknown_area(place.span, code)
        area, peripheral = _AREAS[code]
        kind = place.type
        bits = kind.bits if isinstance(kind, Elementary) else 8
        address = Address(area, bits, byte, bit, number, peripheral)
        memory = self._bytes(address, place.span)
        size = max(S7.used_bits(kind) + bit + 7, 8) // 8
        if byte < 0 or not 0 <= bit <= 7 or (not peripheral and byte + size > len(memory)):
            raise address_out_of_range(place.span, spelling(address), len(memory))
        if isinstance(kind, Elementary):
            return MemoryCell(kind, address, self._memory, place.span)
        return self._view(kind, memory, 8 * byte + bit)

    def area(self, span: Span, code: int, number: int, byte: int, count: int) -> bytearray:
        """The memory in which so many bytes lie. Raises FB6010, FB6011 and FB6040."""
        area, peripheral = _AREAS.get(code, ("", True))
        if peripheral:
            raise unknown_area(span, code)
        address = Address(area, 8, byte, 0, number)
        memory = self._bytes(address, span)
        if byte < 0 or byte + count > len(memory):
            raise address_out_of_range(span, spelling(address), len(memory))
        return memory

    def _bytes(self, address: Address, span: Span) -> bytearray:
        if address.area == "DB":
            block = self._memory.data_block(address.db)
            if block is None:
                raise no_data_block(span, address.db)
            return block
        environment = self._memory.environment
        images = {"I": environment.inputs, "Q": environment.outputs, "M": environment.markers}
        return images[address.area]
