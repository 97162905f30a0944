"""Packed EPATHs of DeviceNet: rows of logical segments such as 20 04 25 46 00 30 03.

A segment says in one byte what its number is and whether that has 8 or 16 bits, low byte first; no
pad lies between. The example, class 4, instance 70, attribute 3, is that of DEV003Z-1 E6581737,
page 35.
"""

from collections.abc import Iterable
from enum import IntEnum

from fbgen.dataclass import dataclass

_LOGICAL = 0x20
_KIND, _FORMAT = 0x1C, 0x03


class Segment(IntEnum):
    """What a logical segment names."""

    CLASS = 0
    INSTANCE = 1
    MEMBER = 2
    CONNECTION_POINT = 3
    ATTRIBUTE = 4


@dataclass(frozen=True, slots=True)
class Logical:
    """One segment. `wide`: it is written with 16 bits even if 8 would do."""

    kind: Segment
    number: int
    wide: bool = False


def encode_path(segments: Iterable[Logical]) -> bytes:
    """The segments on the wire. ValueError for numbers over 16 bits."""
    path = b""
    for segment in segments:
        if not 0 <= segment.number <= 0xFFFF:
            raise ValueError(f"{segment.number} does not fit into a segment of 16 bits")
        wide = segment.wide or segment.number > 0xFF
        path += bytes([_LOGICAL | segment.kind << 2 | wide])
        path += segment.number.to_bytes(2 if wide else 1, "little")
    return path


def parse_path(path: bytes) -> tuple[Logical, ...]:
    """The segments of a path. ValueError for one that is cut off or no row of logical segments."""
    found = []
    at = 0
    while at < len(path):
        first = path[at]
        kind, form = (first & _KIND) >> 2, first & _FORMAT
        if first & 0xE0 != _LOGICAL or kind > Segment.ATTRIBUTE or form > 1:
            raise ValueError(f"{first:02X} is no logical segment of 8 or 16 bits")
        end = at + 2 + form
        if end > len(path):
            raise ValueError("the path ends within a segment")
        number = int.from_bytes(path[at + 1 : end], "little")
        found.append(Logical(Segment(kind), number, wide=form == 1))
        at = end
    return tuple(found)


def assembly_path(instance: int) -> bytes:
    """The path of the data of an assembly, as the DEV003Z has it: instance with 16 bits."""
    return encode_path(
        (
            Logical(Segment.CLASS, 4),
            Logical(Segment.INSTANCE, instance, wide=True),
            Logical(Segment.ATTRIBUTE, 3),
        )
    )
