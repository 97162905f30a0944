"""Slices such as `w.%X3` as shifts and masks.

Source: TIA Portal help, "Addressing areas of a tag": slices count from the least significant end.
"""

from fbgen.lang.ast import (
    Assignment,
    Binary,
    Expression,
    Literal,
    LiteralKind,
    Slice,
)
from fbgen.lang.lowering.build import binary, bits, call, integer
from fbgen.source import Span

_WIDTHS = {"X": 1, "B": 8, "W": 16, "D": 32}
_PART_TYPES = {"B": "BYTE", "W": "WORD", "D": "DWORD"}
_BASES = {"BYTE": 8, "WORD": 16, "DWORD": 32, "LWORD": 64}
_INTEGERS = {
    "SINT": "BYTE",
    "USINT": "BYTE",
    "INT": "WORD",
    "UINT": "WORD",
    "DINT": "DWORD",
    "UDINT": "DWORD",
    "LINT": "LWORD",
    "ULINT": "LWORD",
}


def can_be_sliced(type_name: str, part: Slice) -> bool:
    """Whether a value of this type has the part."""
    width = _BASES.get(_INTEGERS.get(type_name, type_name), 0)
    return _WIDTHS[part.size] * (part.index + 1) <= width and _WIDTHS[part.size] < width


def read_slice(place: Span, base: Expression, type_name: str, part: Slice) -> Expression:
    """The part as an expression; `base` is lowered already."""
    bit_type, value = _as_bits(place, base, type_name)
    width, size = _BASES[bit_type], _WIDTHS[part.size]
    if part.size == "X":
        mask = bits(place, bit_type, 1 << part.index, width)
        masked = binary(place, "AND", value, mask)
        return binary(place, "<>", masked, bits(place, bit_type, 0, width))
    shifted = call(place, "SHR", value, integer(place, part.index * size)) if part.index else value
    low = Binary(place, "AND", shifted, bits(place, bit_type, (1 << size) - 1, width))
    return call(place, f"{bit_type}_TO_{_PART_TYPES[part.size]}", low)


def write_slice(
    node: Assignment, base: Expression, type_name: str, part: Slice, value: Expression
) -> Assignment:
    """An assignment to the part; `base` and `value` are lowered already."""
    place = node.span
    bit_type, old = _as_bits(place, base, type_name)
    width = _BASES[bit_type]
    size = _WIDTHS[part.size]
    part_mask = ((1 << size) - 1) << (part.index * size)
    cleared = Binary(
        place, "AND", old, bits(place, bit_type, ((1 << width) - 1) & ~part_mask, width)
    )
    if part.size == "X":
        set_bit = Binary(place, "OR", old, bits(place, bit_type, part_mask, width))
        new: Expression
        if isinstance(value, Literal) and value.kind is LiteralKind.BOOL:
            new = set_bit if value.value else cleared
        else:
            new = call(place, "SEL", value, cleared, set_bit)
    else:
        part_type = _PART_TYPES[part.size]
        if isinstance(value, Literal) and not value.type_name:
            value = bits(place, part_type, int(value.value) & ((1 << size) - 1), size)
        widened: Expression = call(place, f"{part_type}_TO_{bit_type}", value)
        if part.index:
            widened = call(place, "SHL", widened, integer(place, part.index * size))
        new = Binary(place, "OR", cleared, widened)
    if type_name in _INTEGERS:
        new = call(place, f"{bit_type}_TO_{type_name}", new)
    return Assignment(place, base, ":=", new, node.leading, node.trailing)


def _as_bits(place: Span, base: Expression, type_name: str) -> tuple[str, Expression]:
    """The bit string type that holds the value, and the value as that type."""
    if type_name in _INTEGERS:
        bit_type = _INTEGERS[type_name]
        return bit_type, call(place, f"{type_name}_TO_{bit_type}", base)
    return type_name, base
