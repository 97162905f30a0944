"""Whether a calculation gave what it should, for `Attempt`."""

import math
from collections.abc import Sequence

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Binary, Convert, StandardCall, Unary
from fbgen.lang.types import Elementary, Family, Scalar, Type
from harness.engine.reference.functions import limits_cross

_CALCULATIONS = ("FB6003", "FB6006", "FB6007", "FB6009", "FB6014")
_COUNTED = (Family.SIGNED, Family.UNSIGNED, Family.DURATION)


def is_bad_calculation(stop: DiagnosticError) -> bool:
    """True if a calculation could not be done; False for what stops the program anyhow."""
    return all(one.code in _CALCULATIONS for one in stop.diagnostics)


def nothing(kind: Type) -> Scalar:
    """What comes out of a calculation that could not be done."""
    if not isinstance(kind, Elementary):
        return ""
    if kind.family is Family.BOOL:
        return False
    if kind.family is Family.REAL:
        return 0.0
    return "\0" if kind.family is Family.CHAR else 0


def is_right(
    operand: Unary | Binary | Convert | StandardCall, values: Sequence[Scalar], result: Scalar
) -> bool:
    """True if nothing was cut off to fit the result into its type, and no limits cross."""
    if isinstance(operand, StandardCall) and operand.name == "LIMIT_OR_IN" and limits_cross(values):
        return False
    if isinstance(result, float):
        return math.isfinite(result)
    kinds = [operand.type, *_operand_types(operand)]
    if not all(isinstance(kind, Elementary) and kind.family in _COUNTED for kind in kinds):
        return True
    match operand:
        case Convert():
            return result == values[0]
        case Unary():
            return operand.operator != "-" or result == -int(values[0])
        case Binary():
            left, right = int(values[0]), int(values[1])
            exact = {"+": left + right, "-": left - right, "*": left * right}
            if operand.operator == "/" and right == -1:
                return result == -left
            return operand.operator not in exact or result == exact[operand.operator]
        case StandardCall():
            return True


def _operand_types(operand: Unary | Binary | Convert | StandardCall) -> list[Type]:
    match operand:
        case Binary():
            return [operand.left.type, operand.right.type]
        case Unary() | Convert():
            return [operand.operand.type]
        case StandardCall():
            return []
