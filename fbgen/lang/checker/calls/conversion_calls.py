"""Conversions by their names: which types X_TO_Y and TO_Y have, and what they become.

Sources as for `conversions`.
"""

from collections.abc import Callable
from typing import TypeAlias

from fbgen.lang.checked import Binary, Constant, Convert, Expression, StandardCall
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.rules import Rules
from fbgen.lang.checker.supplied.standard_functions import STANDARD_FUNCTIONS, TEXT_CONVERSIONS
from fbgen.lang.checker.types.coercion import converted, spelled
from fbgen.lang.checker.types.conversions import UNSIGNED_OF, elementary_named, is_convertible
from fbgen.lang.checker.types.folding import fold_conversion
from fbgen.lang.checker.types.literals import erroneous
from fbgen.lang.checker.types.stamps import as_stamp, in_parts
from fbgen.lang.types import (
    BOOL,
    DTL,
    LREAL,
    LTIME,
    LTIME_OF_DAY,
    REAL,
    TIME,
    TIME_OF_DAY,
    UDINT,
    ULINT,
    USINT,
    Elementary,
    Enumeration,
    StringType,
    Subrange,
    Type,
)
from fbgen.source import Span

_Steps: TypeAlias = Callable[[Span, Expression], Expression]


def conversion_types(key: str) -> tuple[Type | None, Type] | None:
    """What `X_TO_Y` or `TO_Y` converts; None if it is no conversion."""
    source_name, middle, target_name = key.rpartition("_TO_")
    if not middle:
        if not key.startswith("TO_"):
            return None
        target = elementary_named(key[3:])
        return None if target is None else (None, target)
    source, target = elementary_named(source_name), elementary_named(target_name)
    if source is None or target is None:
        return None
    if is_convertible(source, target) or _text_conversion(source, target) in TEXT_CONVERSIONS:
        return source, target
    return (source, target) if (source, target) in _IN_STEPS else None


def _text_conversion(source: Type, target: Type) -> str:
    return f"{_short(source)}_TO_{_short(target)}"


def convert_to_type(
    ctx: Context,
    span: Span,
    key: str,
    operand: Expression,
    target: Type,
    *,
    rounding: str = "nearest",
) -> Expression:
    """The operand in another type, as the function `key` converts it; reports what cannot be."""
    source = operand.type
    if isinstance(source, Enumeration | Subrange):
        operand = converted(operand, source.base)
        source = source.base
    if source == DTL and target != DTL:
        operand = as_stamp(operand)
        source = operand.type
    parts = in_parts(operand) if target == DTL else None
    if parts is not None:
        return parts
    by_name = _text_conversion(source, target)
    if by_name in TEXT_CONVERSIONS:
        return StandardCall(span, by_name, (operand,), target)
    if by_name in STANDARD_FUNCTIONS:
        return StandardCall(span, by_name, (operand,), target)
    if (source, target) in _IN_STEPS:
        return _IN_STEPS[source, target](span, operand)
    if not is_convertible(source, target):
        ctx.findings.error(
            "FB4010",
            f"{key} cannot convert {spelled(source)} to {spelled(target)}",
            operand.span,
            "convert in two steps, over a type that both sides know",
        )
        return erroneous(span)
    if source == target:
        return operand
    if target == BOOL and _whole_number_decides(ctx.rules, source):
        assert isinstance(source, Elementary)
        return Binary(span, "<>", operand, Constant(span, 0, source), BOOL)
    if isinstance(operand, Constant):
        value = fold_conversion(operand, target, rounding)
        if value is not None:
            return Constant(span, value, target)
    return Convert(span, operand, target, rounding=rounding)


def _whole_number_decides(rules: Rules, source: Type) -> bool:
    """X_TO_BOOL asks for a number other than 0; CODESYS takes a bit string for a number there."""
    counts = is_integer(source) or (rules.bits_are_numbers and source in UNSIGNED_OF)
    return counts and not rules.lowest_bit_is_bool


def _not_zero(span: Span, operand: Expression) -> Expression:
    return Binary(span, "<>", operand, Constant(span, 0.0, operand.type), BOOL)


def _by(*kinds: Elementary) -> Callable[[Span, Expression], Expression]:
    """Over the counts that both sides have."""

    def convert(span: Span, operand: Expression) -> Expression:
        for kind in kinds:
            operand = Convert(span, operand, kind)
        return operand

    return convert


_IN_STEPS: dict[tuple[Type, Type], _Steps] = {
    (BOOL, REAL): _by(USINT, REAL),
    (BOOL, LREAL): _by(USINT, LREAL),
    (REAL, BOOL): _not_zero,
    (LREAL, BOOL): _not_zero,
    (TIME, TIME_OF_DAY): _by(UDINT, TIME_OF_DAY),
    (TIME_OF_DAY, TIME): _by(UDINT, TIME),
    (LTIME, LTIME_OF_DAY): _by(ULINT, LTIME_OF_DAY),
    (LTIME_OF_DAY, LTIME): _by(ULINT, LTIME),
}
"""Conversions that are made of others."""


def is_integer(kind: Type) -> bool:
    """True for the types that calculate with whole numbers."""
    return isinstance(kind, Elementary) and kind.is_integer


def _short(kind: Type) -> str:
    if isinstance(kind, StringType):
        return "WSTRING" if kind.wide else "STRING"
    return kind.name
