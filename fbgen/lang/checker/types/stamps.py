"""DTL, the date and time in parts: it is compared and calculated with as an LDT.

Source: TIA Portal help, "DTL (date and time)", "T_ADD", "T_SUB", "T_DIFF", "T_COMBINE".
"""

from datetime import UTC, datetime, timedelta

from fbgen.lang.checked import Constant, Convert, Expression, StandardCall
from fbgen.lang.types import (
    DATE,
    DATE_AND_TIME,
    DTL,
    LDT,
    TIME_OF_DAY,
    StructInitial,
    Type,
)

_EPOCH = datetime(1970, 1, 1, tzinfo=UTC)
_NS_PER_US = 1_000


def as_stamp(expression: Expression) -> Expression:
    """A DTL as the LDT of the same instant; anything else as it is."""
    if expression.type != DTL:
        return expression
    if isinstance(expression, Convert) and expression.operand.type == LDT:
        return expression.operand
    return Convert(expression.span, expression, LDT, implicit=True)


def in_parts(expression: Expression) -> Expression | None:
    """A date, or a date and time, as DTL; None for other types."""
    kind, span = expression.type, expression.span
    if kind == DATE:
        midnight = Constant(span, 0, TIME_OF_DAY)
        expression = StandardCall(span, "CONCAT_DATE_TOD", (expression, midnight), DATE_AND_TIME)
        kind = DATE_AND_TIME
    if kind == DATE_AND_TIME:
        expression, kind = Convert(span, expression, LDT), LDT
    return Convert(span, expression, DTL) if kind == LDT else None


def is_stamp(kind: Type) -> bool:
    """True for the types that a DTL is compared with."""
    return kind in (DTL, LDT, DATE_AND_TIME)


def stamp_initial(nanoseconds: int) -> StructInitial:
    """The parts of an instant, in nanoseconds since 1970, as the initial value of a DTL."""
    moment = _EPOCH + timedelta(microseconds=nanoseconds // _NS_PER_US)
    parts = {
        "YEAR": moment.year,
        "MONTH": moment.month,
        "DAY": moment.day,
        "WEEKDAY": moment.isoweekday() % 7 + 1,
        "HOUR": moment.hour,
        "MINUTE": moment.minute,
        "SECOND": moment.second,
        "NANOSECOND": nanoseconds % 1_000_000_000,
    }
    return StructInitial(tuple(parts.items()))
