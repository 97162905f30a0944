"""Operators: exact widths, wrap-around, rounding.

Whole numbers, bit strings and durations wrap around in two's complement of their width. REAL is
calculated in 64 bit and rounded to 32 bit after each operation, which for + - * / and the square
root is the same as calculating in 32 bit. Floating point follows IEEE 754 without traps: 1.0/0.0
is infinite, 0.0/0.0 and the root of -1.0 are NaN, NaN is unequal to everything.
Sources: IEC 61131-3 third edition, tables 28 to 33; types and results as in
`fbgen.lang.checked.Binary`.
"""

import math
from ctypes import c_float

from fbgen.lang.types import Elementary, Family, Scalar, Type
from fbgen.source import Span
from harness.engine.faults import division_by_zero, value_out_of_range

COMPARISONS = ("=", "<>", "<", ">", "<=", ">=")


def wrap(kind: Elementary, number: int) -> int:
    """The low bits of a whole number, read in the type: what is left after an overflow."""
    low = number & ((1 << kind.bits) - 1)
    return low - (1 << kind.bits) if kind.is_signed and low > kind.maximum else low


def rounded(kind: Elementary, number: float) -> float:
    """A floating-point number in the precision of the type; too large becomes infinite."""
    return c_float(number).value if kind.bits == 32 else number


def whole(kind: Elementary, number: float, span: Span, rounding: str = "nearest") -> int:
    """A floating-point number as a whole one; `rounding` as in `Convert`. Raises FB6006."""
    if not math.isfinite(number):
        raise value_out_of_range(span, number, kind)
    result = math.trunc(number) if rounding == "truncate" else round(number)
    if not kind.minimum <= result <= kind.maximum:
        raise value_out_of_range(span, number, kind)
    return result


def unary(operator: str, operand: Scalar, kind: Type) -> Scalar:
    """NOT and -."""
    assert isinstance(kind, Elementary)
    if operator == "NOT":
        if isinstance(operand, bool):
            return not operand
        assert isinstance(operand, int)
        return wrap(kind, ~operand)
    if isinstance(operand, float):
        return -operand
    assert isinstance(operand, int)
    return wrap(kind, -operand)


def binary(operator: str, left: Scalar, right: Scalar, kind: Type, span: Span) -> Scalar:
    """An operator on two values; `kind` is the type of the left one."""
    if operator in COMPARISONS:
        return compare(operator, left, right)
    assert isinstance(kind, Elementary)
    if operator == "**":
        assert isinstance(left, int | float)
        assert isinstance(right, int | float)
        return power(kind, left, right, span)
    if isinstance(left, bool):
        assert isinstance(right, bool)
        return _logic(operator, left, right) != 0
    if isinstance(left, float):
        assert isinstance(right, float)
        return rounded(kind, _on_reals(operator, left, right))
    assert isinstance(left, int)
    if isinstance(right, float):
        return _scaled_duration(operator, left, right, kind, span)
    assert isinstance(right, int)
    return wrap(kind, _on_whole_numbers(operator, left, right, span))


def compare(operator: str, left: Scalar, right: Scalar) -> bool:
    """One of the six comparisons; texts compare character by character."""
    if operator == "=":
        return left == right
    if operator == "<>":
        return left != right
    if isinstance(left, str):
        assert isinstance(right, str)
        ascending, equal = left < right, left == right
        unordered = False
    else:
        assert not isinstance(right, str)
        ascending, equal = left < right, left == right
        unordered = not ascending and not equal and not left > right
    match operator:
        case "<":
            return ascending
        case "<=":
            return ascending or equal
        case ">":
            return not (ascending or equal or unordered)
        case _:
            return not (ascending or unordered)


def power(kind: Elementary, base: float, exponent: float, span: Span) -> Scalar:
    """`base ** exponent` in the type of the base.

    A whole base with a whole exponent is exact and wraps around; a negative exponent gives the
    whole part of the fraction. Everything else is floating point.
    """
    if isinstance(base, int) and isinstance(exponent, int):
        if exponent >= 0:
            return wrap(kind, pow(base, exponent, 1 << kind.bits))
        if base == 0:
            raise division_by_zero(span)
        if base in (1, -1):
            return wrap(kind, base if exponent % 2 else 1)
        return 0
    result = real_power(float(base), float(exponent))
    if kind.family is Family.REAL:
        return rounded(kind, result)
    return whole(kind, result, span)


def real_power(base: float, exponent: float) -> float:
    """IEEE 754 power: NaN for the root of a negative number, infinite for 0 to a negative one."""
    try:
        return math.pow(base, exponent)
    except OverflowError:
        negative = base < 0 and exponent % 2 == 1
        return -math.inf if negative else math.inf
    except ValueError:
        if base != 0:
            return math.nan
        odd = exponent % 2 == 1
        return math.copysign(math.inf, base) if odd else math.inf


def divided(left: int, right: int, span: Span) -> int:
    """Whole-number division, cut towards zero. Raises FB6003."""
    if right == 0:
        raise division_by_zero(span)
    quotient = abs(left) // abs(right)
    return quotient if (left < 0) == (right < 0) else -quotient


def real_divided(left: float, right: float) -> float:
    """IEEE 754 division, which is defined for zero."""
    if right != 0:
        return left / right
    if left == 0 or math.isnan(left):
        return math.nan
    return math.copysign(math.inf, left) * math.copysign(1.0, right)


def _logic(operator: str, left: int, right: int) -> int:
    match operator:
        case "AND":
            return left & right
        case "OR":
            return left | right
        case _:
            assert operator == "XOR"
            return left ^ right


def _on_whole_numbers(operator: str, left: int, right: int, span: Span) -> int:
    match operator:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/":
            return divided(left, right, span)
        case "MOD":
            return left - divided(left, right, span) * right
        case _:
            return _logic(operator, left, right)


def _on_reals(operator: str, left: float, right: float) -> float:
    match operator:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case _:
            assert operator == "/"
            return real_divided(left, right)


def _scaled_duration(
    operator: str, left: int, right: float, kind: Elementary, span: Span
) -> Scalar:
    """TIME * REAL and TIME / REAL: to the nearest tick, ties to even. Raises FB6003, FB6006."""
    if operator == "*":
        return whole(kind, left * right, span)
    assert operator == "/"
    if right == 0:
        raise division_by_zero(span)
    return whole(kind, left / right, span)
