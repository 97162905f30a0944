"""Conversions between types, one function per kind of target.

Whole numbers and bit strings keep the low bits of their two's complement, so they wrap around
where the target is too narrow. Floating point to a count is rounded and must fit, else FB6006: the
standard calls it an error, and the CPUs disagree about what comes out. DWORD and REAL, LWORD and
LREAL copy their bits.
Sources: IEC 61131-3 third edition, 6.6.2.5.2 to 6.6.2.5.5; TIA Portal help, "Explicit data type
conversion".
"""

from fractions import Fraction
from struct import pack, unpack

from fbgen.lang.types import (
    CHAR,
    DWORD,
    LREAL,
    LTIME_OF_DAY,
    LWORD,
    REAL,
    TIME_OF_DAY,
    Elementary,
    Family,
    Scalar,
    StringType,
    Subrange,
    Type,
)
from fbgen.source import Span
from harness.engine.faults import outside_subrange
from harness.engine.reference.arithmetic import divided, rounded, whole, wrap
from harness.engine.reference.calendar import NS_PER_DAY, count_of, instant_of, is_counted

_SAME_BITS = {(REAL, DWORD): ">f", (DWORD, REAL): ">f", (LREAL, LWORD): ">d", (LWORD, LREAL): ">d"}
_NS_PER_MS = 1_000_000
_NS_PER_TICK = {32: _NS_PER_MS, 64: 1}


def convert(value: Scalar, source: Type, target: Type, rounding: str, span: Span) -> Scalar:
    """The value in another type; `rounding` as in `Convert`. Raises FB6006 and FB6030."""
    if isinstance(target, Subrange):
        number = convert(value, source, target.base, rounding, span)
        assert isinstance(number, int)
        if not target.lowest <= number <= target.highest:
            raise outside_subrange(span, number, target)
        return number
    if isinstance(target, StringType):
        assert isinstance(value, str)
        return _text(value, target)
    assert isinstance(target, Elementary)
    if isinstance(source, StringType):
        assert isinstance(value, str)
        return _character(value[:1] or "\0", target)
    assert isinstance(source, Elementary)
    if (source, target) in _SAME_BITS:
        return _copied_bits(value, source, target)
    if target.family is Family.CHAR:
        assert not isinstance(value, float)
        return _character(value, target)
    if isinstance(value, str):
        return _number(ord(value), source, target)
    if isinstance(value, float):
        if target.family is Family.REAL:
            return rounded(target, value)
        return whole(target, value, span, rounding)
    return _counted(value, source, target, span)


def _text(value: str, target: StringType) -> str:
    if not target.wide:
        value = "".join(character if ord(character) < 256 else "?" for character in value)
    return value[: target.length]


def _character(value: bool | int | str, target: Elementary) -> str:
    if isinstance(value, str):
        return "?" if target == CHAR and ord(value) > 255 else value
    return chr(value & ((1 << target.bits) - 1))


def _copied_bits(value: Scalar, source: Elementary, target: Elementary) -> Scalar:
    form = _SAME_BITS[source, target]
    if isinstance(value, float):
        return int.from_bytes(pack(form, value), "big")
    assert isinstance(value, int)
    real: float = unpack(form, value.to_bytes(target.bits // 8, "big"))[0]
    return real


def _counted(value: int, source: Elementary, target: Elementary, span: Span) -> Scalar:
    """From BOOL, whole numbers, bit strings, durations and dates."""
    if source.family is Family.DURATION and target.family is Family.DURATION:
        return wrap(target, _rescaled(value, source, target, span))
    if is_counted(source) and target.family is Family.DATE:
        return _part_of_instant(instant_of(source, value), target)
    if source.family is Family.DATE and target.family is Family.DATE and source != target:
        return wrap(target, _rescaled(value, source, target, span))
    return _number(value, source, target)


def _rescaled(value: int, source: Elementary, target: Elementary, span: Span) -> int:
    """Between milliseconds in 32 bit and nanoseconds in 64 bit."""
    nanoseconds = value * _NS_PER_TICK[source.bits]
    return divided(nanoseconds, _NS_PER_TICK[target.bits], span)


def _part_of_instant(instant_ns: int, target: Elementary) -> int:
    if target == TIME_OF_DAY:
        return instant_ns % NS_PER_DAY // _NS_PER_MS
    if target == LTIME_OF_DAY:
        return instant_ns % NS_PER_DAY
    return wrap(target, count_of(target, instant_ns))


def _number(value: int, source: Elementary, target: Elementary) -> Scalar:
    if target.family is Family.BOOL:
        return bool(value & 1)
    if target.family is Family.REAL:
        return nearest_real(target, int(value))
    return wrap(target, int(value))


def nearest_real(target: Elementary, value: int) -> float:
    """The floating-point number nearest to a whole one, rounded once, ties to even."""
    digits = 24 if target.bits == 32 else 53
    surplus = max(abs(value).bit_length() - digits, 0)
    return float(round(Fraction(value, 1 << surplus)) << surplus)
