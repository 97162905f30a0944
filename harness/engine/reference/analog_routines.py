"""SCALE, UNSCALE, DEMUX, SEG and BCDCPL.

A raw value of 27648 is the rated range of an analog module; bipolar ones go down to -27648. Values
outside give the nearer limit and status 16#0008. Everything is calculated in 64 bit and rounded
once. Sources: STEP 7 help, FC105, FC106, FC93 and FC89; TIA Portal help, "DEMUX".
"""

from collections.abc import Callable, Mapping

from harness.engine.faults import not_decimal
from harness.engine.interface import Value
from harness.engine.reference.arithmetic import real_divided
from harness.engine.reference.routine_operands import Operands

_RATED = 27648
_OUTSIDE = 8

Routine = Callable[[Operands], Mapping[str, Value]]


def _raw_range(operands: Operands) -> tuple[int, int]:
    return (-_RATED if operands.flag("BIPOLAR") else 0), _RATED


def _scale(operands: Operands) -> Mapping[str, Value]:
    raw = operands.whole("IN")
    high, low = operands.real("HI_LIM"), operands.real("LO_LIM")
    first, last = _raw_range(operands)
    if raw > last:
        return {"out": high, "ret_val": _OUTSIDE, "eno": False}
    if raw < first:
        return {"out": low, "ret_val": _OUTSIDE, "eno": False}
    return {"out": (raw - first) / (last - first) * (high - low) + low, "ret_val": 0}


def _unscale(operands: Operands) -> Mapping[str, Value]:
    value = operands.real("IN")
    high, low = operands.real("HI_LIM"), operands.real("LO_LIM")
    first, last = _raw_range(operands)
    share = real_divided(value - low, high - low)
    if share > 1:
        return {"out": last, "ret_val": _OUTSIDE, "eno": False}
    if not share >= 0:
        return {"out": first, "ret_val": _OUTSIDE, "eno": False}
    return {"out": round(share * (last - first) + first), "ret_val": 0}


def _demultiplex(operands: Operands) -> Mapping[str, Value]:
    """Only the chosen output is written; without it OUTELSE; without that none."""
    name = f"OUT{operands.whole('K')}"
    if name not in operands.kinds:
        name = "OUTELSE"
    if name not in operands.kinds:
        return {"eno": False}
    return {name.casefold(): operands.values["IN"]}


_SEGMENTS = (
    *(0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07),
    *(0x7F, 0x67, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71),
)
"""What lights up for each digit, segment a in bit 0 to g in bit 6."""


def _segments(operands: Operands) -> Mapping[str, Value]:
    """SEG: a byte for each of the four digits, in their order."""
    digits = operands.whole("IN").to_bytes(2, "big").hex()
    return {"out": int.from_bytes(bytes(_SEGMENTS[int(digit, 16)] for digit in digits), "big")}


def _tens_complement(operands: Operands) -> Mapping[str, Value]:
    """BCDCPL: what the seven digits lack to 10000000. Raises FB6014."""
    value = operands.whole("IN")
    digits = f"{value & 0xFFFFFFF:07X}"
    if not digits.isdecimal():
        raise not_decimal(operands.span, value)
    return {"ret_val": int(str(10_000_000 - int(digits)), 16)}


ANALOG_ROUTINES: dict[str, Routine] = {
    "SCALE": _scale,
    "UNSCALE": _unscale,
    "DEMUX": _demultiplex,
    "SEG": _segments,
    "BCDCPL": _tens_complement,
}
"""By canonical name."""
