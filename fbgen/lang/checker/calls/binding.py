"""The arguments of a call of a block, checked against its variables."""

from collections.abc import Sequence, Set
from dataclasses import replace

from fbgen.lang import ast
from fbgen.lang.checked import (
    IN_OUTS,
    AnyBlock,
    Block,
    Constant,
    Expression,
    Place,
    StandardBlock,
    Variable,
    VariableKind,
)
from fbgen.lang.checker.calls.arguments import Bound, bind
from fbgen.lang.checker.calls.converted_outputs import converted_output, taken_back
from fbgen.lang.checker.calls.enabling import ENABLED
from fbgen.lang.checker.calls.numbered import numbered
from fbgen.lang.checker.calls.unknown_callees import (
    check_arguments_alone,
)
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.checker.operands.pointers import has_addresses
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.supplied.memory_instructions import check_pointer_constant, points
from fbgen.lang.checker.supplied.standard_blocks import parameter_name
from fbgen.lang.checker.types.codesys_types import is_any_value
from fbgen.lang.checker.types.coercion import coerce, spelled
from fbgen.lang.checker.types.conversions import fits_place, is_implicit, is_likely_unchecked
from fbgen.lang.checker.types.literals import ERRONEOUS, default_value
from fbgen.lang.checker.types.same_structure import is_array_as_long
from fbgen.lang.types import (
    NUMBER_TYPES,
    Elementary,
    Enumeration,
    OpenArrayType,
    StringType,
    Type,
    refers_to_anything,
)

_PARAMETERS = (VariableKind.INPUT, VariableKind.OUTPUT, *IN_OUTS)
_ARROW = ast.ArgumentKind.OUTPUT


def with_defaults(
    ctx: Context, node: ast.Call, block: Block, bound: Bound
) -> tuple[tuple[Variable, Expression], ...] | None:
    """All inputs in their order, those that were left out with their initial values."""
    given = dict(bound.inputs)
    inputs = []
    missing = []
    for variable in block.variables:
        if variable.kind is not VariableKind.INPUT:
            continue
        kind = variable.type
        if variable in given:
            inputs.append((variable, given[variable]))
        elif ctx.rules.inputs_complete or not isinstance(kind, Elementary | StringType):
            missing.append(variable.name)
        else:
            value = variable.initial if variable.initial is not None else default_value(kind)
            assert isinstance(value, bool | int | float | str)
            inputs.append((variable, Constant(node.span, value, kind)))
    if not missing:
        return tuple(inputs)
    report_missing(ctx, node, block.name, missing)
    return None


def report_missing(ctx: Context, node: ast.Call, name: str, missing: Sequence[str]) -> None:
    ctx.findings.error(
        "FB4040",
        f"the call of {name} leaves out {', '.join(missing)}",
        node.span,
        f"add {', '.join(f'{parameter} := ...' for parameter in missing)}",
    )


def bind_variables(
    ctx: Context, node: ast.Call, name: str, block: AnyBlock, by_assignment: bool
) -> Bound | None:
    implicit = ctx.library.implicit
    own_eno = next((one for one in block.variables if one in implicit), None) if implicit else None
    parameters = [
        (variable.name, variable)
        for variable in block.variables
        if variable.kind in _PARAMETERS
        and variable is not own_eno
        and variable not in ctx.library.receivers
    ]
    status = None
    if own_eno is not None:
        # It may stand beside arguments without names.
        status = next((one for one in node.arguments if one.name.casefold() == ENABLED), None)
        rest = tuple(one for one in node.arguments if one is not status)
        node = ast.Call(node.span, node.callee, rest)
    if isinstance(block, Block) and ctx.library.objects.is_partial(block):
        node = _without_inherited(ctx, node, {key.casefold() for key, _ in parameters})
    if isinstance(block, StandardBlock) and has_addresses(ctx):
        named = (replace(one, name=parameter_name(name, one.name)) for one in node.arguments)
        node = replace(node, arguments=tuple(named))
    bound = bind(ctx, node, name, parameters)
    if bound is None:
        check_arguments_alone(ctx, node)
        return None
    inputs: list[tuple[Variable, Expression]] = []
    in_outs: list[tuple[Variable, Place]] = []
    outputs: list[tuple[Variable, Place]] = []
    complete = True
    if own_eno is not None and status is not None:
        bound.append((own_eno, status))
    for variable, argument in bound:
        if argument.value is None:
            continue
        where = f"parameter {variable.name} of {name}"
        if _wrong_way(ctx, variable, argument, by_assignment):
            complete = False
        elif variable.kind is VariableKind.INPUT:
            if variable.type in NUMBER_TYPES.values():
                value = numbered(ctx, argument.value, variable.type, where)
            elif refers_to_anything(variable.type) and points(argument.value):
                value = check_pointer_constant(ctx, argument.value, variable.type, where)
            else:
                value = check_expression(ctx, argument.value, variable.type)
            if is_any_value(variable.type) and value.type not in (variable.type, ERRONEOUS):
                value = cannot_run(ctx, argument.span, f"an argument of type {variable.type.name}")
            if not is_array_as_long(ctx, value.type, variable.type):
                value = coerce(ctx, value, variable.type, where)
            inputs.append((variable, value))
        elif variable.kind in IN_OUTS:
            place = check_target(ctx, argument.value, where)
            back = None if place is None else _written_back(ctx, place, variable)
            if place is not None and back is not None:
                inputs.append((variable, coerce(ctx, place, variable.type, where)))
                outputs.append((variable, back))
                continue
            place = _in_out(ctx, argument.value, place, variable, where)
            complete = complete and place is not None
            if place is not None:
                in_outs.append((variable, place))
        else:
            place = _output(ctx, argument.value, variable.type, where)
            complete = complete and place is not None
            if place is not None:
                outputs.append((variable, place))
    given = {variable for variable, _ in bound}
    missing = [
        variable.name
        for variable in block.variables
        if variable.kind is VariableKind.IN_OUT
        and variable not in given
        and variable not in ctx.library.receivers
    ]
    if missing:
        report_missing(ctx, node, name, missing)
        return None
    return Bound(tuple(inputs), tuple(in_outs), tuple(outputs)) if complete else None


