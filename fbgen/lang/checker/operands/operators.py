"""Operators: which types they take, and what comes out.

Chains such as `a + b + c` are left-deep trees of any length and are walked with a loop.
Sources: IEC 61131-3 third edition, tables 28 to 33 and 71; TIA Portal help, "Expressions".
"""

import math

from fbgen.lang import ast
from fbgen.lang.checked import Binary, Constant, Convert, Expression, StandardCall, Unary
from fbgen.lang.checker.calls.enabling import attempted
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.enumerations import is_strict
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.integer_logic import (
    are_numbers,
    as_bits,
    as_pattern,
    is_bit_pattern,
    type_of_mixed_signs,
)
from fbgen.lang.checker.operands.operator_help import IN_CODESYS, counts_in_codesys, operator_help
from fbgen.lang.checker.operands.pointers import calculated
from fbgen.lang.checker.operands.reference_comparison import compare
from fbgen.lang.checker.operands.unchecked_operands import unchecked_pair
from fbgen.lang.checker.operands.variants import compares_types, type_comparison
from fbgen.lang.checker.supplied.standard_functions import DATE_ARITHMETIC
from fbgen.lang.checker.types import folding
from fbgen.lang.checker.types.coercion import (
    as_counted,
    as_typed,
    converted,
    spelled,
    without_limits,
)
from fbgen.lang.checker.types.conversions import UNSIGNED_OF, common_type, wider_types
from fbgen.lang.checker.types.literals import (
    ERRONEOUS,
    UNTYPED_INTEGER,
    UNTYPED_MASK,
    UNTYPED_REAL,
    erroneous,
    fitted,
    holds_untyped,
    is_untyped,
)
from fbgen.lang.checker.types.stamps import as_stamp, is_stamp
from fbgen.lang.types import (
    BOOL,
    DTL,
    LDT,
    LREAL,
    LTIME,
    REAL,
    TIME,
    Elementary,
    Enumeration,
    Family,
    ReferenceType,
    StringType,
    Type,
)
from fbgen.source import Span

_BITS = (Family.BITS, Family.BOOL)
_NUMBERS = (Family.SIGNED, Family.UNSIGNED, Family.REAL)
_COUNTS = (Family.SIGNED, Family.UNSIGNED, Family.BITS)
_BITS_OF = {number: bits for bits, number in UNSIGNED_OF.items()}


def check_binary(ctx: Context, node: ast.Binary, expected: Type | None) -> Expression:
    """Operands and operators from left to right."""
    spine: list[ast.Binary] = []
    leftmost: ast.Expression = node
    compares = False
    if compares_types(ctx, node):
        return type_comparison(ctx, node)
    while isinstance(leftmost, ast.Binary) and not compares_types(ctx, leftmost):
        spine.append(leftmost)
        compares = compares or leftmost.operator in folding.COMPARISONS
        leftmost = leftmost.left
    hint = None if compares else expected
    result = check_expression(ctx, leftmost, hint)
    for binary in reversed(spine):
        asked = result.type if isinstance(result.type, Enumeration) else hint
        right = check_expression(ctx, binary.right, asked)
        result = combine(ctx, binary.span, binary.operator, result, right)
    return result


def combine(
    ctx: Context, span: Span, operator: str, left: Expression, right: Expression
) -> Expression:
    """Two checked operands and an operator; reports what does not go together."""
    if ERRONEOUS in (left.type, right.type):
        return erroneous(span)
    if isinstance(left.type, ReferenceType) or isinstance(right.type, ReferenceType):
        same = compare(ctx, span, operator, left, right) or calculated(ctx, left, right)
        if same is None:
            _refuse(ctx, span, operator, left, right)
        return erroneous(span) if same is None else same
    if DTL in (left.type, right.type):
        return _with_stamps(ctx, span, operator, left, right)
    if is_strict(left.type, operator) or is_strict(right.type, operator):
        _refuse(ctx, span, operator, left, right)
        return erroneous(span)
    if left.type != right.type or operator not in ("=", "<>"):
        left, right = as_counted(ctx, left), as_counted(ctx, right)
    else:
        left, right = without_limits(left), without_limits(right)
    if isinstance(left.type, Enumeration) and operator not in ("=", "<>"):
        _refuse(ctx, span, operator, left, right)
        return erroneous(span)
    if operator in folding.LOGIC:
        result = _logic(ctx, span, operator, left, right)
    elif operator in folding.COMPARISONS:
        result = _comparison(ctx, span, operator, left, right)
    else:
        result = _arithmetic(ctx, span, operator, left, right)
        if result is not None and ctx.overflow_flag is not None:
            result = attempted(ctx, result)
    if result is None:
        _refuse(ctx, span, operator, left, right)
        return erroneous(span)
    return result


