"""Calls of standard functions and conversions: settles which types they work with.

Sources as for `standard_functions` and `conversions`.
"""

import re
from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.checked import Binary, Constant, Convert, Expression, StandardCall
from fbgen.lang.checker.arguments import bind
from fbgen.lang.checker.array_bounds import BOUNDS, check_bound
from fbgen.lang.checker.coercion import (
    as_counted,
    as_typed,
    coerce,
    converted,
    spelled,
    without_limits,
)
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.conversions import (
    common_type,
    elementary_named,
    is_convertible,
    is_implicit,
)
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.folding import fold_conversion
from fbgen.lang.checker.literals import ERRONEOUS, erroneous, fitted, is_untyped, settled_bits
from fbgen.lang.checker.operators import apply_unary, combine
from fbgen.lang.checker.references import IS_VALID, MAKERS, check_is_valid, check_maker
from fbgen.lang.checker.stamps import as_stamp, in_parts
from fbgen.lang.checker.standard_functions import (
    ALIASES,
    CHAINED,
    COMMON,
    DATE_FUNCTIONS,
    FAMILIES,
    OPERATORS_BY_NAME,
    ROUNDED_UP_OR_DOWN,
    STANDARD_FUNCTIONS,
    TEXT_CONVERSIONS,
    WHOLE_NUMBER,
    WITH_TEXT,
    Common,
    Function,
    ParameterType,
    Slot,
)
from fbgen.lang.types import (
    BOOL,
    DINT,
    DTL,
    LREAL,
    LTIME,
    REAL,
    TIME,
    Elementary,
    Enumeration,
    Family,
    StringType,
    Subrange,
    Type,
)
from fbgen.source import Span

_ROUNDED = re.compile(r"(?:(REAL|LREAL)_)?(ROUND|TRUNC|CEIL|FLOOR)(?:_([A-Z]+))?\Z")
_LONGEST_TEXT = StringType()


def is_standard_function(name: str) -> bool:
    """True for every name that `check_standard_call` knows."""
    key = _canonical(name)
    return (
        key in STANDARD_FUNCTIONS
        or key in DATE_FUNCTIONS
        or key in OPERATORS_BY_NAME
        or key in ("MOVE", "NOT", "NEG")
        or key in BOUNDS
        or key in MAKERS
        or key == IS_VALID
        or _ROUNDED.match(key) is not None
        or _conversion_types(key) is not None
    )


def _canonical(name: str) -> str:
    key = name.upper()
    return ALIASES.get(key, key)


def check_standard_call(
    ctx: Context, node: ast.Call, name: str, expected: Type | None
) -> Expression:
    """The call of a standard function, with its arguments converted and complete."""
    key = _canonical(name)
    function = STANDARD_FUNCTIONS.get(key) or DATE_FUNCTIONS.get(key)
    if function is not None:
        return _call_function(ctx, node, function, expected)
    if key in OPERATORS_BY_NAME:
        return _operator(ctx, node, key, expected)
    if key in MAKERS:
        return check_maker(ctx, node, key)
    if key == IS_VALID:
        return check_is_valid(ctx, node)
    if key in BOUNDS:
        return check_bound(ctx, node, key)
    if key in ("MOVE", "NOT", "NEG"):
        return _one_operand(ctx, node, key, expected)
    if rounded := _ROUNDED.match(key):
        return _rounded(ctx, node, key, rounded, expected)
    types = _conversion_types(key)
    assert types is not None
    return _conversion(ctx, node, key, *types)


def _arguments(
    ctx: Context, node: ast.Call, name: str, parameters: Sequence[tuple[str, ParameterType]]
) -> list[tuple[ParameterType, ast.Expression]] | None:
    """The written arguments in the order of the parameters; None after reporting errors."""
    numbered = [(parameter, (index, kind)) for index, (parameter, kind) in enumerate(parameters)]
    bound = bind(ctx, node, name, numbered)
    if bound is None:
        return None
    found: dict[int, tuple[ParameterType, ast.Expression]] = {}
    for (index, kind), argument in bound:
        if argument.kind is ast.ArgumentKind.OUTPUT or argument.value is None:
            ctx.findings.error(
                "FB4041",
                f"{name} has no outputs",
                argument.span,
                "give its arguments by := and use its result",
            )
            return None
        found[index] = (kind, argument.value)
    missing = [parameters[index][0] for index in range(len(parameters)) if index not in found]
    if missing:
        ctx.findings.error(
            "FB4040",
            f"{name} needs the argument {', '.join(missing)}",
            node.span,
            f"write {name}({', '.join(parameter for parameter, _ in parameters)})",
        )
        return None
    return [found[index] for index in range(len(parameters))]