def _without_inherited(ctx: Context, node: ast.Call, known: Set[str]) -> ast.Call:
    """The call without arguments for parameters that a base in no file may have."""
    others = [one for one in node.arguments if one.name and one.name.casefold() not in known]
    check_arguments_alone(ctx, replace(node, arguments=tuple(others)))
    rest = tuple(one for one in node.arguments if one not in others)
    return replace(node, arguments=rest)


def _wrong_way(
    ctx: Context, variable: Variable, argument: ast.Argument, by_assignment: bool
) -> bool:
    if argument.kind is ast.ArgumentKind.POSITIONAL:
        return False
    is_output = variable.kind is VariableKind.OUTPUT
    if (argument.kind is _ARROW) == is_output:
        return False
    if is_output and by_assignment and ctx.rules.outputs_by_assignment:
        return False
    right = "=>" if is_output else ":="
    ctx.findings.error(
        "FB4041",
        f"{variable.kind.value} '{variable.name}' is given by {argument.kind.value}",
        argument.span,
        f"write {variable.name} {right} ...",
    )
    return True


def _written_back(ctx: Context, place: Place, variable: Variable) -> Place | None:
    """Where an in-out that is copied goes back to, converted; None if that is not what happens.

    Without the IEC check the types may differ, if the one becomes the other by itself and both are
    as wide (TIA Portal help, "Overview of data type conversion").
    """
    kind, own = variable.type, place.type
    if variable.kind is not VariableKind.KEPT or own == kind:
        return None
    if not isinstance(own, Elementary) or not isinstance(kind, Elementary):
        return None
    if own.bits != kind.bits or not (_becomes(ctx, own, kind) and _becomes(ctx, kind, own)):
        return None
    return taken_back(ctx, place.span, kind, place)


def _becomes(ctx: Context, source: Type, target: Type) -> bool:
    rules = ctx.rules
    if is_implicit(source, target, rules):
        return True
    return rules.iec_check_open and is_likely_unchecked(source, target, rules)


def _in_out(
    ctx: Context, node: ast.Expression, place: Place | None, variable: Variable, where: str
) -> Place | None:
    if place is None:
        return None
    kind = variable.type
    if _is_same_number(ctx, place.type, kind):
        return place
    if place.type != kind and not (isinstance(kind, OpenArrayType) and kind.takes(place.type)):
        ctx.findings.error(
            "FB4010",
            f"{where} works on the variable itself and takes exactly {spelled(variable.type)},"
            f" not {spelled(place.type)}",
            node.span,
            "copy the value to a variable of that type before the call, and back behind it",
        )
        return None
    return place


def _is_same_number(ctx: Context, one: Type, other: Type) -> bool:
    """True for an enumeration and the integer that it is, which share a variable in TwinCAT."""
    if not ctx.rules.enumerations_are_numbers:
        return False
    kinds = (one, other)
    if not any(isinstance(kind, Enumeration) for kind in kinds):
        return False
    plain = [kind.base if isinstance(kind, Enumeration) else kind for kind in kinds]
    return plain[0] == plain[1]


def _output(ctx: Context, node: ast.Expression, source: Type, where: str) -> Place | None:
    place = check_target(ctx, node, where)
    if place is None:
        return None
    if _is_same_number(ctx, source, place.type):
        return place
    if not fits_place(source, place.type, ctx.rules):
        converted_to = converted_output(ctx, node.span, source, place)
        if converted_to is not None:
            return converted_to
        ctx.findings.error(
            "FB4010",
            f"{where} gives {spelled(source)}, which {spelled(place.type)} cannot take",
            node.span,
            "take it into a variable of that type, then convert it",
        )
        return None
    return place
