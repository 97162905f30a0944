"""Operators: arithmetic in the width of its type, logic, comparisons.

Chains of operands are walked with a loop. Longer ones than `LONGEST_CHAIN` are calculated by a
function of their own, statement by statement.
"""

from fbgen.lang.checked import Binary, Constant, Convert, Expression, Unary
from fbgen.lang.types import BOOL, REAL, Elementary, Family, Type
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.evaluation import Write, expression, named, value
from harness.engine.compiled.expressions.conversions import convert
from harness.engine.compiled.expressions.decisions import write_decision
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import WIDEST, is_counted, limits, wrapped

LONGEST_CHAIN = 40

_COMPARISONS = {"=": "==", "<>": "!=", "<": "<", ">": ">", "<=": "<=", ">=": ">="}
_BITWISE = {
    "AND": ("&", Level.BIT_AND),
    "OR": ("|", Level.BIT_OR),
    "XOR": ("^", Level.BIT_XOR),
}
_SHORT_CIRCUIT = {"AND_THEN": ("and", Level.AND), "OR_ELSE": ("or", Level.OR)}


def _chain(procedure: Procedure, node: Binary | Convert) -> Code:
    if names := procedure.decisions(node):
        return write_decision(procedure, node, names)
    links: list[Binary | Convert] = []
    first: Expression = node
    while isinstance(first, Binary | Convert):
        links.append(first)
        first = first.left if isinstance(first, Binary) else first.operand
    if len(links) <= LONGEST_CHAIN:
        code = expression(procedure, first)
        for link in reversed(links):
            code = _link(procedure, link, code)
        return code
    part = procedure.start_part("value")
    code = expression(part, first)
    for number, link in enumerate(reversed(links), 1):
        code = _link(part, link, code)
        if number % LONGEST_CHAIN == 0 and number < len(links):
            part.line(f"value = {code.text}")
            part.forget_sites()
            code = code._replace(text="value", level=Level.ATOM, depth=1, safe=True, simple=True)
    part.line(f"return {code.text}")
    safe = pure = False
    return code._replace(
        text=procedure.finish_part(part),
        level=Level.ATOM,
        depth=1,
        safe=safe,
        pure=pure,
        simple=False,
    )


def _link(procedure: Procedure, node: Binary | Convert, operand: Code) -> Code:
    if isinstance(node, Convert):
        return convert(procedure, node, operand)
    return _binary(procedure, node, operand)


def _settled(procedure: Procedure, code: Code, kind: Type) -> Code:
    if is_counted(kind):
        assert isinstance(kind, Elementary)
        return wrapped(code, kind, procedure.temporary)
    return code


def _binary(procedure: Procedure, node: Binary, left: Code) -> Code:
    operator = node.operator
    operand_type = node.left.type
    if operator in _COMPARISONS:
        left = _settled(procedure, left, operand_type)
        return _comparison(operator, left, value(procedure, node.right), operand_type)
    if operator in _SHORT_CIRCUIT:
        sign, level = _SHORT_CIRCUIT[operator]
        return _joined(left, sign, value(procedure, node.right), level)
    if operator in _BITWISE:
        left = _settled(procedure, left, operand_type)
        right = value(procedure, node.right)
        if operand_type == BOOL:
            return _boolean(operator, left, right)
        return _bitwise(operator, left, right, operand_type)
    assert isinstance(node.type, Elementary)
    if node.type.family is Family.REAL:
        return _floating(procedure, node, left)
    if isinstance(node.right.type, Elementary) and node.right.type.family is Family.REAL:
        return _duration_by_real(procedure, node, _settled(procedure, left, operand_type))
    if operator in ("+", "-", "*"):
        same = node.right.type == node.type
        # An unfinished value is right in the low bits of its own type only.
        right = (expression if same else value)(procedure, node.right)
        return _ring(procedure, node, left, right)
    left = _settled(procedure, left, operand_type)
    right = value(procedure, node.right)
    if operator == "**":
        return _power(procedure, node, left, right)
    return _division(procedure, node, left, right)


