"""Where the parts of a variable lie in memory, and how much of it they take.

`S7`: numbers are big endian. BOOLs are packed from bit 0 upwards; one byte wide types take the next
byte; everything wider, arrays and structures start at an even byte, arrays and structures end at
one too. STRING[n] is n + 2 bytes: room, length, characters; WSTRING[n] the same in words. Each row
of an array of several dimensions starts at an even byte. DATE_AND_TIME is BCD with milliseconds
and weekday (Sunday = 1).
Sources: STEP 7 System Software reference, "Format of the data type ..."; TIA Portal help, "Basics
of data types"; rows of arrays are inferred from "Format of ARRAY".

`PC`, for the dialects iec and twincat, where only unions show it: numbers are little endian, a BOOL
is one byte, every type starts at a multiple of its size (at most 8), a structure at a multiple of
its largest part. STRING[n] is n + 1 bytes with a zero behind the text.
Sources: CODESYS help, "Data types" and "Alignment"; TwinCAT 3 help, "Alignment".
"""

from weakref import WeakKeyDictionary

from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.lang.types import (
    ArrayType,
    BlockType,
    Elementary,
    Field,
    ReferenceType,
    StringType,
    StructType,
    Type,
    is_area_pointer,
)
from fbgen.source import Span

_POINTER_BITS = {"ANY": 80, "POINTER": 48}
_STRUCTURES: dict[bool, WeakKeyDictionary[StructType, int]] = {
    True: WeakKeyDictionary(),
    False: WeakKeyDictionary(),
}
"""Sizes that were worked out already: a structure of structures asks for them often."""


def no_layout(span: Span | None, kind: Type) -> DiagnosticError:
    """FB6013: a variable is used as an area of bytes whose type has no layout in memory."""
    return error(
        "FB6013",
        f"a variable of type {kind} cannot be used as an area of bytes",
        span,
        "use an array, a structure or an elementary variable",
    )


@dataclass(frozen=True, slots=True)
class Sizes:
    """The rules of one kind of controller."""

    is_s7: bool

    def size_bits(self, kind: Type) -> int:
        """The size in bits; only a BOOL is not whole bytes. Raises FB6013 without a layout."""
        if isinstance(kind, Elementary):
            return self._elementary_bits(kind)
        if isinstance(kind, StringType):
            width = 16 if kind.wide else 8
            return _up((kind.length + 2) * width, 16) if self.is_s7 else (kind.length + 1) * width
        if isinstance(kind, ArrayType):
            return self._rows_bits(kind, 0)
        if isinstance(kind, StructType):
            known = _STRUCTURES[self.is_s7]
            bits = known.get(kind)
            if bits is None:
                ends = [bit + self.size_bits(field.type) for field, bit in self.placed(kind)]
                bits = known[kind] = _up(max(ends, default=0), self.alignment(kind))
            return bits
        if isinstance(kind, ReferenceType) and kind.keyword in _POINTER_BITS:
            return _POINTER_BITS[kind.keyword]
        raise no_layout(None, kind)

    def used_bits(self, kind: Type) -> int:
        """As `size_bits`, without what is only there to end at an even byte."""
        if isinstance(kind, ArrayType):
            return max(self.element_bits(kind), default=0) + self.used_bits(kind.element)
        if isinstance(kind, StructType):
            return max((b + self.used_bits(f.type) for f, b in self.placed(kind)), default=0)
        return self.size_bits(kind)

    def size_bytes(self, kind: Type) -> int:
        """The size in bytes; a BOOL takes one."""
        return (self.size_bits(kind) + 7) // 8

    def alignment(self, kind: Type) -> int:
        """A variable of the type starts at a multiple of this number of bits."""
        if self.is_s7:
            small = isinstance(kind, Elementary) and kind.bits <= 8
            return self.size_bits(kind) if small else 16
        if isinstance(kind, ArrayType):
            return self.alignment(kind.element)
        if isinstance(kind, StructType):
            return max((self.alignment(field.type) for field in kind.fields), default=8)
        if isinstance(kind, StringType):
            return 16 if kind.wide else 8
        return self.size_bits(kind)

    def aligned(self, bit: int, kind: Type) -> int:
        """The first bit from `bit` on where a variable of the type may start."""
        return _up(bit, self.alignment(kind))

    def field_bits(self, kind: StructType) -> dict[str, int]:
        """The first bit of each part, by casefolded name."""
        return {field.name.casefold(): bit for field, bit in self.placed(kind)}

    def element_bits(self, kind: ArrayType) -> list[int]:
        """The first bit of each element, in flat order."""
        row = kind.bounds[-1][1] - kind.bounds[-1][0] + 1
        row_bits = self._rows_bits(kind, len(kind.bounds) - 1)
        stride = self._stride(kind.element)
        return [(i // row) * row_bits + (i % row) * stride for i in range(kind.count)]

    def placed(self, kind: StructType) -> list[tuple[Field, int]]:
        """The parts of a structure, each with its first bit."""
        placed = []
        end = 0
        for field in kind.fields:
            bit = 0 if kind.is_union else self.aligned(end, field.type)
            placed.append((field, bit))
            end = bit + self.size_bits(field.type)
        return placed

    def _elementary_bits(self, kind: Elementary) -> int:
        if self.is_s7:
            return kind.bits
        return max(kind.bits, 8)

    def _stride(self, element: Type) -> int:
        return _up(self.size_bits(element), self.alignment(element))

    def _rows_bits(self, kind: ArrayType, dimension: int) -> int:
        first, last = kind.bounds[dimension]
        if dimension + 1 < len(kind.bounds):
            return (last - first + 1) * self._rows_bits(kind, dimension + 1)
        bits = (last - first + 1) * self._stride(kind.element)
        return _up(bits, 16) if self.is_s7 else bits


S7_SIZES = Sizes(is_s7=True)
PC_SIZES = Sizes(is_s7=False)


def sizes_of(dialect: str) -> Sizes:
    """How variables lie in memory on the controllers of a dialect."""
    return S7_SIZES if dialect in ("tia", "step7") else PC_SIZES


def holds_values(kind: Type) -> bool:
    """True for types without references that lie in no memory: ANY and POINTER do."""
    if isinstance(kind, ArrayType):
        return holds_values(kind.element)
    if isinstance(kind, StructType):
        return all(holds_values(field.type) for field in kind.fields)
    return isinstance(kind, Elementary | StringType | BlockType) or is_area_pointer(kind)


def holds_blocks(kind: Type) -> bool:
    """True for instances, and for types with instances inside."""
    if isinstance(kind, ArrayType):
        return holds_blocks(kind.element)
    if isinstance(kind, StructType):
        return any(holds_blocks(field.type) for field in kind.fields)
    return isinstance(kind, BlockType)


def _up(bit: int, step: int) -> int:
    return -(-bit // step) * step
