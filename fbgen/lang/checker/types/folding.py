"""Calculating with constants while checking, by the same rules as the running program.

A result that would wrap around or is not finite is left to the running program: then there is
no constant. Sources: the semantics of `Binary`, `Unary` and `Convert` in `fbgen.lang.checked`.
"""

import operator
from collections.abc import Callable

from fbgen.lang.checked import Constant
from fbgen.lang.checker.types.literals import in_real, nearest_real
from fbgen.lang.types import BOOL, Elementary, Family, Scalar, StringType, Type
from fbgen.source import Span

COMPARISONS: dict[str, Callable[[Scalar, Scalar], bool]] = {
    "=": operator.eq,
    "<>": operator.ne,
    "<": operator.lt,
    ">": operator.gt,
    "<=": operator.le,
    ">=": operator.ge,
}
LOGIC: dict[str, Callable[[int, int], int]] = {
    "AND": operator.and_,
    "OR": operator.or_,
    "XOR": operator.xor,
    "AND_THEN": operator.and_,
    "OR_ELSE": operator.or_,
}
SHORT_CIRCUIT = ("AND_THEN", "OR_ELSE")
"""Those of `LOGIC` that take BOOL only and may leave their right side out."""
_LARGEST_EXPONENT = 64


def quotient(left: int, right: int) -> int:
    """Integer division that cuts towards zero."""
    whole = abs(left) // abs(right)
    return whole if (left < 0) == (right < 0) else -whole


def integer_result(symbol: str, left: int, right: int) -> int | None:
    """Unbounded arithmetic of whole numbers; None for what has no result."""
    if symbol == "+":
        return left + right
    if symbol == "-":
        return left - right
    if symbol == "*":
        return left * right
    if symbol == "**":
        if 0 <= right <= _LARGEST_EXPONENT:
            power: int = left**right
            return power
        return None
    if right == 0:
        return None
    whole = quotient(left, right)
    return whole if symbol in ("/", "DIV") else left - right * whole


def real_result(symbol: str, left: float, right: float) -> float | None:
    """Arithmetic of floating point numbers; None for what has no result."""
    try:
        if symbol == "+":
            return left + right
        if symbol == "-":
            return left - right
        if symbol == "*":
            return left * right
        if symbol == "/":
            return left / right
    except (ZeroDivisionError, OverflowError):
        return None
    return None


def fold_comparison(span: Span, symbol: str, left: Constant, right: Constant) -> Constant:
    """Compare two constants of one type."""
    return Constant(span, COMPARISONS[symbol](left.value, right.value), BOOL)


def fold_logic(span: Span, symbol: str, left: Constant, right: Constant) -> Constant:
    """AND, OR, XOR of two constants of one type."""
    value = LOGIC[symbol](int(left.value), int(right.value))
    return Constant(span, bool(value) if left.type == BOOL else value, left.type)


def fold_arithmetic(
    span: Span, symbol: str, left: Constant, right: Constant, kind: Elementary
) -> Constant | None:
    """Calculate with two constants; None if that is left to the running program."""
    if kind.family is Family.REAL:
        result = real_result(symbol, float(left.value), float(right.value))
        number = None if result is None else in_real(result, kind)
        return None if number is None else Constant(span, number, kind)
    if isinstance(right.value, float):
        return None
    whole = integer_result(symbol, int(left.value), int(right.value))
    if whole is None or not kind.minimum <= whole <= kind.maximum:
        return None
    return Constant(span, whole, kind)


def fold_unary(span: Span, symbol: str, operand: Constant, kind: Elementary) -> Constant | None:
    """NOT or - of a constant; None if that is left to the running program."""
    if symbol == "NOT":
        if kind == BOOL:
            return Constant(span, not operand.value, kind)
        return Constant(span, int(operand.value) ^ kind.maximum, kind)
    if kind.family is Family.REAL:
        return Constant(span, -float(operand.value), kind)
    value = -int(operand.value)
    return Constant(span, value, kind) if value <= kind.maximum else None


def fold_conversion(constant: Constant, target: Type, rounding: str = "nearest") -> Scalar | None:
    """The value of a typed constant in another type; None if that is left to the program."""
    source, value = constant.type, constant.value
    if isinstance(source, StringType) or isinstance(target, StringType):
        return None
    if not isinstance(source, Elementary) or not isinstance(target, Elementary):
        return None
    counts = (Family.SIGNED, Family.UNSIGNED, Family.BITS)
    if target.family is Family.REAL and source.family in (Family.SIGNED, Family.UNSIGNED):
        return nearest_real(int(value), target)
    if source.family is Family.REAL and target.is_integer:
        whole = int(value) if rounding == "truncate" else round(float(value))
        return whole if target.minimum <= whole <= target.maximum else None
    if target.family is Family.REAL and source.family is Family.REAL:
        return in_real(float(value), target)
    if source.family in (*counts, Family.BOOL) and target.family in counts:
        low = int(value) & ((1 << target.bits) - 1)
        return low - (1 << target.bits) if low > target.maximum else low
    if (source.name, target.name) == ("TIME", "LTIME"):
        return int(value) * 1_000_000
    return None
