"""Calls: finds out what is called, and gives each parameter its argument.

Sources: IEC 61131-3 third edition, section 6.6.1.7; TIA Portal help, "Calling blocks (SCL)".
"""

from dataclasses import replace
from typing import TypeAlias

from fbgen.lang import ast, checked
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    Block,
    Dereference,
    Evaluate,
    Expression,
    FunctionCall,
    InstanceCall,
    Place,
    StandardBlock,
    SystemCall,
)
from fbgen.lang.checker.calls.arguments import Bound, bind
from fbgen.lang.checker.calls.binding import bind_variables, report_missing, with_defaults
from fbgen.lang.checker.calls.bit_gathering import BIT_MOVES
from fbgen.lang.checker.calls.enabling import attempted
from fbgen.lang.checker.calls.members import Receiver, called_member, made_call
from fbgen.lang.checker.calls.routine_calls import (
    is_routine,
    unmodelled_instance_call,
    value_of_routine,
)
from fbgen.lang.checker.calls.standard_calls import check_standard_call, is_standard_function
from fbgen.lang.checker.calls.timer_control import TIMER_CONTROLS
from fbgen.lang.checker.calls.unknown_callees import (
    check_arguments_alone,
    unknown_callee,
    without_instance,
)
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.objects import Method
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.memory_access import check_peek, check_whole, memory_access_named
from fbgen.lang.checker.operands.name_lookup import names_block, without_library
from fbgen.lang.checker.operands.places import is_place
from fbgen.lang.checker.operands.variants import (
    is_variant_function,
    is_variant_name,
    variant_function,
)
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.supplied.memory_instructions import (
    check_area_literal,
    check_memory_instruction,
    points,
)
from fbgen.lang.checker.supplied.routines import is_modelled
from fbgen.lang.checker.supplied.standard_blocks import (
    ANY_TIMERS,
    COUNTER_METHODS,
    TIMER_METHODS,
    standard_block,
    timer_called,
)
from fbgen.lang.checker.supplied.system_instructions import (
    RETURN_VALUE,
    Instruction,
    InstructionParameter,
    instruction_named,
)
from fbgen.lang.checker.types.coercion import coerce, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous
from fbgen.lang.types import (
    ANY_VALUE,
    POINTER_VALUE,
    VARIANT_VALUE,
    VOID,
    AnyType,
    BlockType,
    Elementary,
    ReferenceType,
    Type,
    refers_to_anything,
)

_ARROW = ast.ArgumentKind.OUTPUT


CallResult: TypeAlias = FunctionCall | SystemCall


def check_call(ctx: Context, node: ast.Call, expected: Type | None) -> Expression:
    """A call whose value is used."""
    node = replace(node, callee=without_library(ctx, node.callee))
    member = called_member(ctx, node)
    if member is not None:
        return _value_of_member(ctx, node, *member)
    name = _called_name(ctx, node)
    if name is None:
        return _not_a_value(ctx, node)
    block = _user_block(ctx, node.callee, name)
    if block is not None:
        return _value_of_block(ctx, node, block)
    if is_variant_function(ctx, name):
        return variant_function(ctx, node, name)
    access = memory_access_named(name)
    if access is not None:
        return check_peek(ctx, node, access)
    instruction = instruction_named(name)
    if instruction is not None:
        return system_call(ctx, node, instruction)[0]
    if is_standard_function(name):
        return attempted(ctx, check_standard_call(ctx, node, name, expected))
    if is_routine(ctx, name):
        return value_of_routine(ctx, node, name, expected)
    unknown_callee(ctx, node, name)
    return erroneous(node.span)


def _value_of_member(
    ctx: Context, node: ast.Call, receiver: Receiver, member: Method | Block
) -> Expression:
    if isinstance(member, Method):
        call = method_call(ctx, node, receiver, member)
        if call is None:
            return erroneous(node.span)
        if call.type != VOID:
            return call
    ctx.findings.error(
        "FB4048",
        f"{member.name} has no result",
        node.span,
        "call it in a statement of its own",
    )
    return erroneous(node.span)