def _extended(function: Function, node: ast.Call) -> Sequence[tuple[str, ParameterType]]:
    """The parameters of a function, with as many further ones as the call has."""
    parameters = list(function.parameters)
    if not function.repeats:
        return parameters
    last, kind = parameters[-1]
    number = int(last[2:])
    while len(parameters) < len(node.arguments):
        number += 1
        parameters.append((f"IN{number}", kind))
    return parameters


def _call_function(
    ctx: Context, node: ast.Call, function: Function, expected: Type | None
) -> Expression:
    arguments = _arguments(ctx, node, function.name, _extended(function, node))
    if arguments is None:
        return erroneous(node.span)
    hint = expected if function.result is COMMON else None
    checked = [
        (kind, _operand(ctx, function, check_expression(ctx, value, _hint(kind, hint))))
        for kind, value in arguments
    ]
    if any(expression.type == ERRONEOUS for _, expression in checked):
        return erroneous(node.span)
    common: Type | None = None
    if function.common is not Common.NONE:
        operands = [expression for kind, expression in checked if kind is COMMON]
        common = _common_type(ctx, function, operands, hint)
        if common is None:
            types = ", ".join(dict.fromkeys(spelled(as_typed(one).type) for one in operands))
            ctx.findings.error(
                "FB4012",
                f"{function.name} takes {function.common.value}, not {types}",
                node.span,
                "bring all arguments to one such type with conversion functions",
            )
            return erroneous(node.span)
    where = f"an argument of {function.name}"
    settled = tuple(
        _as_parameter(ctx, expression, common if kind is COMMON else kind, where)
        for kind, expression in checked
    )
    if any(expression.type == ERRONEOUS for expression in settled):
        return erroneous(node.span)
    result = common if function.result is COMMON else function.result
    assert isinstance(result, Elementary | StringType)
    return StandardCall(node.span, function.name, settled, result)


def _hint(kind: ParameterType, hint: Type | None) -> Type | None:
    return hint if kind is COMMON else None


def _operand(ctx: Context, function: Function, operand: Expression) -> Expression:
    """SEL and MUX choose among enumerators; other functions work on their numbers, if at all."""
    if function.common is Common.ANY:
        return without_limits(operand)
    return as_counted(ctx, operand)


def _as_parameter(
    ctx: Context, expression: Expression, kind: Type | ParameterType | None, where: str
) -> Expression:
    if kind is WHOLE_NUMBER:
        return _whole_number(ctx, expression, where)
    assert kind is not None
    assert not isinstance(kind, Slot)
    if isinstance(kind, StringType) and isinstance(expression.type, StringType):
        return expression
    return coerce(ctx, expression, kind, where)


def _whole_number(ctx: Context, expression: Expression, where: str) -> Expression:
    expression = as_typed(expression)
    kind = expression.type
    if isinstance(kind, Elementary) and (
        kind.is_integer or (ctx.rules.bit_string_arithmetic and kind.family is Family.BITS)
    ):
        return expression
    ctx.findings.error(
        "FB4010",
        f"{where} is a whole number, not {spelled(kind)}",
        expression.span,
        "use a variable of type INT, or convert it",
    )
    return erroneous(expression.span)


