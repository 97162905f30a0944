"""Calls of standard functions and conversions: settles which types they work with.

Sources as for `standard_functions` and `conversions`.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from fbgen.lang import ast
from fbgen.lang.checked import Constant, Convert, Expression, StandardCall
from fbgen.lang.checker.calls.arguments import bind
from fbgen.lang.checker.calls.conversion_calls import conversion_types, convert_to_type, is_integer
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.array_bounds import BOUNDS, check_bound
from fbgen.lang.checker.operands.operators import apply_unary, combine
from fbgen.lang.checker.operands.pointers import SIZES, check_size, has_addresses
from fbgen.lang.checker.operands.references import IS_VALID, MAKERS, check_is_valid, check_maker
from fbgen.lang.checker.supplied.date_functions import function_of_dialect
from fbgen.lang.checker.supplied.function_signatures import (
    COMMON,
    EXPECTED,
    FLOATING,
    WHOLE_NUMBER,
    Common,
    Function,
    ParameterType,
    Slot,
)
from fbgen.lang.checker.supplied.standard_functions import (
    ALIASES,
    CHAINED,
    CHAINED_COMPARISONS,
    DATE_FUNCTIONS,
    LIMIT_OR_IN,
    MUX_WITH_ELSE,
    OPERATORS_BY_NAME,
    RENAMED,
    ROUNDED_TO_REAL,
    ROUNDED_UP_OR_DOWN,
    STANDARD_FUNCTIONS,
    TEXT_PARAMETERS,
    UNSIGNED_BCD,
)
from fbgen.lang.checker.types.coercion import as_counted, as_typed, coerce, spelled, without_limits
from fbgen.lang.checker.types.common_types import common_type_of
from fbgen.lang.checker.types.conversions import (
    elementary_named,
)
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous
from fbgen.lang.dates import of_dialect
from fbgen.lang.types import (
    BOOL,
    DATE,
    DINT,
    INT,
    LREAL,
    LTIME,
    LTIME_OF_DAY,
    REAL,
    TIME,
    TIME_OF_DAY,
    Elementary,
    Family,
    StringType,
    Type,
)

_ROUNDED = re.compile(r"(?:(REAL|LREAL)_)?(ROUND|TRUNC|CEIL|FLOOR)(?:_([A-Z]+))?\Z")
_TABLES = (STANDARD_FUNCTIONS, DATE_FUNCTIONS, UNSIGNED_BCD, OPERATORS_BY_NAME, RENAMED)
_OVERLOADED = frozenset(OPERATORS_BY_NAME) | {
    name for name, function in STANDARD_FUNCTIONS.items() if function.result is not EXPECTED
}
_PLAIN_FAMILIES = (Family.BOOL, Family.BITS, Family.SIGNED, Family.UNSIGNED, Family.REAL)


def is_standard_function(name: str) -> bool:
    """True for every name that `check_standard_call` knows."""
    key = _canonical(name)
    return (
        _function_named(key) is not None
        or key in OPERATORS_BY_NAME
        or key in _SPECIAL
        or key in BOUNDS
        or key in MAKERS
        or key == IS_VALID
        or key in SIZES
        or key in RENAMED
        or _ROUNDED.match(key) is not None
        or conversion_types(key) is not None
    )


def _function_named(key: str) -> Function | None:
    function = STANDARD_FUNCTIONS.get(key) or DATE_FUNCTIONS.get(key) or UNSIGNED_BCD.get(key)
    if function is not None:
        return function
    base, _, suffix = key.rpartition("_")
    general = STANDARD_FUNCTIONS.get(base)
    kind = elementary_named(suffix)
    if general is None or general.result is not EXPECTED or kind not in general.results:
        return None
    assert isinstance(kind, Elementary)
    return replace(general, result=kind)


def _canonical(name: str) -> str:
    """`ADD_INT` and `CONCAT_WSTRING` of IEC's second edition are ADD and CONCAT."""
    key = name.upper()
    key = ALIASES.get(key, key)
    key = key.removeprefix("ANY_") if key.startswith("ANY_TO_") else key
    general, _, suffix = key.rpartition("_")
    if general not in _OVERLOADED or any(key in table for table in _TABLES):
        return key
    kind = elementary_named(suffix)
    plain = isinstance(kind, Elementary) and kind.family in _PLAIN_FAMILIES
    return general if plain or isinstance(kind, StringType) else key


CLASSIC_NAMES: dict[str, dict[str, str]] = {"LEN": {"S": "IN"}}
"""Parameters that STEP 7 V5 calls otherwise."""


def check_standard_call(
    ctx: Context, node: ast.Call, name: str, expected: Type | None
) -> Expression:
    """The call of a standard function, with its arguments converted and complete."""
    key = _canonical(name)
    if key in RENAMED:
        key, names = RENAMED[key]
        node = _with_names(node, names)
    if ctx.rules.dialect == "step7":
        node = _with_names(node, CLASSIC_NAMES.get(key, {}))
    function = _function_named(key)
    if function is not None:
        if has_addresses(ctx):
            node = _with_names(node, TEXT_PARAMETERS.get(function.name, {}))
        return _call_function(ctx, node, function, expected)
    if key in CHAINED_COMPARISONS and len(node.arguments) > 2:
        return _call_function(ctx, node, CHAINED_COMPARISONS[key], None)
    if key in OPERATORS_BY_NAME:
        return _operator(ctx, node, key, expected)
    if key in MAKERS:
        return check_maker(ctx, node, key)
    if key == IS_VALID:
        return check_is_valid(ctx, node)
    if key in SIZES:
        return check_size(ctx, node, key)
    if key in BOUNDS:
        return check_bound(ctx, node, key)
    if key in _SPECIAL:
        return _SPECIAL[key](ctx, node, key, expected)
    if key in ROUNDED_TO_REAL:
        return _call_function(ctx, node, ROUNDED_TO_REAL[key], elementary_named(key[-4:]))
    if rounded := _ROUNDED.match(key):
        return _rounded(ctx, node, key, rounded, expected)
    types = conversion_types(key)
    assert types is not None
    return _conversion(ctx, node, key, *types)


