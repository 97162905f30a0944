"""Standard functions on numbers, bit strings and any values.

Each takes the argument values and what it needs to know of their types, and gives the value.
Sources: IEC 61131-3 third edition, tables 28 (numeric), 30 (shifts), 31 (selection); TIA Portal
help, "Shift and rotate", for signed shifts.
"""

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

from fbgen.dataclass import dataclass
from fbgen.lang.types import Elementary, Family, Scalar, Type
from fbgen.source import Span
from harness.engine.faults import selector_out_of_range
from harness.engine.reference.arithmetic import compare, real_divided, rounded, whole, wrap


@dataclass(frozen=True, slots=True)
class Signature:
    """The types around a call, the dialect's rules, and the place of the call for faults."""

    arguments: tuple[Type, ...]
    result: Type
    on_s7: bool
    span: Span

    @property
    def number(self) -> Elementary:
        """The type of the first argument, which is elementary."""
        kind = self.arguments[0]
        assert isinstance(kind, Elementary)
        return kind


Function = Callable[[Sequence[Scalar], Signature], Scalar]


def _real(function: Callable[[float], float]) -> Function:
    """A function of one floating-point number; NaN outside of where it is defined."""

    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        operand = values[0]
        assert isinstance(operand, float)
        try:
            result = function(operand)
        except OverflowError:
            result = math.inf
        except ValueError:
            result = math.nan
        return rounded(signature.number, result)

    return call


def _logarithm(function: Callable[[float], float]) -> Function:
    """A logarithm; that of zero is minus infinite."""
    return _real(lambda operand: -math.inf if operand == 0 else function(operand))


def _absolute(values: Sequence[Scalar], signature: Signature) -> Scalar:
    operand = values[0]
    if isinstance(operand, float):
        return abs(operand)
    assert isinstance(operand, int)
    return wrap(signature.number, abs(operand))


def _square(values: Sequence[Scalar], signature: Signature) -> Scalar:
    operand = values[0]
    if isinstance(operand, float):
        return rounded(signature.number, operand * operand)
    assert isinstance(operand, int)
    return wrap(signature.number, operand * operand)


def _towards(function: Callable[[float], int]) -> Function:
    """CEIL and FLOOR: a whole number of the result's type. Raises FB6006."""

    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        operand = values[0]
        assert isinstance(operand, float)
        assert isinstance(signature.result, Elementary)
        if not math.isfinite(operand):
            return whole(signature.result, operand, signature.span)
        return whole(signature.result, float(function(operand)), signature.span)

    return call


def _to_whole_real(function: Callable[[float], int]) -> Function:
    """A floating-point number without fraction; what is not finite stays as it is."""

    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        operand = values[0]
        assert isinstance(operand, float)
        if not math.isfinite(operand):
            return operand
        return rounded(signature.number, math.copysign(float(function(operand)), operand))

    return call