def _with_stamps(
    ctx: Context, span: Span, operator: str, left: Expression, right: Expression
) -> Expression:
    """DTL as the instant that it is; the sum of one and a duration is a DTL again."""
    if operator in folding.COMPARISONS and not (is_stamp(left.type) and is_stamp(right.type)):
        _refuse(ctx, span, operator, left, right)
        return erroneous(span)
    result = combine(ctx, span, operator, as_stamp(left), as_stamp(right))
    return Convert(span, result, DTL, implicit=True) if result.type == LDT else result


def _refuse(ctx: Context, span: Span, operator: str, left: Expression, right: Expression) -> None:
    one, two = as_typed(left).type, as_typed(right).type
    both_typed = not is_untyped(left.type) and not is_untyped(right.type)
    types = spelled(one) if one == two else f"{spelled(one)} and {spelled(two)}"
    help_text = operator_help(operator, one, two, both_typed)
    if ctx.rules.dialect == "iec" and counts_in_codesys(one) and counts_in_codesys(two):
        help_text += f"; {IN_CODESYS}"
    message = f"{operator} does not work on {types}"
    ctx.findings.error("FB4012", message, span, help_text)


def unify(
    ctx: Context, left: Expression, right: Expression
) -> tuple[Expression, Expression] | None:
    """Both operands in one type; None if they have none in common. Two untyped stay untyped."""
    return _unify(ctx, left, right) or unchecked_pair(ctx, left, right)


def _unify(
    ctx: Context, left: Expression, right: Expression
) -> tuple[Expression, Expression] | None:
    if left.type == right.type:
        return left, right
    if _is_untyped_constant(left) and _is_untyped_constant(right):
        assert isinstance(left, Constant)
        assert isinstance(right, Constant)
        return _unify_untyped(left, right)
    if isinstance(left, Constant) and _adapts(left):
        return _adapt(ctx, left, right)
    if isinstance(right, Constant) and _adapts(right):
        adapted = _adapt(ctx, right, left)
        return None if adapted is None else (adapted[1], adapted[0])
    kind = common_type(left.type, right.type, ctx.rules)
    if kind is None:
        return None
    if isinstance(kind, StringType):
        return left, right
    return converted(left, kind), converted(right, kind)


def _is_untyped_constant(expression: Expression) -> bool:
    return isinstance(expression, Constant) and is_untyped(expression.type)


def _adapts(constant: Constant) -> bool:
    return is_untyped(constant.type) or isinstance(constant.type, StringType)


def _unify_untyped(left: Constant, right: Constant) -> tuple[Expression, Expression]:
    kinds = (left.type, right.type)
    if UNTYPED_REAL in kinds:
        return (
            Constant(left.span, float(left.value), UNTYPED_REAL),
            Constant(right.span, float(right.value), UNTYPED_REAL),
        )
    return (
        Constant(left.span, left.value, UNTYPED_MASK),
        Constant(right.span, right.value, UNTYPED_MASK),
    )


def _adapt(
    ctx: Context, constant: Constant, other: Expression
) -> tuple[Expression, Expression] | None:
    """The constant in the other's type, or both in a wider one; the constant first."""
    target = other.type
    value = fitted(constant, target)
    if value is not None:
        return Constant(constant.span, value, target), other
    if isinstance(constant.type, StringType) and isinstance(target, StringType):
        if constant.type.wide == target.wide or not target.wide:
            return constant, other
        return Constant(constant.span, constant.value, target), other
    if not isinstance(target, Elementary):
        return None
    for wider in wider_types(target, ctx.rules):
        value = fitted(constant, wider)
        if value is not None:
            return Constant(constant.span, value, wider), converted(other, wider)
    return None


# --- logic ------------------------------------------------------------------------------------


def _logic(
    ctx: Context, span: Span, operator: str, left: Expression, right: Expression
) -> Expression | None:
    pair = unify(ctx, left, right)
    if pair is None or are_numbers(ctx, *pair):
        pair = as_bits(ctx, left, right)
        if pair is None:
            return None
        mixed = type_of_mixed_signs(ctx, left.type, right.type)
        whole = mixed or common_type(left.type, right.type, ctx.rules) or left.type
        bits = _logic(ctx, span, operator, *pair)
        return None if bits is None else converted(bits, whole)
    left, right = pair
    kind = left.type
    if operator in folding.SHORT_CIRCUIT and kind != BOOL:
        return None
    if isinstance(left, Constant) and isinstance(right, Constant) and is_untyped(kind):
        if kind == UNTYPED_REAL:
            return None
        value = folding.LOGIC[operator](int(left.value), int(right.value))
        return Constant(span, value, UNTYPED_MASK if value < 0 else UNTYPED_INTEGER)
    if not isinstance(kind, Elementary) or kind.family not in _BITS:
        return None
    if isinstance(left, Constant) and isinstance(right, Constant):
        return folding.fold_logic(span, operator, left, right)
    return Binary(span, operator, left, right, kind)


