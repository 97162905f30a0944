"""Values of the PLC languages as terms of the solver, and the operations on them.

BOOL is a truth value; bit strings, integers, durations and dates are bit vectors of their width;
REAL and LREAL are IEEE numbers. Texts are values of which nothing is known but whether they are the
same. What is not said here raises `UnknownError`: nothing is proved of it.
"""

from functools import cache
from typing import Any, TypeAlias

import z3

from fbgen.lang.types import BOOL, Elementary, Family, StringType, Type, counting_type

Term: TypeAlias = Any
"""A term of the solver; the package has no types."""

Sort: TypeAlias = Any


class UnknownError(Exception):
    """Something that the proof says nothing of."""


_VECTORS = (Family.BITS, Family.SIGNED, Family.UNSIGNED, Family.DURATION, Family.DATE)


@cache
def text_sort() -> Sort:
    """Texts and characters."""
    return z3.DeclareSort("Text")


def sort_of(kind: Type) -> Sort:
    """The sort of a single value."""
    if isinstance(kind, StringType):
        return text_sort()
    if isinstance(kind, Elementary):
        kind = counting_type(kind)
        if kind == BOOL:
            return z3.BoolSort()
        if kind.family in _VECTORS:
            return z3.BitVecSort(kind.bits)
        if kind.family is Family.REAL:
            return z3.Float32() if kind.bits == 32 else z3.Float64()
        if kind.family is Family.CHAR:
            return text_sort()
    raise UnknownError(f"a value of type {kind}")


def is_single(kind: Type) -> bool:
    """True for a type whose values have no parts."""
    return isinstance(kind, Elementary | StringType)


def constant(value: bool | int | float | str, kind: Type) -> Term:
    """A value as a term."""
    sort = sort_of(kind)
    if isinstance(value, str):
        return z3.Const(f"text {value!r}", sort)
    if z3.is_fp_sort(sort):
        return z3.FPVal(float(value), sort)
    if sort == z3.BoolSort():
        return z3.BoolVal(bool(value))
    if sort == text_sort():
        return z3.Const(f"text {value!r}", sort)
    return z3.BitVecVal(int(value), sort)


def default(kind: Type) -> Term:
    """What a variable holds that nobody has given a value."""
    if sort_of(kind) == text_sort():
        return constant("", kind)
    return constant(0, kind)


def is_signed(kind: Type) -> bool:
    """True where the highest bit is a sign."""
    return isinstance(kind, Elementary) and counting_type(kind).is_signed


def is_real(kind: Type) -> bool:
    """True for REAL and LREAL."""
    return isinstance(kind, Elementary) and kind.family is Family.REAL


# --- operations -----------------------------------------------------------------------------------

_NEAREST = z3.RNE()


def unary(operator: str, operand: Term, kind: Type) -> Term:
    """NOT, or another sign."""
    if operator == "NOT":
        return z3.Not(operand) if kind == BOOL else ~operand
    if is_real(kind):
        return z3.fpNeg(operand)
    return -operand


def compare(operator: str, left: Term, right: Term, kind: Type) -> Term:
    """A comparison. Texts are only asked whether they are the same."""
    if is_real(kind):
        return _REAL_COMPARISONS[operator](left, right)
    if operator == "=":
        return left == right
    if operator == "<>":
        return left != right
    if not z3.is_bv(left):
        raise UnknownError(f"{operator} between values of type {kind}")
    return (_SIGNED if is_signed(kind) else _UNSIGNED)[operator](left, right)


_REAL_COMPARISONS = {
    "=": z3.fpEQ,
    "<>": lambda left, right: z3.Not(z3.fpEQ(left, right)),
    "<": z3.fpLT,
    "<=": z3.fpLEQ,
    ">": z3.fpGT,
    ">=": z3.fpGEQ,
}
_SIGNED = {
    "<": lambda left, right: left < right,
    "<=": lambda left, right: left <= right,
    ">": lambda left, right: left > right,
    ">=": lambda left, right: left >= right,
}
_UNSIGNED = {"<": z3.ULT, "<=": z3.ULE, ">": z3.UGT, ">=": z3.UGE}


