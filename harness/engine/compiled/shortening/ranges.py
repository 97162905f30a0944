"""What values a whole number can have, and wrapping it around only where that can be noticed.

Python's integers have no width. The value of an expression is followed as an interval; while only
+, - and * follow, a value may stay outside of its type, because these give the same low bits
whether their operands were wrapped around or not. Source of the rule that results wrap around:
IEC 61131-3 leaves overflow open; S7-1200/1500 and the compilers listed in the project's facts wrap.
"""

from collections.abc import Callable

from fbgen.lang.types import Elementary, Family, Type
from harness.engine.compiled.code import Code, Level

WIDEST = 1 << 60
"""Beyond this an unfinished value is wrapped around at once: Python's numbers get slow."""

COUNTED = (Family.BITS, Family.SIGNED, Family.UNSIGNED, Family.DURATION, Family.DATE)
"""The families whose values are whole numbers."""


def is_counted(kind: Type) -> bool:
    """True for types with whole numbers as values."""
    return isinstance(kind, Elementary) and kind.family in COUNTED


def limits(kind: Type) -> tuple[int, int]:
    """The interval of a type; (0, 0) for what is no whole number."""
    if isinstance(kind, Elementary) and kind.family in COUNTED:
        return kind.minimum, kind.maximum
    return 0, 0


def fits(code: Code, kind: Elementary) -> bool:
    """True if the value cannot lie outside of the type."""
    return kind.minimum <= code.low and code.high <= kind.maximum


def wrapped(code: Code, kind: Elementary, temporary: Callable[[], str]) -> Code:
    """The value wrapped around into the type; as it is if it fits.

    A value that can leave the type on one side only, and at most once, is compared; anything else
    is masked. `temporary` gives the name of a variable for the comparison.
    """
    if fits(code, kind):
        return code
    low, high = kind.minimum, kind.maximum
    span = 1 << kind.bits
    if code.low >= low and code.high <= high + span:
        name = temporary()
        text = f"{name} if ({name} := {code.text}) <= {high} else {name} - {span}"
        level = Level.CONDITIONAL
    elif code.high <= high and code.low >= low - span:
        name = temporary()
        text = f"{name} if ({name} := {code.text}) >= {low} else {name} + {span}"
        level = Level.CONDITIONAL
    elif kind.is_signed:
        half = span >> 1
        text = f"({code.at(Level.SUM)} + {half} & {span - 1}) - {half}"
        level = Level.SUM
    else:
        text, level = f"{code.at(Level.BIT_AND)} & {span - 1}", Level.BIT_AND
    return code._replace(
        text=text, level=level, low=low, high=high, depth=code.depth + 2, simple=False
    )


def masked(code: Code, bits: int) -> Code:
    """The low bits of a whole number as an unsigned value."""
    mask = (1 << bits) - 1
    if code.low >= 0 and code.high <= mask:
        return code
    text = f"{code.at(Level.BIT_AND)} & {mask}"
    return code._replace(
        text=text, level=Level.BIT_AND, low=0, high=mask, depth=code.depth + 1, simple=False
    )