# --- comparisons ------------------------------------------------------------------------------


def _comparison(
    ctx: Context, span: Span, operator: str, left: Expression, right: Expression
) -> Expression | None:
    pair = unify(ctx, left, right)
    if pair is None and ctx.rules.bit_string_arithmetic:
        pair = unify(ctx, _as_number(left), _as_number(right))
    if pair is None:
        return None
    left, right = pair
    kind = left.type
    if isinstance(kind, Elementary):
        if kind.family is Family.VOID:
            return None
        if kind == BOOL and operator not in ("=", "<>"):
            return None
    elif not isinstance(kind, StringType):
        return None
    if isinstance(left, Constant) and isinstance(right, Constant):
        return folding.fold_comparison(span, operator, left, right)
    return Binary(span, operator, left, right, BOOL)


# --- arithmetic -------------------------------------------------------------------------------


def _as_number(operand: Expression) -> Expression:
    """A bit string as the unsigned integer it acts as; anything else as it is."""
    kind = operand.type
    if not isinstance(kind, Elementary) or kind not in UNSIGNED_OF:
        return operand
    number = UNSIGNED_OF[kind]
    if isinstance(operand, Convert) and operand.implicit and operand.operand.type == number:
        return operand.operand
    return converted(operand, number)


def _arithmetic(
    ctx: Context, span: Span, operator: str, left: Expression, right: Expression
) -> Expression | None:
    symbol = "/" if operator == "DIV" else operator
    special = _with_times(ctx, span, symbol, left, right)
    if special is not None:
        return special
    bits = _bit_string_result(left, right)
    if bits is not None or Family.BITS in (_family(left), _family(right)):
        if not ctx.rules.bit_string_arithmetic:
            return None
        left, right = _as_number(left), _as_number(right)
    mixed = type_of_mixed_signs(ctx, left.type, right.type)
    if mixed is not None:
        left, right = converted(left, mixed), converted(right, mixed)
    result = _numbers(ctx, span, operator, left, right)
    if result is None or bits is None or result.type == ERRONEOUS:
        return result
    assert isinstance(result.type, Elementary)
    bits = _BITS_OF.get(result.type)
    return result if bits is None else converted(result, bits)


def _family(expression: Expression) -> Family | None:
    return expression.type.family if isinstance(expression.type, Elementary) else None


def _bit_string_result(left: Expression, right: Expression) -> Elementary | None:
    """The wider bit string if bit strings, or one and an integer constant, are calculated with."""
    widest: Elementary | None = None
    for kind in (left.type, right.type):
        if kind == UNTYPED_INTEGER:
            continue
        if not isinstance(kind, Elementary) or kind.family is not Family.BITS:
            return None
        if widest is None or kind.bits > widest.bits:
            widest = kind
    return widest


def _numbers(
    ctx: Context, span: Span, operator: str, left: Expression, right: Expression
) -> Expression | None:
    symbol = "/" if operator == "DIV" else operator
    if symbol == "**":
        return _power(ctx, span, left, right)
    pair = unify(ctx, left, right)
    if pair is None:
        return None
    left, right = pair
    kind = left.type
    if not isinstance(kind, Elementary) or kind.family not in (*_NUMBERS, Family.DURATION):
        return None
    if kind.family is Family.DURATION and symbol not in ("+", "-"):
        return None
    if kind.family is Family.REAL and operator in ("MOD", "DIV"):
        return None
    if symbol in ("/", "MOD") and _is_zero(ctx, span, right):
        return erroneous(span)
    if isinstance(left, Constant) and isinstance(right, Constant):
        if is_untyped(kind):
            return _fold_untyped(ctx, span, symbol, left, right)
        folded = folding.fold_arithmetic(span, symbol, left, right, kind)
        if folded is not None:
            return folded
    return Binary(span, symbol, left, right, kind)


def _is_zero(ctx: Context, span: Span, divisor: Expression) -> bool:
    if not isinstance(divisor, Constant) or divisor.value != 0:
        return False
    ctx.findings.error(
        "FB4016", "division by zero", span, "the divisor is always 0: use another value"
    )
    return True


def _fold_untyped(
    ctx: Context, span: Span, symbol: str, left: Constant, right: Constant
) -> Expression:
    if left.type == UNTYPED_REAL:
        real = folding.real_result(symbol, float(left.value), float(right.value))
        if real is not None and math.isfinite(real):
            return Constant(span, real, UNTYPED_REAL)
    else:
        whole = folding.integer_result(symbol, int(left.value), int(right.value))
        if whole is not None and holds_untyped(whole):
            return Constant(span, whole, UNTYPED_INTEGER)
    ctx.findings.error(
        "FB4014",
        "the result of this constant calculation fits no type",
        span,
        "use smaller numbers, or calculate with REAL",
    )
    return erroneous(span)


