"""Absolute addresses that are worked out while the program runs: what generated code calls.

Each place is a cell: PEEK reads it, POKE writes it, an in-out is bound to it.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

from fbgen.lang.checked import MemoryRef
from fbgen.lang.types import Elementary, Scalar
from harness.engine.compiled.data.placement import Bytes
from harness.engine.compiled.data.shapes import Shapes
from harness.engine.compiled.library.placed import ByteCell, Codec
from harness.engine.environment import Environment
from harness.engine.faults import address_out_of_range, no_data_block, unknown_area
from harness.engine.layout import S7

_LETTERS = {1: "I", 2: "Q", 0x81: "I", 0x82: "Q", 0x83: "M"}
_SIZES = {1: "X", 8: "B", 16: "W", 32: "D", 64: "L"}
_BLOCK = 0x84


class Spot(NamedTuple):
    """One place of the text: how its value is read and written, and how many bits it has."""

    node: MemoryRef
    codec: Codec | None
    bits: int


def spot(node: MemoryRef, shapes: Shapes) -> Spot:
    """What generated code hands over for a place."""
    codec = shapes.codec(node.type) if isinstance(node.type, Elementary) else None
    return Spot(node, codec, S7.used_bits(node.type))


class HardwareCell:
    """A place past the process image."""

    __slots__ = ("_bit", "_byte", "_codec", "_count", "_environment")

    def __init__(
        self, environment: Environment, byte: int, bit: int, way: Codec, bits: int
    ) -> None:
        self._environment = environment
        self._byte = byte
        self._bit = bit
        self._codec = way
        self._count = max(bits, 8) // 8

    @property
    def value(self) -> Scalar:
        """What the hardware gives."""
        data = bytearray()
        while len(data) < self._count:
            size = min(self._count - len(data), 4)
            data += self._environment.read_peripheral(self._byte + len(data), size).to_bytes(
                size, "big"
            )
        value: Scalar = self._codec.get(data, self._bit)
        return value

    @value.setter
    def value(self, content: Scalar) -> None:
        # A single bit goes out with the others of its byte as they stand in the image.
        data = bytearray(self._environment.outputs[self._byte : self._byte + self._count])
        data += bytes(self._count - len(data))
        self._codec.set(data, self._bit, content)
        for start in range(0, self._count, 4):
            part = data[start : start + 4]
            number = int.from_bytes(part, "big")
            self._environment.write_peripheral(self._byte + start, len(part), number)


def access(data: Bytes, environment: Environment) -> dict[str, Callable[..., Any]]:
    """The functions that reach memory by address."""

    def memory_of(place: Spot, area: int, db: int) -> bytearray:
        if area == _BLOCK:
            found = data.block(db)
            if found is None:
                raise no_data_block(place.node.span, db)
            return found
        letter = _LETTERS.get(area)
        if letter is None:
            raise unknown_area(place.node.span, area)
        if letter == "M":
            return environment.markers
        return environment.inputs if letter == "I" else environment.outputs

    def memory_at(place: Spot, area: int, db: int, byte: int, bit: int = 0) -> Any:
        memory = memory_of(place, area, db)
        is_outside = area > _LETTERS_END and 8 * byte + bit + place.bits > 8 * len(memory)
        if byte < 0 or not 0 <= bit <= 7 or is_outside:
            address = _spelled(place, area, db, byte, bit)
            raise address_out_of_range(place.node.span, address, len(memory))
        if place.codec is None:
            return data.view(place.node.type, memory, 8 * byte + bit)
        if area <= _LETTERS_END:
            return HardwareCell(environment, byte, bit, place.codec, place.bits)
        return ByteCell(memory, 8 * byte + bit, place.codec)

    def write_memory(value: Scalar, place: Spot, *where: int) -> None:
        memory_at(place, *where).value = value

    return {"_memory_at": memory_at, "_write_memory": write_memory}


_LETTERS_END = 2
"""The codes up to here mean hardware."""


def _spelled(place: Spot, area: int, db: int, byte: int, bit: int) -> str:
    kind = place.node.type
    size = _SIZES[kind.bits if isinstance(kind, Elementary) else 8]
    where = f"{byte}.{bit}" if size == "X" else str(byte)
    if area == _BLOCK:
        return f"%DB{db}.DB{size}{where}"
    end = ":P" if area <= _LETTERS_END else ""
    return f"%{_LETTERS[area]}{'' if size == 'X' else size}{where}{end}"
