"""From a place in memory to the pointer that means it, and back."""

from collections.abc import Callable, Collection

from fbgen.lang.layout import S7_SIZES
from fbgen.lang.types import Type
from harness.engine.area_pointers import (
    BLOCK,
    INPUTS,
    INSTANCE,
    LOCAL,
    MARKERS,
    NOWHERE,
    OUTPUTS,
    AreaPointer,
    LocalData,
    NoAreaError,
    pointer_to,
    read_pointer,
)
from harness.engine.environment import Environment


class AreaMemories:
    """The memories of one controller that a pointer reaches.

    `blocks` are the numbers of its data blocks, `block` gives the bytes of one.
    """

    __slots__ = ("_block", "_blocks", "_environment", "_local", "_numbers")

    def __init__(
        self,
        environment: Environment,
        blocks: Collection[int],
        block: Callable[[int], bytearray | None],
    ) -> None:
        self._environment = environment
        self._blocks = blocks
        self._block = block
        self._local = LocalData()
        self._numbers: dict[int, int] = {}

    def pointer(self, kind: Type, memory: bytearray, bit: int) -> AreaPointer:
        """The pointer to a variable of a type at a bit of a memory."""
        for area, image in self._images().items():
            if image is memory:
                return pointer_to(kind, area, 0, bit)
        number = self._number(memory)
        if number is not None:
            return pointer_to(kind, BLOCK, number, bit)
        return pointer_to(kind, LOCAL, 0, 8 * self._local.first_byte(memory) + bit)

    def find(self, pattern: bytes) -> tuple[Type, bytearray, int]:
        """The type of what a pointer means, its memory and its first bit. Raises NoAreaError."""
        pointer = read_pointer(pattern)
        if pointer is None:
            raise NoAreaError(pattern, "it does not begin with 16#10")
        memory, bit = self._memory(pointer, pattern)
        kind = pointer.kind(memory)
        if kind is None:
            what = f"type 16#{pointer.code:02X}, count {pointer.count}"
            raise NoAreaError(pattern, f"{what} is no stretch of memory")
        if bit + S7_SIZES.used_bits(kind) > 8 * len(memory):
            raise NoAreaError(pattern, f"it ends behind the {len(memory)} bytes that are there")
        return kind, memory, bit

    def _memory(self, pointer: AreaPointer, pattern: bytes) -> tuple[bytearray, int]:
        image = self._images().get(pointer.area)
        if image is not None:
            return image, pointer.bit
        if pointer.area in (BLOCK, INSTANCE):
            memory = self._block(pointer.db)
            if memory is None:
                raise NoAreaError(
                    pattern, f"there is no data block {pointer.db} with standard access"
                )
            return memory, pointer.bit
        if pointer.area == LOCAL:
            found = self._local.at(pointer.bit >> 3)
            if found is None:
                raise NoAreaError(pattern, "the local data that it meant is gone")
            return found[0], pointer.bit - 8 * found[1]
        reason = f"there is no area 16#{pointer.area:02X}"
        if pointer == NOWHERE:
            reason = "what it was made of has no address (optimized access, instances, slices)"
        raise NoAreaError(pattern, reason)

    def _images(self) -> dict[int, bytearray]:
        environment = self._environment
        return {
            INPUTS: environment.inputs,
            OUTPUTS: environment.outputs,
            MARKERS: environment.markers,
        }

    def _number(self, memory: bytearray) -> int | None:
        number = self._numbers.get(id(memory))
        if number is not None and self._block(number) is memory:
            return number
        self._numbers = {
            id(known): number
            for number in self._blocks
            if (known := self._block(number)) is not None
        }
        return self._numbers.get(id(memory))