def _arc_tangent(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """ATAN2(IN1: y, IN2: x)."""
    y, x = values
    assert isinstance(y, float)
    assert isinstance(x, float)
    return rounded(signature.number, math.atan2(y, x))


def _is_valid(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return math.isfinite(float(values[0]))


def _normalize(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """NORM_X(MIN, VALUE, MAX): 0 at MIN and 1 at MAX, without limits."""
    low, value, high = (_number(one) for one in values)
    assert isinstance(signature.result, Elementary)
    return rounded(signature.result, real_divided(float(value - low), float(high - low)))


def _scale(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """SCALE_X(MIN, VALUE, MAX): MIN at 0 and MAX at 1, without limits. Raises FB6006."""
    low, value, high = (_number(one) for one in values)
    result = value * float(high - low) + float(low)
    assert isinstance(signature.result, Elementary)
    if signature.result.family is Family.REAL:
        return rounded(signature.result, result)
    return whole(signature.result, result, signature.span)


def _number(value: Scalar) -> int | float:
    assert isinstance(value, int | float)
    return value


def _chain(operator: str) -> Function:
    """A comparison of each argument with the next one."""

    def call(values: Sequence[Scalar], signature: Signature) -> Scalar:
        return all(compare(operator, *pair) for pair in pairwise(values))

    return call


def _shift_left(values: Sequence[Scalar], signature: Signature) -> Scalar:
    operand, count = _shifted(values)
    width = signature.number.bits
    return wrap(signature.number, operand << count) if 0 <= count < width else 0


def _shift_right(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """Signed types take over the sign on S7; everything else is filled with zeros."""
    operand, count = _shifted(values)
    kind = signature.number
    if not 0 <= count < kind.bits:
        count = kind.bits
    if signature.on_s7:
        return wrap(kind, operand >> count)
    return wrap(kind, (operand & ((1 << kind.bits) - 1)) >> count)


def _rotate_left(values: Sequence[Scalar], signature: Signature) -> Scalar:
    operand, count = _shifted(values)
    return _rotated(signature.number, operand, count)


def _rotate_right(values: Sequence[Scalar], signature: Signature) -> Scalar:
    operand, count = _shifted(values)
    return _rotated(signature.number, operand, -count)


def _rotated(kind: Elementary, operand: int, left: int) -> int:
    count = left % kind.bits
    pattern = operand & ((1 << kind.bits) - 1)
    return wrap(kind, pattern << count | pattern >> (kind.bits - count))


def _shifted(values: Sequence[Scalar]) -> tuple[int, int]:
    operand, count = values
    assert isinstance(operand, int)
    assert isinstance(count, int)
    return operand, count


def _swap(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """The bytes in reverse order."""
    operand = values[0]
    assert isinstance(operand, int)
    return int.from_bytes(operand.to_bytes(signature.number.bits // 8, "big"), "little")


def _select(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return values[2] if values[0] else values[1]


def _multiplex(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """MUX(K, IN0, IN1, ...). Raises FB6009."""
    selector, *inputs = values
    assert isinstance(selector, int)
    if not 0 <= selector < len(inputs):
        raise selector_out_of_range(signature.span, selector, len(inputs))
    return inputs[selector]


def _multiplex_or_else(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """MUX(K, IN0, IN1, ..., INELSE)."""
    selector, *inputs, otherwise = values
    assert isinstance(selector, int)
    return inputs[selector] if 0 <= selector < len(inputs) else otherwise


def _maximum(values: Sequence[Scalar], signature: Signature) -> Scalar:
    result = values[0]
    for value in values[1:]:
        result = value if _less(result, value) else result
    return result


def _minimum(values: Sequence[Scalar], signature: Signature) -> Scalar:
    result = values[0]
    for value in values[1:]:
        result = value if _less(value, result) else result
    return result


def _limit(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """LIMIT(MN, IN, MX): the upper limit is applied last."""
    low, result, high = values
    result = low if _less(result, low) else result
    return high if _less(high, result) else result


def limits_cross(values: Sequence[Scalar]) -> bool:
    """True for the operands of a LIMIT whose lower limit lies above the upper one."""
    low, _, high = values
    return _less(high, low)


def _limit_or_operand(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """LIMIT of TIA Portal: nothing is limited where the limits cross."""
    return values[1] if limits_cross(values) else _limit(values, signature)


def _less(left: Scalar, right: Scalar) -> bool:
    if isinstance(left, str) and isinstance(right, str):
        return left < right
    assert not isinstance(left, str)
    assert not isinstance(right, str)
    return left < right


NUMERIC_FUNCTIONS: dict[str, Function] = {
    "ABS": _absolute,
    "SQRT": _real(math.sqrt),
    "SQR": _square,
    "LN": _logarithm(math.log),
    "LOG": _logarithm(math.log10),
    "EXP": _real(math.exp),
    "SIN": _real(math.sin),
    "COS": _real(math.cos),
    "TAN": _real(math.tan),
    "ASIN": _real(math.asin),
    "ACOS": _real(math.acos),
    "ATAN": _real(math.atan),
    "ATAN2": _arc_tangent,
    "IS_VALID": _is_valid,
    "NORM_X": _normalize,
    "SCALE_X": _scale,
    "ROUND_REAL": _to_whole_real(round),
    "TRUNC_REAL": _to_whole_real(math.trunc),
    "CEIL_REAL": _to_whole_real(math.ceil),
    "FLOOR_REAL": _to_whole_real(math.floor),
    "GT": _chain(">"),
    "GE": _chain(">="),
    "EQ": _chain("="),
    "LE": _chain("<="),
    "LT": _chain("<"),
    "FRAC": _real(lambda operand: math.modf(operand)[0]),
    "CEIL": _towards(math.ceil),
    "FLOOR": _towards(math.floor),
    "SHL": _shift_left,
    "SHR": _shift_right,
    "ROL": _rotate_left,
    "ROR": _rotate_right,
    "SWAP": _swap,
    "SEL": _select,
    "MUX": _multiplex,
    "MUX_ELSE": _multiplex_or_else,
    "MAX": _maximum,
    "MIN": _minimum,
    "LIMIT": _limit,
    "LIMIT_OR_IN": _limit_or_operand,
}
"""By canonical name."""
