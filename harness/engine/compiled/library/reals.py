"""Floating point: rounding to 32 bits and the functions of REAL and LREAL.

All functions calculate in 64 bits; the caller rounds a REAL. Python raises where IEEE 754 has a
result (division by zero, overflow, outside the domain): here the result comes back.
Sources: IEEE 754; IEC 61131-3 third edition, tables 28 and 29.
"""

import math
from array import array
from collections.abc import Callable
from struct import Struct

from harness.engine.compiled.library.stops import NoFit

CELL = array("f", [0.0])
"""Storing here and reading back rounds to 32 bits: the fastest way that Python has."""

_WORD32, _REAL32 = Struct(">I"), Struct(">f")
_WORD64, _REAL64 = Struct(">Q"), Struct(">d")
_EXACT = 1 << 53


def rounded(value: float, cell: "array[float]" = CELL) -> float:
    """The nearest 32 bit number; beyond the largest one infinite."""
    cell[0] = value
    return cell[0]


def real_of_whole(value: int) -> float:
    """A whole number of up to 64 bits as REAL, rounded once."""
    if -_EXACT <= value <= _EXACT:
        return rounded(float(value))
    # What falls off below the 25th bit only says whether it was a tie: keep it as one bit.
    shift = abs(value).bit_length() - 40
    kept, lost = abs(value) >> shift, abs(value) & ((1 << shift) - 1)
    nearest = rounded(float(((kept << 1) | (lost != 0)) << (shift - 1)))
    return -nearest if value < 0 else nearest


def quotient(left: float, right: float) -> float:
    """Division by the rules of IEEE 754."""
    try:
        return left / right
    except ZeroDivisionError:
        if left == 0 or math.isnan(left):
            return math.nan
        return math.copysign(math.inf, left) * math.copysign(1.0, right)


def power(base: float, exponent: float) -> float:
    """`base ** exponent`; not-a-number outside the domain, infinite on overflow."""
    try:
        return math.pow(base, exponent)
    except OverflowError:
        odd = exponent == math.floor(exponent) and math.fmod(exponent, 2.0) != 0.0
        return -math.inf if base < 0 and odd else math.inf
    except ValueError:
        if base != 0:
            return math.nan
        odd = math.isfinite(exponent) and math.fmod(exponent, 2.0) in (1.0, -1.0)
        return math.copysign(math.inf, base) if odd else math.inf


def to_whole(value: float, low: int, high: int) -> int:
    """The nearest whole number, ties to even, if it lies in `low`..`high`."""
    if value - value != 0:
        raise NoFit(value)
    whole = round(value)
    if low <= whole <= high:
        return whole
    raise NoFit(value)


def cut_to_whole(value: float, low: int, high: int) -> int:
    """The whole part if it lies in `low`..`high`."""
    if value - value != 0:
        raise NoFit(value)
    whole = int(value)
    if low <= whole <= high:
        return whole
    raise NoFit(value)


def floor(value: float, low: int, high: int) -> int:
    """The next whole number below."""
    return to_whole(float(math.floor(value)) if value - value == 0 else value, low, high)


def ceiling(value: float, low: int, high: int) -> int:
    """The next whole number above."""
    return to_whole(float(math.ceil(value)) if value - value == 0 else value, low, high)


def bits_of_real(value: float) -> int:
    """The 32 bits of a REAL."""
    return int(_WORD32.unpack(_REAL32.pack(value))[0])


def real_of_bits(bits: int) -> float:
    """The REAL with these 32 bits."""
    return float(_REAL32.unpack(_WORD32.pack(bits))[0])


def bits_of_long_real(value: float) -> int:
    """The 64 bits of an LREAL."""
    return int(_WORD64.unpack(_REAL64.pack(value))[0])


def long_real_of_bits(bits: int) -> float:
    """The LREAL with these 64 bits."""
    return float(_REAL64.unpack(_WORD64.pack(bits))[0])


def _guarded(function: Callable[[float], float]) -> Callable[[float], float]:
    def guarded(value: float) -> float:
        try:
            return function(value)
        except ValueError:
            return math.nan
        except OverflowError:
            return math.inf

    return guarded


def _logarithm(function: Callable[[float], float]) -> Callable[[float], float]:
    def logarithm(value: float) -> float:
        if value > 0:
            return function(value)
        return -math.inf if value == 0 else math.nan

    return logarithm


def square(value: float) -> float:
    """SQR."""
    return value * value


def fraction(value: float) -> float:
    """FRAC: what stands behind the point, with the sign of the number."""
    return math.modf(value)[0]


def normalized(low: float, value: float, high: float) -> float:
    """NORM_X."""
    return quotient(float(value - low), float(high - low))


def scaled(low: float, value: float, high: float) -> float:
    """SCALE_X."""
    return float(high - low) * value + float(low)


def scaled_to_whole(low: float, value: float, high: float, least: int, most: int) -> int:
    """SCALE_X to a whole number."""
    return to_whole(scaled(low, value, high), least, most)


def _without_fraction(function: Callable[[float], int]) -> Callable[[float], float]:
    """What is not finite stays as it is, and -0.5 becomes -0.0."""

    def whole(value: float) -> float:
        return math.copysign(function(value), value) if value - value == 0 else value

    return whole


WHOLE_REALS: dict[str, Callable[[float], float]] = {
    "ROUND_REAL": _without_fraction(round),
    "TRUNC_REAL": _without_fraction(int),
    "CEIL_REAL": _without_fraction(math.ceil),
    "FLOOR_REAL": _without_fraction(math.floor),
}
"""Rounding that stays with floating point, by canonical name."""

FUNCTIONS: dict[str, Callable[[float], float]] = {
    "SQRT": _guarded(math.sqrt),
    "LN": _logarithm(math.log),
    "LOG": _logarithm(math.log10),
    "EXP": _guarded(math.exp),
    "SIN": _guarded(math.sin),
    "COS": _guarded(math.cos),
    "TAN": _guarded(math.tan),
    "ASIN": _guarded(math.asin),
    "ACOS": _guarded(math.acos),
    "ATAN": _guarded(math.atan),
    "SQR": square,
    "FRAC": fraction,
}
"""The standard functions with one argument, by canonical name."""