def _with_names(node: ast.Call, names: Mapping[str, str]) -> ast.Call:
    """The call with the parameter names of the standard."""
    arguments = tuple(
        replace(argument, name=names.get(argument.name.upper(), argument.name))
        for argument in node.arguments
    )
    return replace(node, arguments=arguments)


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
    has_else = function.name == "MUX" and _has_else(node)
    while len(parameters) < len(node.arguments) - has_else:
        number += 1
        parameters.append((f"IN{number}", kind))
    if has_else:
        parameters.append(("INELSE", kind))
    return parameters


def _has_else(node: ast.Call) -> bool:
    return any(argument.name.upper() == "INELSE" for argument in node.arguments)


def _call_function(
    ctx: Context, node: ast.Call, function: Function, expected: Type | None
) -> Expression:
    function = function_of_dialect(function, ctx.rules.dialect)
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
        common = common_type_of(ctx, function, operands, hint)
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
    name = MUX_WITH_ELSE if function.name == "MUX" and _has_else(node) else function.name
    if name == "LIMIT" and ctx.rules.crossed_limits_pass:
        name = LIMIT_OR_IN
    result = common if function.result is COMMON else function.result
    if result is EXPECTED:
        result = expected if expected in function.results else function.results[0]
        result = common if result is COMMON else result
    assert isinstance(result, Elementary | StringType)
    return StandardCall(node.span, name, settled, result)


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
    if kind is FLOATING:
        return coerce(ctx, expression, LREAL if expression.type == LREAL else REAL, where)
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


def _maximum_length(ctx: Context, node: ast.Call, key: str, expected: Type | None) -> Expression:
    """MAX_LEN: how many characters the variable has room for, which its declaration says."""
    arguments = _arguments(ctx, node, key, (("IN", COMMON),))
    if arguments is None:
        return erroneous(node.span)
    operand = check_expression(ctx, arguments[0][1])
    if isinstance(operand.type, StringType):
        return Constant(node.span, operand.type.length, INT)
    if operand.type != ERRONEOUS:
        ctx.findings.error(
            "FB4012",
            f"{key} takes STRING or WSTRING, not {spelled(as_typed(operand).type)}",
            node.span,
            "give it a text",
        )
    return erroneous(node.span)


def _date_and_time(ctx: Context, node: ast.Call, key: str, expected: Type | None) -> Expression:
    """T_COMBINE: a DATE and a time of day of either width."""
    arguments = _arguments(ctx, node, key, (("IN1", DATE), ("IN2", COMMON)))
    if arguments is None:
        return erroneous(node.span)
    time = as_typed(check_expression(ctx, arguments[1][1], TIME_OF_DAY))
    name = "CONCAT_DATE_LTOD" if time.type == LTIME_OF_DAY else "CONCAT_DATE_TOD"
    return _call_function(ctx, node, STANDARD_FUNCTIONS[name], expected)


def _to_expected(ctx: Context, node: ast.Call, key: str, expected: Type | None) -> Expression:
    """T_CONV and S_CONV: to the type that the place asks for."""
    if isinstance(expected, Elementary | StringType) and expected != ERRONEOUS:
        return _conversion(ctx, node, key, None, expected)
    ctx.findings.error(
        "FB4012",
        f"it does not show which type {key} converts to",
        node.span,
        "assign the result to a variable, or use a conversion with both types in its name",
    )
    return erroneous(node.span)


_SPECIAL: dict[str, Callable[[Context, ast.Call, str, Type | None], Expression]] = {
    "MOVE": _one_operand,
    "NOT": _one_operand,
    "NEG": _one_operand,
    "MAX_LEN": _maximum_length,
    "T_COMBINE": _date_and_time,
    "T_CONV": _to_expected,
    "S_CONV": _to_expected,
}
"""What is neither in a table nor a conversion by its name."""


# --- conversions ------------------------------------------------------------------------------


def _conversion(
    ctx: Context, node: ast.Call, key: str, source: Type | None, target: Type
) -> Expression:
    source, target = of_dialect(source, ctx.rules.dialect), of_dialect(target, ctx.rules.dialect)
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
    return convert_to_type(ctx, node.span, key, operand, target)


def _rounded(
    ctx: Context, node: ast.Call, key: str, match: re.Match[str], expected: Type | None
) -> Expression:
    """ROUND, TRUNC, CEIL and FLOOR, with or without the target's name."""
    source_name, how, target_name = match.groups()
    target: Type | None = DINT
    if target_name:
        target = elementary_named(target_name)
    elif how == "TRUNC" and is_integer(expected or BOOL):
        target = expected
    if target is None or not is_integer(target):
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
        return convert_to_type(ctx, node.span, key, call, target)
    rounding = "truncate" if how == "TRUNC" else "nearest"
    return convert_to_type(ctx, node.span, key, call.arguments[0], target, rounding=rounding)