def _joined(left: Code, sign: str, right: Code, level: Level) -> Code:
    """Two pieces with an operator that groups from the left."""
    right_text = right.at(Level(level + 1))
    return Code(
        f"{left.at(level)} {sign} {right_text}",
        level,
        depth=max(left.depth, right.depth + 1) + 1,
        safe=left.safe and right.safe,
        pure=left.pure and right.pure,
    )


# --- logic and comparisons ----------------------------------------------------------------------


def _comparison(operator: str, left: Code, right: Code, kind: Type) -> Code:
    sign = _COMPARISONS[operator]
    if kind == BOOL:
        sign = "is" if sign == "==" else "is not"
    code = _joined(left, sign, right, Level.COMPARISON)
    if left.level == Level.COMPARISON:
        # Python reads a < b < c as two comparisons.
        return code._replace(text=f"({left.text}) {sign} {right.at(Level.BIT_OR)}")
    return code


def _boolean(operator: str, left: Code, right: Code) -> Code:
    if operator == "XOR":
        return _comparison("<>", left, right, BOOL)
    if right.safe:
        level = Level.AND if operator == "AND" else Level.OR
        return _joined(left, operator.lower(), right, level)
    sign, level = _BITWISE[operator]
    return _joined(left, sign, right, level)


def _bitwise(operator: str, left: Code, right: Code, kind: Type) -> Code:
    sign, level = _BITWISE[operator]
    low, high = limits(kind)
    if operator == "AND" and _lets_all_through(right, left):
        return left
    code = _joined(left, sign, right, level)
    if low >= 0:
        if operator == "AND":
            high = min(left.high, right.high)
        else:
            high = (1 << max(left.high, right.high).bit_length()) - 1
    return code._replace(low=low, high=high)


def _lets_all_through(mask: Code, code: Code) -> bool:
    """True for a constant that has every bit which a value can have."""
    if mask.low != mask.high or mask.low < 0 or code.low < 0:
        return False
    return ~mask.low & (1 << code.high.bit_length()) - 1 == 0


# --- whole numbers ------------------------------------------------------------------------------


def _ring(procedure: Procedure, node: Binary, left: Code, right: Code) -> Code:
    """+, - and *: the low bits of the result need only the low bits of the operands."""
    assert isinstance(node.type, Elementary)
    code = _ring_once(node.operator, left, right)
    if code.low >= -WIDEST and code.high <= WIDEST:
        return code
    if isinstance(node.right.type, Elementary):
        right = wrapped(right, node.right.type, procedure.temporary)
    left = wrapped(left, node.type, procedure.temporary)
    code = _ring_once(node.operator, left, right)
    if code.low >= -WIDEST and code.high <= WIDEST:
        return code
    return wrapped(code, node.type, procedure.temporary)


def _ring_once(operator: str, left: Code, right: Code) -> Code:
    level = Level.PRODUCT if operator == "*" else Level.SUM
    code = _joined(left, operator, right, level)
    if operator == "+":
        ends = (left.low + right.low, left.high + right.high)
    elif operator == "-":
        ends = (left.low - right.high, left.high - right.low)
    else:
        corners = [a * b for a in (left.low, left.high) for b in (right.low, right.high)]
        ends = (min(corners), max(corners))
    return code._replace(low=ends[0], high=ends[1])


def _division(procedure: Procedure, node: Binary, left: Code, right: Code) -> Code:
    """/ and MOD: Python rounds down, PLCs cut; the same where nothing is negative."""
    modulo = node.operator == "MOD"
    sign = "%" if modulo else "//"
    low, high = _division_range(modulo, left, right)
    safe = left.safe and right.safe and not right.low <= 0 <= right.high
    if left.low >= 0 and right.low >= 0:
        code = _joined(left, sign, right, Level.PRODUCT)
        if not safe:
            procedure.site(code.text, node)
        return code._replace(low=low, high=high, safe=safe)
    if right.low == right.high and right.low > 0:
        first, again = named(procedure, left)
        divisor = right.text
        # The condition comes first in Python's order, so the name is given there.
        text = f"{again} {sign} {divisor} if {first} >= 0 else -(-{again} {sign} {divisor})"
        return Code(text, Level.CONDITIONAL, low, high, left.depth + 3, left.safe, left.pure)
    function = "_remainder" if modulo else "_quotient"
    text = f"{function}({left.text}, {right.text})"
    procedure.site(text, node)
    depth = max(left.depth, right.depth) + 1
    return Code(text, Level.ATOM, low, high, depth, safe, left.pure and right.pure)


