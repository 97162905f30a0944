"""Absolute addresses and slices from their token.

Source: IEC 61131-3, directly represented variables; TIA Portal help, "Addressing operands".
"""

import re

from fbgen.lang.ast import DirectAddress
from fbgen.source import Span

_ADDRESS = re.compile(
    r"%([IQM])([XBWDL]?)([0-9]{1,9})(?:\.([0-9]{1,9}))?(:P)?"
    r"|%DB([0-9]{1,9})\.DB([XBWD])([0-9]{1,9})(?:\.([0-9]{1,9}))?",
    re.IGNORECASE,
)
_SLICE = re.compile(r"%([XBWD])([0-9]{1,2})", re.IGNORECASE)


def read_address(text: str, place: Span) -> DirectAddress | None:
    """The address of a token such as `%IB256:P`; None if it is none.

    A bit has two numbers (`%I0.3`), anything wider one. `%I0` of IEC is a bit with one number,
    which is bit 0 of nothing in particular, so it is no address here.
    """
    match = _ADDRESS.fullmatch(text)
    if match is None:
        return None
    area, size, byte, bit, peripheral, db, db_size, db_byte, db_bit = match.groups()
    if db:
        area, size, byte, bit = "DB", db_size, db_byte, db_bit
    size = size.upper() or "X"
    if (size == "X") != (bit is not None) or (bit is not None and int(bit) > 7):
        return None
    return DirectAddress(
        place, area.upper(), size, int(byte), int(bit or 0), int(db or 0), peripheral is not None
    )


def read_slice(text: str) -> tuple[str, int] | None:
    """Size and number of a slice such as `%X3`."""
    match = _SLICE.fullmatch(text)
    return (match[1].upper(), int(match[2])) if match else None
