"""Calculations that say whether they work instead of stopping the program."""

from fbgen.lang.checked import Attempt, Binary, Convert, StandardCall, Unary
from fbgen.lang.types import Elementary, Family, Type
from harness.engine.compiled.code import Code
from harness.engine.compiled.evaluation import Write, expression, value
from harness.engine.compiled.expressions.function_code import all_of
from harness.engine.compiled.expressions.places import cell
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits

_WHOLE = (Family.SIGNED, Family.UNSIGNED, Family.DURATION)


def _attempt(procedure: Procedure, node: Attempt) -> Code:
    operand = node.operand
    flag = cell(procedure, node.flag)
    low, high = limits(node.type)
    if _can_overflow(operand):
        code = _exact(procedure, operand)
        text = f"_attempt_whole({flag.text}, lambda: {code.text}, {low}, {high})"
    else:
        if isinstance(operand, StandardCall) and operand.name == "LIMIT_OR_IN":
            parts = [value(procedure, one) for one in operand.arguments]
            limited = ", ".join((flag.text, *(one.text for one in parts)))
            code = all_of(parts, f"_attempt_limit({limited})", more_depth=2)
        else:
            code = value(procedure, operand)
        text = f"_attempt({flag.text}, lambda: {code.text}, {nothing_text(node.type)})"
    return Code(text, low=low, high=high, depth=code.depth + 2, safe=False, pure=False)


def _can_overflow(operand: Unary | Binary | Convert | StandardCall) -> bool:
    """True for whole numbers only, on both sides of what is calculated."""
    match operand:
        case Binary():
            kinds = (operand.type, operand.left.type, operand.right.type)
        case Unary() | Convert():
            kinds = (operand.type, operand.operand.type, operand.type)
        case StandardCall():
            return False
    return all(isinstance(kind, Elementary) and kind.family in _WHOLE for kind in kinds)


def _exact(procedure: Procedure, operand: Unary | Binary | Convert | StandardCall) -> Code:
    """The result before it is wrapped around."""
    if isinstance(operand, Convert):
        return value(procedure, operand.operand)
    if isinstance(operand, Unary) and operand.operator == "-":
        code = value(procedure, operand.operand)
        return code._replace(text=f"-({code.text})", depth=code.depth + 1)
    if isinstance(operand, Binary) and operand.operator in ("+", "-", "*"):
        left, right = value(procedure, operand.left), value(procedure, operand.right)
        text = f"({left.text}) {operand.operator} ({right.text})"
        return left._replace(text=text, depth=max(left.depth, right.depth) + 1)
    # A quotient is not wrapped around yet, anything else fits.
    return expression(procedure, operand)


def nothing_text(kind: Type) -> str:
    """The Python text of zero, FALSE or the empty text."""
    if not isinstance(kind, Elementary):
        return "''"
    if kind.family is Family.BOOL:
        return "False"
    if kind.family is Family.REAL:
        return "0.0"
    return r"'\0'" if kind.family is Family.CHAR else "0"


EXPRESSIONS: dict[type, Write] = {Attempt: _attempt}
"""Which function of this module writes which node."""