def _division_range(modulo: bool, left: Code, right: Code) -> tuple[int, int]:
    if modulo:
        largest = max(abs(right.low), abs(right.high)) - 1
        low = max(left.low, -largest) if left.low < 0 else 0
        return low, min(left.high, largest) if left.high > 0 else 0
    if right.low > 0:
        smallest = right.low
        low = left.low if left.low < 0 and smallest == 1 else -(-left.low // smallest)
        low = low if left.low < 0 else 0
        return low, left.high // smallest if left.high > 0 else 0
    largest = max(abs(left.low), abs(left.high))
    if left.low >= 0 and right.low >= 0:
        return 0, largest
    return -largest, largest


def _power(procedure: Procedure, node: Binary, left: Code, right: Code) -> Code:
    assert isinstance(node.type, Elementary)
    bits = node.type.bits
    text = f"_power({left.text}, {right.text}, {bits})"
    procedure.site(text, node)
    depth = max(left.depth, right.depth) + 1
    safe = left.safe and right.safe and right.low >= 0
    return Code(text, Level.ATOM, -1, (1 << bits) - 1, depth, safe, left.pure and right.pure)


def _duration_by_real(procedure: Procedure, node: Binary, left: Code) -> Code:
    right = value(procedure, node.right)
    low, high = limits(node.type)
    function = "_scaled" if node.operator == "*" else "_divided"
    text = f"{function}({left.text}, {right.text}, {low}, {high})"
    procedure.site(text, node)
    depth = max(left.depth, right.depth) + 1
    return Code(text, Level.ATOM, low, high, depth, False, left.pure and right.pure)


# --- floating point -----------------------------------------------------------------------------


def _floating(procedure: Procedure, node: Binary, left: Code) -> Code:
    right = value(procedure, node.right)
    operator = node.operator
    if operator in ("+", "-", "*"):
        code = _joined(left, operator, right, Level.PRODUCT if operator == "*" else Level.SUM)
    elif operator == "/" and isinstance(node.right, Constant) and node.right.value != 0:
        code = _joined(left, operator, right, Level.PRODUCT)
    else:
        function = "_real_quotient" if operator == "/" else "_real_power"
        code = _joined(left, ",", right, Level.CONDITIONAL)
        code = code._replace(text=f"{function}({left.text}, {right.text})", level=Level.ATOM)
    if node.type == REAL:
        return code._replace(text=f"_rounded({code.text})", level=Level.ATOM, depth=code.depth + 1)
    return code


# --- one operand --------------------------------------------------------------------------------


def _unary(procedure: Procedure, node: Unary) -> Code:
    if names := procedure.decisions(node):
        return write_decision(procedure, node, names)
    kind = node.type
    assert isinstance(kind, Elementary)
    if node.operator == "-":
        code = expression(procedure, node.operand)
        text = f"-{code.at(Level.SIGN)}"
        return code._replace(
            text=text,
            level=Level.SIGN,
            low=-code.high,
            high=-code.low,
            depth=code.depth + 1,
            simple=False,
        )
    code = value(procedure, node.operand)
    if kind == BOOL:
        return code._replace(
            text=f"not {code.at(Level.NOT)}", level=Level.NOT, depth=code.depth + 1, simple=False
        )
    if kind.is_signed:
        return code._replace(
            text=f"~{code.at(Level.SIGN)}",
            level=Level.SIGN,
            low=-code.high - 1,
            high=-code.low - 1,
            depth=code.depth + 1,
            simple=False,
        )
    mask = kind.maximum
    return code._replace(
        text=f"{code.at(Level.BIT_XOR)} ^ {hex(mask)}",
        level=Level.BIT_XOR,
        low=0,
        high=mask,
        depth=code.depth + 1,
        simple=False,
    )


EXPRESSIONS: dict[type, Write] = {Binary: _chain, Convert: _chain, Unary: _unary}
"""Which function of this module writes which node."""
