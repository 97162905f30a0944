"""Dates as the nanoseconds since 1970-01-01 in generated Python, and back.

What each type counts, and from when on, stands in `library.dates` and nowhere else.
"""

from fbgen.lang.types import Elementary, Type
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.library.dates import COUNTS, DAYS, NS_PER_DAY


def instant(code: Code, kind: Type) -> Code:
    """The nanoseconds of a value of a type of dates."""
    assert isinstance(kind, Elementary)
    first, unit = COUNTS[kind]
    if unit != 1:
        code = _written(code, f"{code.at(Level.PRODUCT)} * {unit}", Level.PRODUCT, unit)
    if first:
        code = _written(code, f"{code.at(Level.SUM)} + {first}", Level.SUM, 1, first)
    return code


def count(code: Code, kind: Elementary) -> Code:
    """What a variable of the type holds for nanoseconds; it may still have to be wrapped."""
    first, unit = COUNTS[kind]
    per_step = NS_PER_DAY if kind in DAYS else unit
    if per_step != 1:
        text = f"{code.at(Level.PRODUCT)} // {per_step}"
        low, high = code.low // per_step, code.high // per_step
        code = _written(code, text, Level.PRODUCT).within(low, high)
    if per_step != unit:
        steps = per_step // unit
        code = _written(code, f"{code.at(Level.PRODUCT)} * {steps}", Level.PRODUCT, steps)
    if first:
        before = first // unit
        code = _written(code, f"{code.at(Level.SUM)} - {before}", Level.SUM, 1, -before)
    return code


def _written(code: Code, text: str, level: Level, factor: int = 1, more: int = 0) -> Code:
    return code._replace(
        text=text,
        level=level,
        low=code.low * factor + more,
        high=code.high * factor + more,
        depth=code.depth + 1,
        simple=False,
    )