def _common_type(
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
        return text if is_implicit(kind, text, ctx.rules) else None
    if kind.family in FAMILIES[common] and not (common is Common.SWAPPED and kind.bits < 16):
        return kind
    if common is Common.SHIFTED and kind.is_integer and ctx.rules.shifts_integers:
        return kind
    if common is Common.FLOATING:
        return next((real for real in (REAL, LREAL) if is_implicit(kind, real, ctx.rules)), None)
    return None


# --- operators as functions -------------------------------------------------------------------


def _operator(ctx: Context, node: ast.Call, key: str, expected: Type | None) -> Expression:
    count = max(2, len(node.arguments)) if key in CHAINED else 2
    parameters: list[tuple[str, ParameterType]] = [
        (f"IN{number}", COMMON) for number in range(1, count + 1)
    ]
    arguments = _arguments(ctx, node, key, parameters)
    if arguments is None:
        return erroneous(node.span)
    operands = [check_expression(ctx, value, expected) for _, value in arguments]
    result = operands[0]
    for operand in operands[1:]:
        result = combine(ctx, node.span, OPERATORS_BY_NAME[key], result, operand)
    if key == "T_DIFF" and result.type == LTIME and expected == TIME:
        return Convert(node.span, result, TIME)
    return result


def _one_operand(ctx: Context, node: ast.Call, key: str, expected: Type | None) -> Expression:
    arguments = _arguments(ctx, node, key, (("IN", COMMON),))
    if arguments is None:
        return erroneous(node.span)
    operand = check_expression(ctx, arguments[0][1], expected)
    if key == "MOVE" or operand.type == ERRONEOUS:
        return operand
    result = apply_unary(node.span, "NOT" if key == "NOT" else "-", operand)
    if result is None:
        ctx.findings.error(
            "FB4012",
            f"{key} does not work on {spelled(as_typed(operand).type)}",
            node.span,
            "NOT takes BOOLs and bit strings, NEG signed numbers",
        )
        return erroneous(node.span)
    return result


# --- conversions ------------------------------------------------------------------------------


def _conversion_types(key: str) -> tuple[Type | None, Type] | None:
    """What `X_TO_Y` or `TO_Y` converts; None if it is no conversion."""
    source_name, middle, target_name = key.rpartition("_TO_")
    if not middle:
        if not key.startswith("TO_"):
            return None
        target = elementary_named(key[3:])
        return None if target is None else (None, target)
    source, target = elementary_named(source_name), elementary_named(target_name)
    if source is None or target is None:
        return None
    if is_convertible(source, target) or key in TEXT_CONVERSIONS:
        return source, target
    return None


def _conversion(
    ctx: Context, node: ast.Call, key: str, source: Type | None, target: Type
) -> Expression:
    arguments = _arguments(ctx, node, key, (("IN", COMMON),))
    if arguments is None:
        return erroneous(node.span)
    operand = check_expression(ctx, arguments[0][1], source)
    if source is not None:
        if not isinstance(source, StringType) or not isinstance(operand.type, StringType):
            operand = coerce(ctx, operand, source, f"the argument of {key}")
    else:
        operand = as_typed(operand)
    if operand.type == ERRONEOUS:
        return erroneous(node.span)
    return _to_type(ctx, node.span, key, operand, target)


def _to_type(
    ctx: Context,
    span: Span,
    key: str,
    operand: Expression,
    target: Type,
    *,
    rounding: str = "nearest",
) -> Expression:
    source = operand.type
    if isinstance(source, Enumeration | Subrange):
        operand = converted(operand, source.base)
        source = source.base
    if source == DTL and target != DTL:
        operand = as_stamp(operand)
        source = operand.type
    parts = in_parts(operand) if target == DTL else None
    if parts is not None:
        return parts
    by_name = f"{_short(source)}_TO_{_short(target)}"
    if by_name in TEXT_CONVERSIONS:
        return StandardCall(span, by_name, (operand,), target)
    if by_name in STANDARD_FUNCTIONS:
        return StandardCall(span, by_name, (operand,), target)
    if not is_convertible(source, target):
        ctx.findings.error(
            "FB4010",
            f"{key} cannot convert {spelled(source)} to {spelled(target)}",
            operand.span,
            "convert in two steps, over a type that both sides know",
        )
        return erroneous(span)
    if source == target:
        return operand
    if target == BOOL and not ctx.rules.lowest_bit_is_bool and _is_integer(source):
        assert isinstance(source, Elementary)
        return Binary(span, "<>", operand, Constant(span, 0, source), BOOL)
    if isinstance(operand, Constant):
        value = fold_conversion(operand, target, rounding)
        if value is not None:
            return Constant(span, value, target)
    return Convert(span, operand, target, rounding=rounding)


def _is_integer(kind: Type) -> bool:
    return isinstance(kind, Elementary) and kind.is_integer


def _short(kind: Type) -> str:
    if isinstance(kind, StringType):
        return "WSTRING" if kind.wide else "STRING"
    return kind.name


def _rounded(
    ctx: Context, node: ast.Call, key: str, match: re.Match[str], expected: Type | None
) -> Expression:
    """ROUND, TRUNC, CEIL and FLOOR, with or without the target's name."""
    source_name, how, target_name = match.groups()
    target: Type | None = DINT
    if target_name:
        target = elementary_named(target_name)
    elif how == "TRUNC" and _is_integer(expected or BOOL):
        target = expected
    if target is None or not _is_integer(target):
        ctx.findings.error(
            "FB4004",
            f"there is no function {key}",
            node.span,
            f"{how} gives a whole number: {how}_INT, {how}_DINT",
        )
        return erroneous(node.span)
    function = Function(
        ROUNDED_UP_OR_DOWN[how].name if how in ROUNDED_UP_OR_DOWN else key,
        (("IN", COMMON),),
        DINT,
        Common.FLOATING,
    )
    call = _call_function(ctx, node, function, elementary_named(source_name or "REAL"))
    if not isinstance(call, StandardCall):
        return call
    if how in ROUNDED_UP_OR_DOWN:
        return _to_type(ctx, node.span, key, call, target)
    rounding = "truncate" if how == "TRUNC" else "nearest"
    return _to_type(ctx, node.span, key, call.arguments[0], target, rounding=rounding)