def _power(ctx: Context, span: Span, left: Expression, right: Expression) -> Expression | None:
    """`**`: the type of the base; an exponent of type REAL makes an integer base REAL too."""
    if left.type == right.type == UNTYPED_INTEGER:
        assert isinstance(left, Constant)
        assert isinstance(right, Constant)
        if int(right.value) >= 0:
            return _fold_untyped(ctx, span, "**", left, right)
    left, right = as_typed(left), as_typed(right)
    base, exponent = left.type, right.type
    if not isinstance(base, Elementary) or not isinstance(exponent, Elementary):
        return None
    if base.family not in _NUMBERS or exponent.family not in _NUMBERS:
        return None
    if base.is_integer and exponent.family is Family.REAL:
        target = common_type(base, exponent, ctx.rules)
        if target is None:
            return None
        left, base = converted(left, target), LREAL if target == LREAL else REAL
    return Binary(span, "**", left, right, base)


def _with_times(
    ctx: Context, span: Span, symbol: str, left: Expression, right: Expression
) -> Expression | None:
    """Durations times and by numbers, and dates with durations; None for anything else."""
    one, two = _family(left), _family(right)
    if symbol in ("*", "/") and one is Family.DURATION and two in _NUMBERS:
        if symbol == "/" and _is_zero(ctx, span, right):
            return erroneous(span)
        assert isinstance(left.type, Elementary)
        return Binary(span, symbol, left, as_typed(right), left.type)
    if symbol == "*" and two is Family.DURATION and one in _NUMBERS:
        assert isinstance(right.type, Elementary)
        return Binary(span, symbol, right, as_typed(left), right.type)
    if one is Family.DATE and isinstance(left.type, Elementary):
        if not isinstance(right.type, Elementary):
            return None
        entry = DATE_ARITHMETIC.get((symbol, left.type, right.type))
        if entry is None and right.type == TIME:
            entry = DATE_ARITHMETIC.get((symbol, left.type, LTIME))
            right = converted(right, LTIME)
        if entry is not None:
            return StandardCall(span, entry[0], (left, right), entry[1])
    return None


# --- one operand ------------------------------------------------------------------------------


def check_unary(ctx: Context, node: ast.Unary, expected: Type | None) -> Expression:
    """NOT, - and + in front of an operand."""
    operand = check_expression(ctx, node.operand, expected)
    if operand.type == ERRONEOUS:
        return operand
    result = apply_unary(node.span, node.operator, operand)
    if result is None and node.operator == "NOT" and is_bit_pattern(ctx, operand):
        inverted = apply_unary(node.span, "NOT", as_pattern(operand))
        result = None if inverted is None else converted(inverted, operand.type)
    if isinstance(result, Constant) and result.type == UNTYPED_INTEGER and _too_large(result):
        result = None
    if result is not None:
        return result if node.operator == "NOT" else attempted(ctx, result)
    help_text = (
        "NOT takes BOOLs or bit strings; convert integers: INT_TO_WORD(x)"
        if node.operator == "NOT"
        else "only signed numbers and durations have a sign"
    )
    kind = as_typed(operand).type
    ctx.findings.error(
        "FB4012", f"{node.operator} does not work on {spelled(kind)}", node.span, help_text
    )
    return erroneous(node.span)


def apply_unary(span: Span, operator: str, operand: Expression) -> Expression | None:
    """An operator on one checked operand; None if it does not take the type."""
    operand = without_limits(operand)
    kind = operand.type
    if not isinstance(kind, Elementary) or isinstance(kind, Enumeration):
        return None
    if isinstance(operand, Constant) and is_untyped(kind):
        return _unary_untyped(span, operator, operand)
    if operator == "+":
        return operand if kind.family in (*_NUMBERS, Family.DURATION) else None
    if operator == "NOT":
        if kind.family not in _BITS:
            return None
    elif kind.family not in (Family.SIGNED, Family.REAL, Family.DURATION):
        return None
    if isinstance(operand, Constant):
        folded = folding.fold_unary(span, operator, operand, kind)
        if folded is not None:
            return folded
    return Unary(span, operator, operand, kind)


def _unary_untyped(span: Span, operator: str, operand: Constant) -> Expression | None:
    if operator == "NOT":
        if operand.type == UNTYPED_REAL:
            return None
        value = ~int(operand.value)
        return Constant(span, value, UNTYPED_MASK if value < 0 else UNTYPED_INTEGER)
    if operator == "+":
        return Constant(span, operand.value, operand.type)
    if operand.type == UNTYPED_REAL:
        return Constant(span, -float(operand.value), UNTYPED_REAL)
    return Constant(span, -int(operand.value), UNTYPED_INTEGER)


def _too_large(constant: Constant) -> bool:
    return not holds_untyped(int(constant.value))