def method_call(
    ctx: Context, node: ast.Call, receiver: Receiver, method: Method
) -> FunctionCall | None:
    """The call of a method; None after reporting errors."""
    block = method.block
    bound = bind_variables(ctx, node, method.name, block, by_assignment=True)
    inputs = None if bound is None else with_defaults(ctx, node, block, bound)
    if bound is None or inputs is None:
        return None
    return made_call(ctx, node.span, receiver, method, replace(bound, inputs=inputs))


def body_call(
    ctx: Context, node: ast.Call, receiver: Receiver, block: Block
) -> InstanceCall | None:
    """The call of an action, or of the body of the base block; None after reporting errors."""
    if block is ctx.owner:
        ctx.findings.error(
            "FB4051",
            f"recursive call: {block.name} -> {block.name}",
            node.span,
            "call a method or an action",
        )
        return None
    ctx.calls.setdefault(block, node.span)
    bound = Bound()
    if node.arguments:
        given = bind_variables(ctx, node, block.name, block, by_assignment=False)
        if given is None:
            return None
        bound = given
    return InstanceCall(
        node.span, receiver.place, block, bound.inputs, bound.in_outs, bound.outputs
    )


def _called_name(ctx: Context, node: ast.Call) -> str | None:
    """The name of the function that is called; None for instances and what is no name."""
    callee = node.callee
    return callee.name if isinstance(callee, ast.Name) and names_block(ctx, callee) else None


def _user_block(ctx: Context, callee: ast.Expression, name: str) -> Block | None:
    block = ctx.library.user_block(name)
    quoted = isinstance(callee, ast.Name) and callee.quoted
    if block is not None and ctx.rules.quoted_blocks and not quoted and is_built_in(name):
        return None
    return block


def is_built_in(name: str) -> bool:
    """True for the names of the controller's own functions and instructions."""
    return (
        is_standard_function(name)
        or instruction_named(name) is not None
        or memory_access_named(name) is not None
        or is_modelled(name)
        or is_variant_name(name)
        or name.upper() in (*TIMER_CONTROLS, *BIT_MOVES)
    )


def _not_a_value(ctx: Context, node: ast.Call) -> Expression:
    callee = check_expression(ctx, node.callee)
    if callee.type == ERRONEOUS:
        check_arguments_alone(ctx, node)
        return callee
    if isinstance(callee.type, BlockType):
        ctx.findings.error(
            "FB4045",
            f"the call of {spelled(callee.type)} has no value",
            node.span,
            "call it in a statement of its own, then read its outputs: inst.out",
        )
    else:
        _not_callable(ctx, node, callee)
    return erroneous(node.span)


def _not_callable(ctx: Context, node: ast.Call, callee: Expression) -> None:
    ctx.findings.error(
        "FB4047",
        f"'{node.callee.span.text}' is {spelled(callee.type)} and cannot be called",
        node.span,
        "call a function, or an instance of a function block",
    )


def _value_of_block(ctx: Context, node: ast.Call, block: Block) -> Expression:
    if block.kind is BlockKind.FUNCTION_BLOCK:
        without_instance(ctx, node, block.name)
        return erroneous(node.span)
    call = function_call(ctx, node, block)
    if call is None:
        return erroneous(node.span)
    if call.type == VOID:
        ctx.findings.error(
            "FB4048",
            f"{block.name} has no result",
            node.span,
            "call it in a statement of its own and take its outputs by =>",
        )
        return erroneous(node.span)
    return call


# --- functions of the user --------------------------------------------------------------------


def function_call(ctx: Context, node: ast.Call, block: Block) -> FunctionCall | None:
    """The call of a FUNCTION; None after reporting errors."""
    if block.kind is not BlockKind.FUNCTION:
        ctx.findings.error(
            "FB4047",
            f"{block.name} is a {block.kind.value} and is called by the controller only",
            node.span,
            "move the code into a FUNCTION or FUNCTION_BLOCK and call that",
        )
        return None
    ctx.calls.setdefault(block, node.span)
    bound = bind_variables(ctx, node, block.name, block, by_assignment=True)
    if bound is None:
        return None
    inputs = with_defaults(ctx, node, block, bound)
    if inputs is None:
        return None
    kind = block.result.type if block.result is not None else VOID
    return FunctionCall(node.span, block, inputs, bound.in_outs, bound.outputs, kind)


