"""ANY and POINTER as they lie in memory, and local data that they can point to.

ANY: 16#10, code of the type, count, number of the data block, area and address in bits. POINTER:
number of the data block, area and address. A single variable or an array of elementary type has its
own code and count; anything else counts as BYTEs. What has no code of its own has that of the bit
string of its width. Local data has the area 16#87 and addresses that mean something to this program
only.
Sources: STEP 7 help, "Format of the parameter type ANY" and "Format of the parameter type POINTER";
TIA Portal help, "ANY pointer". Which code a structure has is inferred from "arrays and structures
are identified as a number of data types".
"""

from fbgen.dataclass import dataclass
from fbgen.lang.layout import S7_SIZES
from fbgen.lang.types import (
    BOOL,
    BYTE,
    CHAR,
    DATE,
    DATE_AND_TIME,
    DINT,
    DWORD,
    INT,
    REAL,
    S5TIME,
    TIME,
    TIME_OF_DAY,
    WORD,
    ArrayType,
    Elementary,
    StringType,
    Type,
)

INPUTS, OUTPUTS, MARKERS, BLOCK, INSTANCE, LOCAL = 0x81, 0x82, 0x83, 0x84, 0x85, 0x87
"""The codes of the areas."""


class NoAreaError(Exception):
    """The bytes of an ANY or POINTER that is followed do not mean an area."""

    def __init__(self, pattern: bytes, reason: str) -> None:
        super().__init__(reason)
        self.pattern = pattern
        self.reason = reason


_SYNTAX = 0x10
_CODES = {
    1: BOOL,
    2: BYTE,
    3: CHAR,
    4: WORD,
    5: INT,
    6: DWORD,
    7: DINT,
    8: REAL,
    9: DATE,
    10: TIME_OF_DAY,
    11: TIME,
    12: S5TIME,
    14: DATE_AND_TIME,
}
_STRING = 19
_CODE_OF = {kind: code for code, kind in _CODES.items()}
_CODE_OF_WIDTH = {16: 4, 32: 6}
_BYTE = 2
_ADDRESS_BITS = 19
"""Byte and bit of an address: 16 bits and 3."""


@dataclass(frozen=True, slots=True)
class AreaPointer:
    """What an ANY says; of a POINTER without `code` and `count`. `bit` counts from byte 0."""

    area: int
    db: int
    bit: int
    code: int = 0
    count: int = 0

    @property
    def pointer_bytes(self) -> bytes:
        """As a POINTER."""
        return self.db.to_bytes(2, "big") + (self.area << 24 | self.bit).to_bytes(4, "big")

    @property
    def any_bytes(self) -> bytes:
        """As an ANY."""
        return bytes((_SYNTAX, self.code)) + self.count.to_bytes(2, "big") + self.pointer_bytes

    def kind(self, memory: bytes | bytearray) -> Type | None:
        """The type of the area, of a POINTER a single bit; None for a code that has no area.

        How long a text is says the byte it starts with.
        """
        element: Type | None = _CODES.get(self.code)
        if self.code == 0:
            return BOOL
        if self.code == _STRING:
            byte = self.bit >> 3
            element = StringType(min(memory[byte], 254) if byte < len(memory) else 0)
        if element is None or not self.count:
            return None
        return element if self.count == 1 else ArrayType(((1, self.count),), element)


NOWHERE = AreaPointer(0, 0, 0, _BYTE, 1)
"""The pointer to a variable that has no address."""


def is_null(pattern: bytes) -> bool:
    """True for a pointer to nothing: an ANY without type, a POINTER without area."""
    return pattern[1] == 0 if len(pattern) > len(NULL_POINTER) else not any(pattern)


NULL_POINTER = bytes(6)
NULL_ANY = bytes((_SYNTAX, *bytes(9)))


def read_pointer(pattern: bytes) -> AreaPointer | None:
    """What the bytes of an ANY or POINTER say; None if it is no ANY."""
    tail = pattern[-6:]
    db, area = int.from_bytes(tail[:2], "big"), tail[2]
    bit = int.from_bytes(tail[3:], "big") & ((1 << _ADDRESS_BITS) - 1)
    if len(pattern) == len(NULL_POINTER):
        return AreaPointer(area, db, bit)
    if pattern[0] != _SYNTAX:
        return None
    return AreaPointer(area, db, bit, pattern[1], int.from_bytes(pattern[2:4], "big"))


def pointer_to(kind: Type, area: int, db: int, bit: int) -> AreaPointer:
    """The pointer to a variable of a type at an address."""
    code, count = _code(kind)
    return AreaPointer(area, db, bit, code, count & 0xFFFF)


def _code(kind: Type) -> tuple[int, int]:
    if isinstance(kind, StringType) and not kind.wide:
        return _STRING, 1
    if isinstance(kind, Elementary):
        return _elementary_code(kind)
    if isinstance(kind, ArrayType) and isinstance(kind.element, Elementary):
        code, count = _elementary_code(kind.element)
        return code, count * kind.count
    return _BYTE, S7_SIZES.size_bytes(kind)


def _elementary_code(kind: Elementary) -> tuple[int, int]:
    if kind in _CODE_OF:
        return _CODE_OF[kind], 1
    if kind.bits in _CODE_OF_WIDTH:
        return _CODE_OF_WIDTH[kind.bits], 1
    return _BYTE, kind.bits // 8


class LocalData:
    """Addresses of memories that no absolute address reaches: temporaries, instances.

    There is room for 64 KiB; then the oldest ones lose theirs.
    """

    __slots__ = ("_memories", "_next", "_starts")

    _ROOM = 1 << 16

    def __init__(self) -> None:
        self._memories: dict[int, bytearray] = {}
        """By their first byte, the oldest first."""
        self._starts: dict[int, int] = {}
        """The first byte by the identity of the memory."""
        self._next = 0

    def first_byte(self, memory: bytearray) -> int:
        """Where a memory begins."""
        known = self._starts.get(id(memory))
        if known is not None:
            return known
        end = self._next + len(memory)
        if end > self._ROOM:
            self._forget(self._ROOM)
            self._next, end = 0, len(memory)
        self._forget(end)
        start, self._next = self._next, end + (end & 1)
        self._memories[start] = memory
        self._starts[id(memory)] = start
        return start

    def _forget(self, end: int) -> None:
        """Make room from the next free byte up to `end`."""
        for start, memory in list(self._memories.items()):
            if not self._next <= start < end:
                break
            del self._memories[start], self._starts[id(memory)]

    def at(self, byte: int) -> tuple[bytearray, int] | None:
        """The memory in which a byte lies, and where that begins."""
        for start, memory in reversed(self._memories.items()):
            if start <= byte < start + len(memory):
                return memory, start
        return None
