"""Calculations with several results: analog values, dates taken apart, DEMUX, digits.

Sources: STEP 7 help, FC89, FC93, FC105, FC106; IEC 61131-3, table 36; TIA Portal help.
"""

from collections.abc import Callable, Mapping
from typing import Any

from fbgen.lang.types import Elementary, Type
from harness.engine.compiled.library import calendar, characters
from harness.engine.compiled.library.dates import NS_PER_DAY, NS_PER_MS, instant_of
from harness.engine.compiled.library.decimals import from_bcd, to_bcd
from harness.engine.compiled.library.reals import quotient

_FULL = 27_648
"""The raw value of the end of the range."""
_CLIPPED = 0x0008
_DAY_NAMES = ("year", "month", "day")
_TIME_NAMES = ("hour", "minute", "second", "millisecond")

Inputs = Mapping[str, Any]
Kinds = Mapping[str, Type]
Results = Mapping[str, Any]


def _scale(inputs: Inputs, kinds: Kinds) -> Results:
    raw, top, bottom = inputs["IN"], inputs["HI_LIM"], inputs["LO_LIM"]
    lowest = -_FULL if inputs["BIPOLAR"] else 0
    if lowest <= raw <= _FULL:
        share = (raw - lowest) / (_FULL - lowest)
        return {"out": share * (top - bottom) + bottom, "ret_val": 0}
    return {"out": top if raw > 0 else bottom, "ret_val": _CLIPPED, "eno": False}


def _unscale(inputs: Inputs, kinds: Kinds) -> Results:
    top, bottom = inputs["HI_LIM"], inputs["LO_LIM"]
    lowest = -_FULL if inputs["BIPOLAR"] else 0
    share = quotient(inputs["IN"] - bottom, top - bottom)
    if 0 <= share <= 1:
        return {"out": round(share * (_FULL - lowest) + lowest), "ret_val": 0}
    return {"out": _FULL if share > 1 else lowest, "ret_val": _CLIPPED, "eno": False}


def _demux(inputs: Inputs, kinds: Kinds) -> Results:
    chosen = f"OUT{inputs['K']}"
    for name in (chosen, "OUTELSE"):
        if name in kinds:
            return {name.casefold(): inputs["IN"]}
    return {"eno": False}


def _date(days: int) -> Results:
    return dict(zip(_DAY_NAMES, calendar.day_of(days), strict=True))


def _time(milliseconds: int) -> Results:
    return dict(zip(_TIME_NAMES, calendar.time_of(milliseconds), strict=True))


def _instant(inputs: Inputs, kinds: Kinds) -> int:
    kind = kinds["IN"]
    assert isinstance(kind, Elementary)
    return instant_of(kind, inputs["IN"])


def _split_date(inputs: Inputs, kinds: Kinds) -> Results:
    return _date(_instant(inputs, kinds) // NS_PER_DAY)


def _split_stamp(inputs: Inputs, kinds: Kinds) -> Results:
    days, rest = divmod(_instant(inputs, kinds), NS_PER_DAY)
    return {**_date(days), **_time(rest // NS_PER_MS)}


_PATTERNS = bytes.fromhex("3F065B4F666D7D077F67777C395E7971")


def _seg(inputs: Inputs, kinds: Kinds) -> Results:
    word, shown = inputs["IN"], 0
    for shift in (12, 8, 4, 0):
        shown = shown << 8 | _PATTERNS[word >> shift & 15]
    return {"out": shown}


def _complement(inputs: Inputs, kinds: Kinds) -> Results:
    number = from_bcd(inputs["IN"] & 0x0FFF_FFFF, 28, 9_999_999, inputs["IN"])
    return {"ret_val": to_bcd(10_000_000 - number, 32)}


CALCULATIONS: dict[str, Callable[[Inputs, Kinds], Results]] = {
    "SCALE": _scale,
    "UNSCALE": _unscale,
    "DEMUX": _demux,
    "SEG": _seg,
    "BCDCPL": _complement,
    "SPLIT_DATE": _split_date,
    "SPLIT_TOD": lambda inputs, _: _time(inputs["IN"]),
    "SPLIT_LTOD": lambda inputs, _: _time(inputs["IN"] // NS_PER_MS),
    "SPLIT_DT": _split_stamp,
    "SPLIT_LDT": _split_stamp,
    **characters.CALCULATIONS,
}
"""By canonical name."""