def logical(operator: str, left: Term, right: Term, kind: Type) -> Term:
    """AND, OR, XOR of truth values or bit by bit; both sides are known."""
    if kind == BOOL:
        return {
            "AND": z3.And,
            "AND_THEN": z3.And,
            "OR": z3.Or,
            "OR_ELSE": z3.Or,
            "XOR": z3.Xor,
        }[operator](left, right)
    if operator == "AND":
        return left & right
    return left | right if operator == "OR" else left ^ right


def calculate(operator: str, left: Term, right: Term, kind: Type) -> Term:
    """+ - * on values of one type; / on REAL. Whole numbers wrap around."""
    if is_real(kind):
        return _REAL_CALCULATIONS[operator](_NEAREST, left, right)
    if operator == "+":
        return left + right
    return left - right if operator == "-" else left * right


_REAL_CALCULATIONS = {"+": z3.fpAdd, "-": z3.fpSub, "*": z3.fpMul, "/": z3.fpDiv}


def divide(operator: str, left: Term, right: Term, kind: Type) -> Term:
    """/ and MOD on whole numbers: cut towards zero, the sign of the dividend."""
    if operator == "/":
        return left / right if is_signed(kind) else z3.UDiv(left, right)
    return z3.SRem(left, right) if is_signed(kind) else z3.URem(left, right)


# --- conversions ----------------------------------------------------------------------------------

_COUNTED = (Family.BITS, Family.SIGNED, Family.UNSIGNED)


def convert(operand: Term, source: Type, target: Type, rounding: str) -> tuple[Term, Term]:
    """The value in another type, and whether it does not fit, which stops the program."""
    fits_not = z3.BoolVal(False)
    if source == target:
        return operand, fits_not
    if not isinstance(source, Elementary) or not isinstance(target, Elementary):
        raise UnknownError(f"{source} to {target}")
    if type(target) is not Elementary or type(source) is not Elementary:
        raise UnknownError(f"{source} to {target}")
    families = source.family, target.family
    whole = (*_COUNTED, Family.DURATION)
    same_time = Family.DURATION not in families or source.bits == target.bits == 32
    if source == BOOL and target.family in _COUNTED:
        bits = target.bits
        return z3.If(operand, z3.BitVecVal(1, bits), z3.BitVecVal(0, bits)), fits_not
    if target == BOOL and source.family in _COUNTED:
        return z3.Extract(0, 0, operand) == 1, fits_not
    if families[0] in whole and families[1] in whole and same_time:
        return _resized(operand, source, target.bits), fits_not
    if families[0] in (Family.SIGNED, Family.UNSIGNED) and families[1] is Family.REAL:
        make = z3.fpSignedToFP if is_signed(source) else z3.fpUnsignedToFP
        return make(_NEAREST, operand, sort_of(target)), fits_not
    if families == (Family.REAL, Family.REAL):
        return z3.fpFPToFP(_NEAREST, operand, sort_of(target)), fits_not
    if families[0] is Family.REAL and families[1] in (Family.SIGNED, Family.UNSIGNED):
        return _rounded(operand, source, target, rounding)
    raise UnknownError(f"{source} to {target}")


def _resized(operand: Term, source: Elementary, bits: int) -> Term:
    if bits <= source.bits:
        return operand if bits == source.bits else z3.Extract(bits - 1, 0, operand)
    more = bits - source.bits
    return z3.SignExt(more, operand) if is_signed(source) else z3.ZeroExt(more, operand)


def _rounded(
    operand: Term, source: Elementary, target: Elementary, rounding: str
) -> tuple[Term, Term]:
    mode = _NEAREST if rounding == "nearest" else z3.RTZ()
    wide = z3.Float64()
    exact = operand if source.bits == 64 else z3.fpFPToFP(_NEAREST, operand, wide)
    whole = z3.fpRoundToIntegral(mode, exact)
    if target.bits > 32:
        raise UnknownError(f"{source} to {target}")
    lowest, highest = (z3.FPVal(float(one), wide) for one in (target.minimum, target.maximum))
    fits = z3.And(z3.fpLEQ(lowest, whole), z3.fpLEQ(whole, highest))
    make = z3.fpToSBV if target.is_signed else z3.fpToUBV
    return make(z3.RTZ(), whole, z3.BitVecSort(target.bits)), z3.Not(fits)
