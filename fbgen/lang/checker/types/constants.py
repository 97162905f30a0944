"""Literals, and expressions that have to be known before the program runs.

Sources: IEC 61131-3 third edition, tables 5 to 9; TIA Portal help, "Data types"; for S5TIME the
BCD form with the time base in bits 13 and 12 ("Format of S5TIME").
"""

import math
from datetime import date, timedelta

from fbgen.lang import ast
from fbgen.lang.checked import Constant, Convert, Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.types.coercion import coerce
from fbgen.lang.checker.types.conversions import UNSIGNED_OF
from fbgen.lang.checker.types.literals import (
    ERRONEOUS,
    UNTYPED_INTEGER,
    UNTYPED_REAL,
    erroneous,
    fitted,
    holds_untyped,
)
from fbgen.lang.dates import (
    DAYS,
    NS_PER_DAY,
    STAMPS,
    count_of,
    counted_in,
    exists_in,
    instant_of,
    is_in_range,
    limits_ns,
    of_dialect,
)
from fbgen.lang.types import (
    BOOL,
    CHAR,
    DATE,
    DATE_AND_TIME,
    DTL,
    ELEMENTARY,
    LDT,
    S5TIME,
    TIME,
    TIME_OF_DAY,
    WCHAR,
    Elementary,
    Scalar,
    StringType,
    Type,
)

_NS_PER_MS = 1_000_000
_EPOCH = date(1970, 1, 1)
_S5_BASES = ((0, 10), (1, 100), (2, 1000), (3, 10_000))
_COUNTED_IN_MS = (TIME, TIME_OF_DAY)
_UNPREFIXED = {
    ast.LiteralKind.DURATION: TIME,
    ast.LiteralKind.DATE: DATE,
    ast.LiteralKind.TIME_OF_DAY: TIME_OF_DAY,
    ast.LiteralKind.DATE_AND_TIME: DATE_AND_TIME,
}


def check_literal(ctx: Context, node: ast.Literal, _expected: Type | None = None) -> Expression:
    """A literal: typed by its prefix or its form, or else without a type of its own."""
    kind, value = node.kind, node.value
    if kind is ast.LiteralKind.ENUMERATOR:
        return ctx.library.types.enumerator(ctx, node)
    if kind in (ast.LiteralKind.STRING, ast.LiteralKind.WSTRING):
        return _text(ctx, node, str(value))
    if kind is ast.LiteralKind.BOOL:
        return Constant(node.span, bool(value), BOOL)
    if kind in (ast.LiteralKind.POINTER, ast.LiteralKind.ENUMERATOR):
        return _unknown_type(ctx, node)
    if kind in _UNPREFIXED:
        return _counted(ctx, node, int(value))
    if kind is ast.LiteralKind.REAL:
        if not math.isfinite(float(value)):
            return _refuse(ctx, node, "LREAL", "use a smaller number")
        constant = Constant(node.span, float(value), UNTYPED_REAL)
    else:
        if not holds_untyped(int(value)):
            return _refuse(ctx, node, "every integer type", "64 bits are the limit")
        constant = Constant(node.span, int(value), UNTYPED_INTEGER)
    if not node.type_name:
        return constant
    target = ELEMENTARY.get(node.type_name)
    if target is None:
        return _unknown_type(ctx, node)
    fitting = fitted(constant, target)
    if fitting is None:
        return _refuse(ctx, node, target.name, "use a value in its range or a wider type")
    return Constant(node.span, fitting, target)


def _refuse(ctx: Context, node: ast.Literal, kind: str, help_text: str) -> Expression:
    ctx.findings.error("FB4014", f"{node.text} is outside of {kind}", node.span, help_text)
    return erroneous(node.span)


def _unknown_type(ctx: Context, node: ast.Literal) -> Expression:
    ctx.findings.error(
        "FB4054",
        f"constants of type {node.type_name} are not supported",
        node.span,
        "use a constant of another type",
    )
    return erroneous(node.span)


def _text(ctx: Context, node: ast.Literal, value: str) -> Expression:
    wide = node.kind is ast.LiteralKind.WSTRING
    target: Type = StringType(max(1, len(value)), wide)
    if node.type_name in ("CHAR", "WCHAR"):
        target = WCHAR if node.type_name == "WCHAR" else CHAR
    fitting = fitted(Constant(node.span, value, StringType()), target)
    if fitting is None:
        return _refuse(
            ctx,
            node,
            target.name,
            "characters above 255 need WSTRING; CHAR takes exactly one character",
        )
    return Constant(node.span, fitting, target)


