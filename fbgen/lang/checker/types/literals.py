"""Constants that have no type of their own yet, and whether a value fits a type.

`5` is any integer, bit string or REAL that can hold it, `16#FF` too, `1.5` REAL or LREAL: they take
the type of what they meet. Until then they carry one of the types below, which no program sees.
Sources: IEC 61131-3 third edition, section 6.3; TIA Portal help, "Specifying constants".
"""

import math
import struct

from fbgen.lang.checked import Constant
from fbgen.lang.types import (
    BOOL,
    BYTE,
    CHAR,
    DINT,
    DWORD,
    INT,
    LINT,
    LREAL,
    LWORD,
    REAL,
    ULINT,
    WCHAR,
    WORD,
    Elementary,
    Enumeration,
    Family,
    ReferenceType,
    Scalar,
    StringType,
    Subrange,
    Type,
)
from fbgen.source import Span

UNTYPED_INTEGER = Elementary("integer constant", Family.SIGNED, 65)
UNTYPED_MASK = Elementary("complement of an integer constant", Family.SIGNED, 65)
"""NOT of an integer constant: all bits above it are 1 in whatever width it gets."""
UNTYPED_REAL = Elementary("real constant", Family.REAL, 65)
ERRONEOUS = Elementary("unknown type", Family.VOID, -1)
"""The type of what was already reported: nothing more is said about it."""

NULL = ReferenceType("NULL", "", lambda: ERRONEOUS)
"""The type of the constant NULL, which becomes any reference."""

_UNTYPED = (UNTYPED_INTEGER, UNTYPED_MASK, UNTYPED_REAL)
_LARGEST = (1 << 64) - 1


def is_untyped(kind: Type) -> bool:
    """True for the types of constants that take the type of their context."""
    return kind in _UNTYPED


def erroneous(span: Span) -> Constant:
    """What stands for an expression that was already reported."""
    return Constant(span, 0, ERRONEOUS)


def holds_untyped(value: int) -> bool:
    """True if some type could hold this integer."""
    return -(1 << 63) <= value <= _LARGEST


def round_real(value: float) -> float:
    """The nearest 32-bit number, infinite if there is none."""
    try:
        rounded: float = struct.unpack("f", struct.pack("f", value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)
    return rounded


def nearest_real(value: int, target: Elementary) -> float | None:
    """The number of REAL or LREAL that is nearest to a whole one, rounded once, ties to even."""
    if target != REAL or abs(value) <= 1 << 53:
        return in_real(float(value), target)
    shift = abs(value).bit_length() - 24
    kept, rest = divmod(abs(value), 1 << shift)
    half = 1 << (shift - 1)
    if rest > half or (rest == half and kept % 2):
        kept += 1
    return in_real(math.copysign(float(kept << shift), value), target)


def fitted(constant: Constant, target: Type) -> Scalar | None:
    """The value of an untyped constant or a string constant in `target`; None if it has none."""
    value = constant.value
    if isinstance(value, str):
        return _fitted_text(value, target)
    if not isinstance(target, Elementary):
        return None
    if constant.type == UNTYPED_REAL:
        if target.family is not Family.REAL:
            return None
        return in_real(float(value), target)
    return _fitted_integer(int(value), target, constant.type == UNTYPED_MASK)


def in_real(value: float, target: Elementary) -> float | None:
    """A finite number rounded to REAL or LREAL; None beyond its range."""
    number = round_real(value) if target == REAL else value
    return number if math.isfinite(number) else None


def _fitted_integer(value: int, target: Elementary, mask: bool) -> Scalar | None:
    if isinstance(target, Enumeration):
        return None
    if isinstance(target, Subrange):
        return value if target.lowest <= value <= target.highest else None
    family = target.family
    if family is Family.BOOL:
        return bool(value) if value in (0, 1) else None
    if family is Family.REAL:
        return nearest_real(value, target)
    if family in (Family.SIGNED, Family.UNSIGNED, Family.BITS):
        if mask and family is not Family.SIGNED and -(1 << target.bits) <= value <= target.maximum:
            return value & target.maximum
        return value if target.minimum <= value <= target.maximum else None
    return None


def _fitted_text(value: str, target: Type) -> str | None:
    if isinstance(target, StringType):
        limit = 0xFFFF if target.wide else 0xFF
        room = len(value) <= target.length
        return value if room and all(ord(char) <= limit for char in value) else None
    if target in (CHAR, WCHAR) and len(value) == 1:
        return value if ord(value) < 1 << (16 if target == WCHAR else 8) else None
    return None


def settled(constant: Constant) -> Constant:
    """An untyped constant in the type that it has where nothing else gives it one."""
    if constant.type == UNTYPED_REAL:
        kind = REAL if in_real(float(constant.value), REAL) is not None else LREAL
        return Constant(constant.span, fitted(constant, kind) or 0.0, kind)
    if constant.type == UNTYPED_INTEGER:
        candidates = (INT, DINT, LINT, ULINT)
    elif constant.type == UNTYPED_MASK:
        candidates = (BYTE, WORD, DWORD, LWORD)
    else:
        return constant
    for kind in candidates:
        value = fitted(constant, kind)
        if value is not None:
            return Constant(constant.span, value, kind)
    return constant


def settled_bits(constant: Constant) -> Constant:
    """An untyped integer constant as the smallest bit string that holds it."""
    for kind in (BYTE, WORD, DWORD, LWORD):
        value = fitted(constant, kind)
        if value is not None:
            return Constant(constant.span, value, kind)
    return constant


def default_value(kind: Elementary | StringType) -> Scalar:
    """What a variable of the type holds without an initial value."""
    if isinstance(kind, StringType):
        return ""
    if kind == BOOL:
        return False
    if kind.family is Family.REAL:
        return 0.0
    if kind.family is Family.CHAR:
        return "\0"
    return 0
