"""Operands of different kinds that TIA Portal takes together without its IEC check.

Source: TIA Portal help, "Implicit conversion of DINT" and the pages of the other types;
"Arithmetic expressions": TIME with DINT, and the same for other durations, dates and times of day.
"""

from fbgen.lang.checked import Constant, Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.rules import without_iec_check
from fbgen.lang.checker.types.coercion import as_typed, converted, warn_unchecked
from fbgen.lang.checker.types.conversions import common_type, is_implicit
from fbgen.lang.checker.types.literals import is_untyped
from fbgen.lang.types import DATE, DINT, INT, LINT, LTIME, TIME, TIME_OF_DAY, Elementary, Type

_COUNTED = {TIME: DINT, TIME_OF_DAY: DINT, LTIME: LINT, DATE: INT}
"""The integer of the same width."""


def unchecked_pair(
    ctx: Context, left: Expression, right: Expression
) -> tuple[Expression, Expression] | None:
    """Both operands in one type; None if they have none without the IEC check either."""
    if ctx.rules.iec_check and not ctx.rules.iec_check_open:
        return None
    rules = without_iec_check(ctx.rules)
    kind = common_type(left.type, right.type, rules)
    if kind is None and rules.narrows_unchecked:
        return _as_counted(ctx, left, right) or _swapped(_as_counted(ctx, right, left))
    if kind is None or is_untyped(left.type) or is_untyped(right.type):
        return None
    _warn(ctx, left, kind)
    return converted(left, kind), converted(right, kind)


def _as_counted(
    ctx: Context, time: Expression, number: Expression
) -> tuple[Expression, Expression] | None:
    """A whole number beside a duration, a date or a time of day as one of these."""
    width = _COUNTED.get(time.type) if isinstance(time.type, Elementary) else None
    if width is None:
        return None
    counted = as_typed(number) if isinstance(number, Constant) else number
    kind = counted.type
    if not isinstance(kind, Elementary) or not kind.is_integer:
        return None
    if isinstance(number, Constant) and kind.bits <= width.bits:
        counted = converted(counted, width)
    if not is_implicit(counted.type, time.type, without_iec_check(ctx.rules)):
        return None
    _warn(ctx, counted, time.type)
    return time, converted(counted, time.type)


def _swapped(
    pair: tuple[Expression, Expression] | None,
) -> tuple[Expression, Expression] | None:
    return None if pair is None else (pair[1], pair[0])


def _warn(ctx: Context, operand: Expression, kind: Type) -> None:
    if ctx.rules.iec_check_open:
        warn_unchecked(ctx, operand.span, operand.type, kind)