def _counted(ctx: Context, node: ast.Literal, value: int) -> Expression:
    """A duration, date or time of day in the unit of its type."""
    if node.type_name == "DTL":
        return Convert(node.span, Constant(node.span, value, LDT), DTL)
    target = ELEMENTARY.get(node.type_name) if node.type_name else _UNPREFIXED[node.kind]
    if target is None or not exists_in(target, ctx.rules.dialect):
        return _unknown_type(ctx, node)
    target = of_dialect(target, ctx.rules.dialect)
    if target == S5TIME:
        return _s5time(ctx, node, value)
    if counted_in(target):
        return _date(ctx, node, target, value)
    count = value
    if target in _COUNTED_IN_MS:
        count, rest = divmod(abs(value), _NS_PER_MS)
        count = count if value >= 0 else -count
        if rest:
            _warn_of_rest(ctx, node, target, "milliseconds")
    if not target.minimum <= count <= target.maximum:
        return _refuse(ctx, node, target.name, f"use a shorter time, or L{target.name}")
    return Constant(node.span, count, target)


def _date(ctx: Context, node: ast.Literal, target: Elementary, instant_ns: int) -> Expression:
    """A date, or a date with a time, as the type counts it."""
    if not is_in_range(target, instant_ns):
        first, last = (str(_EPOCH + timedelta(days=one // NS_PER_DAY)) for one in limits_ns(target))
        help_text = f"{target.name} lies between {first} and {last} here"
        if target in DAYS:
            help_text += ": take the first for none"
        return _refuse(ctx, node, target.name, help_text)
    count = count_of(target, instant_ns)
    if instant_of(target, count) != instant_ns:
        _warn_of_rest(ctx, node, target, "seconds")
    return Constant(node.span, count, target)


def _warn_of_rest(ctx: Context, node: ast.Literal, target: Elementary, unit: str) -> None:
    wider = "LDT" if target in STAMPS else f"L{target.name}"
    ctx.findings.warning(
        "FB4105",
        f"{target.name} counts whole {unit}: the rest of {node.text} is lost",
        node.span,
        f"write whole {unit}, or use {wider}",
    )


def _s5time(ctx: Context, node: ast.Literal, value: int) -> Expression:
    ms = value // _NS_PER_MS
    for code, base_ms in _S5_BASES:
        count = ms // base_ms
        if 0 <= count <= 999:
            bcd = int(str(count), 16)
            return Constant(node.span, code << 12 | bcd, S5TIME)
    return _refuse(ctx, node, "S5TIME", "S5TIME holds 0 to 2h46m30s; use TIME")


def constant_of(ctx: Context, node: ast.Expression, target: Type, where: str) -> Scalar | None:
    """The value of an expression that has to be constant; None after reporting why it is not."""
    expression = coerce(ctx, check_expression(ctx, node, target), target, where)
    if expression.type == ERRONEOUS:
        return None
    if isinstance(expression, Constant):
        return expression.value
    ctx.findings.error(
        "FB4017",
        f"{where} has to be constant",
        node.span,
        "use literals and VAR CONSTANT names only",
    )
    return None


def untyped_constant(ctx: Context, node: ast.Expression, where: str) -> Constant | None:
    """A constant with the type that its literals give it, if any; None after reporting."""
    expression = check_expression(ctx, node)
    if isinstance(expression, Constant):
        return expression
    if expression.type != ERRONEOUS:
        ctx.findings.error(
            "FB4017",
            f"{where} has to be constant",
            node.span,
            "use literals and the names of constants only",
        )
    return None


def whole_number(ctx: Context, node: ast.Expression, where: str) -> int | None:
    """The value of a constant expression of any integer type; None after reporting."""
    expression = check_expression(ctx, node)
    kind = expression.type
    if kind == ERRONEOUS:
        return None
    if not isinstance(expression, Constant):
        ctx.findings.error(
            "FB4017",
            f"{where} has to be constant",
            node.span,
            "use literals and VAR CONSTANT names only",
        )
        return None
    counts = ctx.rules.bits_are_numbers and kind in UNSIGNED_OF
    if isinstance(kind, Elementary) and (kind.is_integer or counts):
        return int(expression.value)
    ctx.findings.error(
        "FB4010", f"{where} is a whole number, not {kind}", node.span, "write an integer constant"
    )
    return None
