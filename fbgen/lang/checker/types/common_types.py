"""The one type that the arguments of a standard function are brought to.

Sources as for `standard_functions`.
"""

from fbgen.lang.checked import Constant, Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.supplied.function_signatures import FAMILIES, WITH_TEXT, Common, Function
from fbgen.lang.checker.types.coercion import as_typed
from fbgen.lang.checker.types.conversions import common_type, widens
from fbgen.lang.checker.types.literals import fitted, is_untyped, settled_bits
from fbgen.lang.dates import DAYS, STAMPS
from fbgen.lang.types import (
    LREAL,
    REAL,
    UDINT,
    UINT,
    ULINT,
    USINT,
    Elementary,
    Enumeration,
    StringType,
    Type,
)

_LONGEST_TEXT = StringType()


def common_type_of(
    ctx: Context, function: Function, operands: list[Expression], hint: Type | None
) -> Type | None:
    """The type that all operands become by themselves, out of the function's types."""
    kind: Type | None = None
    untyped = []
    for operand in operands:
        if isinstance(operand, Constant) and is_untyped(operand.type):
            untyped.append(operand)
            continue
        kind = operand.type if kind is None else common_type(kind, operand.type, ctx.rules)
        if isinstance(operand.type, StringType) and isinstance(kind, StringType):
            kind = StringType(max(kind.length, _LONGEST_TEXT.length), kind.wide)
        if kind is None:
            return None
    if kind is None:
        kind = _for_constants(ctx, function, untyped, hint)
    kind = _within(ctx, function, kind)
    if kind is None or isinstance(kind, StringType):
        return kind
    for constant in untyped:
        if fitted(constant, kind) is None:
            kind = common_type(kind, as_typed(constant).type, ctx.rules)
            if kind is None:
                return None
    return _within(ctx, function, kind)


def _for_constants(
    ctx: Context, function: Function, constants: list[Constant], hint: Type | None
) -> Type:
    """The type of a call that has nothing but untyped constants."""
    if (
        hint is not None
        and _within(ctx, function, hint) == hint
        and all(fitted(constant, hint) is not None for constant in constants)
    ):
        return hint
    bits = function.common in (Common.SHIFTED, Common.SWAPPED)
    if function.common is Common.UNSIGNED:
        return next(
            (kind for kind in (USINT, UINT, UDINT) if fitted(constants[0], kind) is not None), ULINT
        )
    kinds = [
        (settled_bits(constant) if bits else as_typed(constant)).type for constant in constants
    ]
    kind: Type = kinds[0]
    for other in kinds[1:]:
        kind = common_type(kind, other, ctx.rules) or kind
    return kind


def _within(ctx: Context, function: Function, kind: Type) -> Type | None:
    """The type itself, or the one it becomes, that the function takes."""
    common = function.common
    if isinstance(kind, StringType):
        return kind if common in WITH_TEXT else None
    if not isinstance(kind, Elementary):
        return None
    if isinstance(kind, Enumeration):
        return kind if common is Common.ANY else None
    if common is Common.TEXT:
        text = StringType(wide=kind.bits == 16)
        return text if widens(kind, text, ctx.rules) else None
    if common is Common.DAYS:
        return kind if kind in (*DAYS, *STAMPS) else None
    if kind.family in FAMILIES[common] and not (common is Common.SWAPPED and kind.bits < 16):
        return kind
    if common is Common.SHIFTED and kind.is_integer and ctx.rules.shifts_integers:
        return kind
    if common is Common.FLOATING:
        return next((real for real in (REAL, LREAL) if widens(kind, real, ctx.rules)), None)
    return None
