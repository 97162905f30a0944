"""SCALE, UNSCALE and DEMUX.

A raw value of 27648 is the rated range of an analog module; bipolar ones go down to -27648. Values
outside give the nearer limit and status 16#0008. Everything is calculated in 64 bit and rounded
once. Sources: STEP 7 help, FC105 and FC106; TIA Portal help, "DEMUX".
"""

from collections.abc import Callable, Mapping

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
        return {"out": high, "ret_val": _OUTSIDE}
    if raw < first:
        return {"out": low, "ret_val": _OUTSIDE}
    return {"out": (raw - first) / (last - first) * (high - low) + low, "ret_val": 0}


def _unscale(operands: Operands) -> Mapping[str, Value]:
    value = operands.real("IN")
    high, low = operands.real("HI_LIM"), operands.real("LO_LIM")
    first, last = _raw_range(operands)
    share = real_divided(value - low, high - low)
    if share > 1:
        return {"out": last, "ret_val": _OUTSIDE}
    if not share >= 0:
        return {"out": first, "ret_val": _OUTSIDE}
    return {"out": round(share * (last - first) + first), "ret_val": 0}


def _demultiplex(operands: Operands) -> Mapping[str, Value]:
    """Only the chosen output is written; without it OUTELSE; without that none."""
    name = f"OUT{operands.whole('K')}"
    if name not in operands.kinds:
        name = "OUTELSE"
    return {name.casefold(): operands.values["IN"]} if name in operands.kinds else {}


ANALOG_ROUTINES: dict[str, Routine] = {
    "SCALE": _scale,
    "UNSCALE": _unscale,
    "DEMUX": _demultiplex,
}
"""By canonical name."""