# --- instances --------------------------------------------------------------------------------


def instance_call(ctx: Context, node: ast.Call) -> InstanceCall | Evaluate | None:
    """The call of an instance of a function block; None after reporting errors."""
    callee = node.callee
    method = ""
    if ctx.rules.instances_behind_blocks:
        callee = _behind_its_block(ctx, callee)
    if isinstance(callee, ast.Member) and callee.name.upper() in TIMER_METHODS:
        base = check_expression(ctx, callee.base)
        if isinstance(base.type, BlockType) and standard_block(base.type.name):
            method = timer_called(callee.name, base.type.name)
            callee = callee.base
    elif isinstance(callee, ast.Member) and callee.name.upper() in COUNTER_METHODS:
        node = _counter_call(ctx, node, callee)
        callee = node.callee
    place = check_expression(ctx, callee)
    if place.type == ERRONEOUS:
        check_arguments_alone(ctx, node)
        return None
    if not isinstance(place.type, BlockType) or not is_place(place):
        _not_callable(ctx, node, place)
        return None
    block = ctx.library.block(method or place.type.name)
    assert block is not None
    assert isinstance(place, Place)
    if isinstance(block, StandardBlock) and block.name in ANY_TIMERS:
        ctx.findings.error(
            "FB4047",
            f"a timer of type {block.name} is called with its kind",
            node.span,
            f"write {callee.span.text}.TON(IN := ..., PT := ...)",
        )
        return None
    if isinstance(block, StandardBlock) and block.name.casefold() in ctx.library.unmodelled:
        return unmodelled_instance_call(ctx, node, place, block)
    if isinstance(block, Block) and ctx.library.is_class(block):
        ctx.findings.error(
            "FB4047",
            f"{block.name} is a CLASS and has no body that could be called",
            node.span,
            f"call one of its methods: {callee.span.text}.Method()",
        )
        return None
    if isinstance(block, Block):
        ctx.calls.setdefault(block, node.span)
    bound = bind_variables(ctx, node, block.name, block, by_assignment=False)
    if bound is None:
        return None
    return InstanceCall(node.span, place, block, bound.inputs, bound.in_outs, bound.outputs)


def _behind_its_block(ctx: Context, callee: ast.Expression) -> ast.Expression:
    """The data block of `FB10.DB20`; anything else comes back. Reports one of another block."""
    if not isinstance(callee, ast.Member) or not isinstance(callee.base, ast.Name):
        return callee
    block = ctx.library.block(callee.base.name) if names_block(ctx, callee.base) else None
    if block is None:
        return callee
    data_block = ast.Name(callee.span, callee.name, callee.quoted)
    kind = check_expression(ctx, data_block).type
    if isinstance(kind, BlockType) and ctx.library.block(kind.name) is not block:
        ctx.findings.error(
            "FB4047",
            f"'{callee.name}' is an instance of {kind.name}, not of {block.name}",
            callee.span,
            "write the block in front that the data block was made for",
        )
    return data_block


def _counter_call(ctx: Context, node: ast.Call, callee: ast.Member) -> ast.Call:
    """`counter.CTU(..., Q => done)` of an IEC_COUNTER as the call of the CTUD that it is."""
    base = check_expression(ctx, callee.base)
    if not isinstance(base.type, BlockType) or not standard_block(base.type.name):
        return node
    output = COUNTER_METHODS[callee.name.upper()]
    if not output or not base.type.name.upper().startswith("CTUD"):
        return replace(node, callee=callee.base)
    arguments = tuple(
        replace(one, name=output) if one.name.upper() == "Q" else one for one in node.arguments
    )
    return replace(node, callee=callee.base, arguments=arguments)


# --- instructions of the controller -----------------------------------------------------------


def system_call(
    ctx: Context, node: ast.Call, instruction: Instruction
) -> tuple[Expression, ast.Expression | None]:
    """The call of a system instruction, and where `RET_VAL =>` puts its result."""
    parameters = [(parameter.name, parameter) for parameter in instruction.parameters]
    result_place: ast.Expression | None = None
    rest = []
    for argument in node.arguments:
        if argument.name.upper() == RETURN_VALUE and argument.kind is _ARROW:
            result_place = argument.value
        else:
            rest.append(argument)
    plain = ast.Call(node.span, node.callee, tuple(rest))
    bound = bind(ctx, plain, instruction.name, parameters)
    if bound is None:
        return erroneous(node.span), None
    arguments: dict[str, Expression] = {}
    for parameter, argument in bound:
        where = f"parameter {parameter.name} of {instruction.name}"
        named = argument.kind is not ast.ArgumentKind.POSITIONAL and not parameter.either_way
        allowed = parameter.is_output and ctx.rules.outputs_by_assignment
        if named and (argument.kind is _ARROW) != parameter.is_output and not allowed:
            ctx.findings.error(
                "FB4041",
                f"'{parameter.name}' of {instruction.name} is given by {argument.kind.value}",
                argument.span,
                f"write {parameter.name} {'=>' if parameter.is_output else ':='} ...",
            )
            return erroneous(node.span), None
        if argument.value is None:
            continue
        if isinstance(parameter.type, AnyType):
            value = _area(ctx, argument.value, parameter.is_output, where)
        elif isinstance(parameter.type, ReferenceType):
            value = _any_variable(ctx, argument.value, parameter, where)
        elif parameter.is_output and isinstance(parameter.type, Elementary):
            value = _written(ctx, argument.value, parameter.type, where)
        elif parameter.any_integer:
            value = check_whole(ctx, argument.value, where)
        elif parameter.type == VOID:
            value = check_expression(ctx, argument.value)
        else:
            checked_value = check_expression(ctx, argument.value, parameter.type)
            value = _hardware_address(ctx, checked_value, parameter.type, where)
        arguments[parameter.name] = value
    missing = [name for name, _ in parameters if name not in arguments]
    if missing:
        report_missing(ctx, node, instruction.name, missing)
    if missing or any(value.type == ERRONEOUS for value in arguments.values()):
        return erroneous(node.span), None
    if instruction.on_memory and not check_memory_instruction(ctx, instruction, arguments):
        return erroneous(node.span), None
    ordered = tuple((name, arguments[name]) for name, _ in parameters)
    return SystemCall(node.span, instruction.name, ordered, instruction.result), result_place


def _written(ctx: Context, node: ast.Expression, kind: Elementary, where: str) -> Expression:
    """A variable that the instruction writes a single value to."""
    target = check_target(ctx, node, where)
    return coerce(ctx, target, kind, where) if target is not None else erroneous(node.span)


def _hardware_address(
    ctx: Context, value: Expression, target: Elementary, where: str
) -> Expression:
    """An address or hardware identifier: TIA gives it as WORD or as an integer of that width."""
    kind = value.type
    if isinstance(kind, Elementary) and kind.is_integer and kind.bits == target.bits:
        return checked.Convert(value.span, value, target, implicit=True)
    return coerce(ctx, value, target, where)


def _any_variable(
    ctx: Context, node: ast.Expression, parameter: InstructionParameter, where: str
) -> Expression:
    if points(node):
        value = check_area_literal(ctx, node, where)
    elif parameter.is_output or parameter.either_way:
        value = check_target(ctx, node, where) or erroneous(node.span)
    else:
        value = check_expression(ctx, node)
    return coerce(ctx, value, VARIANT_VALUE, where)


def _area(ctx: Context, node: ast.Expression, written: bool, where: str) -> Expression:
    if points(node):
        return check_area_literal(ctx, node, where)
    if written:
        target = check_target(ctx, node, where)
        return _area_of(ctx, target, where) if target is not None else erroneous(node.span)
    expression = check_expression(ctx, node)
    if isinstance(expression, Place):
        return _area_of(ctx, expression, where)
    if expression.type != ERRONEOUS:
        ctx.findings.error(
            "FB4022",
            f"{where} takes a variable, not a value",
            node.span,
            "put the value into a variable and give that",
        )
    return erroneous(node.span)


def _area_of(ctx: Context, place: Place, where: str) -> Expression:
    """The variable itself, or what it refers to."""
    if not refers_to_anything(place.type):
        return place
    if place.type == POINTER_VALUE:
        return coerce(ctx, place, ANY_VALUE, where)
    return Dereference(place.span, place, VARIANT_VALUE)
