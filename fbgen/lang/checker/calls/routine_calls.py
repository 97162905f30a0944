"""Calls of the controller's instructions with several outputs, and of what a stub stands for.

Sources as for `routines`.
"""

from collections.abc import Sequence
from dataclasses import field
from typing import TypeGuard

from fbgen.dataclass import dataclass
from fbgen.lang import ast
from fbgen.lang.checked import (
    Constant,
    Evaluate,
    Expression,
    FieldRef,
    Place,
    RoutineCall,
    StandardBlock,
    StandardCall,
    VariableKind,
)
from fbgen.lang.checker.calls.arguments import bind
from fbgen.lang.checker.calls.closed_blocks import fits_closed_block, use_data_block
from fbgen.lang.checker.calls.converted_outputs import converted_output
from fbgen.lang.checker.calls.numbered import number_named
from fbgen.lang.checker.calls.unmodelled import closed_parameters
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.places import is_place, root_variable
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.supplied.routines import Direction, Parameter, Routine, routine_named
from fbgen.lang.checker.supplied.routines.hardware_parameters import HARDWARE_PARAMETERS
from fbgen.lang.checker.supplied.routines.signature import ANYTHING, NUMBER, SAME, WHOLE
from fbgen.lang.checker.supplied.standard_blocks import standard_block
from fbgen.lang.checker.types.coercion import as_typed, coerce, converted, spelled
from fbgen.lang.checker.types.conversions import is_implicit, keeps_representation
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous, is_untyped
from fbgen.lang.dates import of_dialect
from fbgen.lang.types import (
    COUNTER,
    INT,
    S5TIME,
    TIME,
    TIMER,
    UINT,
    VOID,
    AnyType,
    Elementary,
    Family,
    StringType,
    StructType,
    Type,
)
from fbgen.nearest import nearest

RETURN_VALUE = "RET_VAL"
_ARROW = ast.ArgumentKind.OUTPUT
_POSITIONAL = ast.ArgumentKind.POSITIONAL
_NUMBERED = {"TIMER": TIMER, "COUNTER": COUNTER}
_COUNTS = (Family.SIGNED, Family.UNSIGNED, Family.BITS)


@dataclass(slots=True)
class _Arguments:
    """What the arguments of one call came to; `same` is the type of the SAME parameters."""

    inputs: list[tuple[str, Expression]] = field(default_factory=list)
    outputs: list[tuple[str, Place]] = field(default_factory=list)
    same: Type | None = None
    complete: bool = True

    def add_input(self, name: str, value: Expression) -> None:
        """One more input, unless it was reported."""
        if value.type == ERRONEOUS:
            self.complete = False
        else:
            self.inputs.append((name, value))

    def add_output(self, name: str, place: Place | None) -> None:
        """One more output, unless it was reported."""
        if place is None:
            self.complete = False
        else:
            self.outputs.append((name, place))


def is_routine(ctx: Context, name: str) -> bool:
    """True for instructions with several outputs, and for functions that a stub stands for."""
    if routine_named(name) is not None:
        return True
    return ctx.library.is_stubbed(name) and standard_block(name) is None


def routine(ctx: Context, node: ast.Call, name: str, expected: Type | None) -> RoutineCall | None:
    """The call of what `is_routine` says yes to; None after reporting errors."""
    known = routine_named(name)
    if known is not None:
        return routine_call(ctx, node, known, expected)
    return stubbed_call(ctx, node, ctx.library.stubbed_name(name), expected)


def value_of_routine(ctx: Context, node: ast.Call, name: str, expected: Type | None) -> Expression:
    call = routine(ctx, node, name, expected)
    if call is None:
        return erroneous(node.span)
    if call.type == VOID:
        ctx.findings.error(
            "FB4048",
            f"{call.name} has no result",
            node.span,
            "call it in a statement of its own and take its outputs by =>",
        )
        return erroneous(node.span)
    return call


def routine_call(
    ctx: Context, node: ast.Call, routine: Routine, expected: Type | None
) -> RoutineCall | None:
    """The call of an instruction; None after reporting errors."""
    found = _Arguments()
    rest = []
    for argument in node.arguments:
        if argument.name.upper() == RETURN_VALUE and routine.result != VOID:
            _return_value(ctx, routine, argument, found)
        else:
            rest.append(argument)
    plain = ast.Call(node.span, node.callee, tuple(rest))
    if routine.open_ended:
        _warn_of_names(ctx, plain, routine.name)
        _free_arguments(ctx, plain, routine.name, found)
    elif not _bound_arguments(ctx, plain, routine, found):
        return None
    if not found.complete:
        return None
    kind = routine.result
    if not routine.modelled:
        _without_model(ctx, node, routine.name)
        kind = expected if isinstance(expected, Elementary | StringType) else kind
    return RoutineCall(node.span, routine.name, tuple(found.inputs), tuple(found.outputs), kind)


def stubbed_call(
    ctx: Context, node: ast.Call, name: str, expected: Type | None
) -> RoutineCall | None:
    """The call of a function that only a stub of the user knows; it has the type it is used as."""
    found = _Arguments()
    _free_arguments(ctx, node, name, found)
    if not found.complete:
        return None
    kind = expected if expected is not None and expected != ERRONEOUS else INT
    return RoutineCall(node.span, name, tuple(found.inputs), tuple(found.outputs), kind)


def unmodelled_instance_call(
    ctx: Context, node: ast.Call, place: Place, block: StandardBlock
) -> Evaluate | None:
    """The call of an instance of a block without a model."""
    found = _Arguments()
    closed = closed_parameters(block.name)
    if closed and not fits_closed_block(ctx, node, block.name, closed):
        return None
    _free_arguments(ctx, node, block.name, found, block)
    if not found.complete:
        return None
    _add_remembered(ctx, place, block, found)
    if not closed:
        _without_model(ctx, node, block.name)
    use_data_block(ctx, found.inputs)
    inputs, outputs = tuple(found.inputs), tuple(found.outputs)
    return Evaluate(node.span, RoutineCall(node.span, block.name, inputs, outputs, VOID, place))


def _add_remembered(ctx: Context, place: Place, block: StandardBlock, found: _Arguments) -> None:
    """The inputs that the call leaves out and that the text sets as members of an instance."""
    given = {name.casefold() for name, _ in found.inputs}
    for variable in block.variables:
        key = variable.name.casefold()
        written = ctx.library.assigned_members().get(key)
        if variable.kind is VariableKind.INPUT and key not in given and written is not None:
            value = FieldRef(place.span, place, variable.name, variable.type)
            found.add_input(written, value)


def _without_model(ctx: Context, node: ast.Call, name: str) -> None:
    if not ctx.library.is_stubbed(name):
        ctx.findings.warning(
            "FB4140",
            f"{name} works on hardware that the simulated controller does not have",
            node.span,
            f'to run it, say what it does: program.stub("{name}", function)',
        )


def _return_value(
    ctx: Context, routine: Routine, argument: ast.Argument, found: _Arguments
) -> None:
    if argument.value is None:
        return
    where = f"{RETURN_VALUE} of {routine.name}"
    place = check_target(ctx, argument.value, where)
    if place is not None and routine.modelled and not _takes_result(routine.result, place.type):
        _refuse_place(ctx, argument, where, routine.result.name, place.type)
        place = None
    found.add_output(RETURN_VALUE, place)


def _takes_result(result: Type, kind: Type) -> bool:
    """A status is WORD or INT, as the user likes it."""
    if isinstance(result, Elementary) and isinstance(kind, Elementary):
        both = result.family in _COUNTS and kind.family in _COUNTS
        if both and result.bits == kind.bits:
            return True
    return keeps_representation(result, kind)


def _refuse_place(ctx: Context, argument: ast.Argument, where: str, given: str, kind: Type) -> None:
    ctx.findings.error(
        "FB4010",
        f"{where} gives {given}, which {spelled(kind)} cannot take",
        argument.span,
        "take it into a variable of that type, then convert it",
    )


# --- parameters of any name -------------------------------------------------------------------


def _free_arguments(
    ctx: Context,
    node: ast.Call,
    name: str,
    found: _Arguments,
    block: StandardBlock | None = None,
) -> None:
    """Outputs take the type of their places; what is given by := may come back changed."""
    known = {one.name.casefold(): one for one in block.variables} if block is not None else {}
    for argument in node.arguments:
        if argument.value is None:
            continue
        where = f"parameter {argument.name} of {name}"
        if argument.kind is _POSITIONAL:
            ctx.findings.error(
                "FB4044",
                f"the parameters of {name} are not known, so their order is not either",
                argument.span,
                "give each argument by its name",
            )
            found.complete = False
        elif argument.kind is _ARROW or argument.name.upper() == RETURN_VALUE:
            place = check_target(ctx, argument.value, where)
            variable = known.get(argument.name.casefold())
            if (
                variable is not None
                and place is not None
                and not _takes_result(variable.type, place.type)
            ):
                behind = converted_output(ctx, argument.value.span, variable.type, place)
                if behind is None:
                    _refuse_place(ctx, argument, where, spelled(variable.type), place.type)
                place = behind
            found.add_output(argument.name, place)
        else:
            variable = known.get(argument.name.casefold())
            value = check_expression(
                ctx, argument.value, None if variable is None else variable.type
            )
            value = _as_known(ctx, value, None if variable is None else variable.type)
            found.add_input(argument.name, value)
            if _may_come_back(value, ctx):
                found.outputs.append((argument.name, value))


def _warn_of_names(ctx: Context, node: ast.Call, name: str) -> None:
    """FB4143: a parameter that the function does not have, as far as it is known."""
    known = HARDWARE_PARAMETERS.get(name)
    if known is None or ctx.library.is_stubbed(name):
        return
    for argument in node.arguments:
        if argument.name and argument.name.upper() not in known:
            ctx.findings.warning(
                "FB4143",
                f"{name} has no parameter '{argument.name}'",
                argument.span,
                nearest(argument.name, known) if known else "it has none",
            )


def _as_known(ctx: Context, value: Expression, kind: Type | None) -> Expression:
    """The value in the type that the parameter is known to have, if it gets there by itself."""
    if kind is None:
        return as_typed(value)
    if isinstance(value, Constant) and is_untyped(value.type) and isinstance(kind, Elementary):
        whole = isinstance(value.value, int) and kind.family in _COUNTS
        if whole and kind.minimum <= int(value.value) <= kind.maximum:
            return Constant(value.span, value.value, kind)
    if is_implicit(value.type, kind, ctx.rules):
        return converted(value, kind)
    return as_typed(value)


def _may_come_back(value: Expression, ctx: Context) -> TypeGuard[Place]:
    if not is_place(value) or isinstance(value.type, AnyType):
        return False
    variable = root_variable(value)
    return variable is not None and not (
        variable.kind is VariableKind.INPUT or ctx.is_read_only(variable)
    )


# --- parameters of the tables -----------------------------------------------------------------


def _bound_arguments(ctx: Context, node: ast.Call, routine: Routine, found: _Arguments) -> bool:
    parameters = [(parameter.name, parameter) for parameter in routine.parameters]
    bound = bind(ctx, node, routine.name, parameters)
    if bound is None:
        return False
    given = {parameter for parameter, argument in bound if argument.value is not None}
    missing = [one.name for one in routine.parameters if not one.optional and one not in given]
    if missing:
        ctx.findings.error(
            "FB4040",
            f"the call of {routine.name} leaves out {', '.join(missing)}",
            node.span,
            f"its parameters are: {', '.join(_shown(routine.parameters))}",
        )
        return False
    for parameter, argument in bound:
        if argument.value is None:
            continue
        where = f"parameter {parameter.name} of {routine.name}"
        if _wrong_way(ctx, parameter, argument, where):
            found.complete = False
            continue
        if parameter.direction is Direction.INPUT:
            found.add_input(parameter.name, _input(ctx, parameter, argument.value, where, found))
            continue
        place = _output(ctx, parameter, argument, where, found)
        found.add_output(parameter.name, place)
        if parameter.direction is Direction.IN_OUT and place is not None:
            found.add_input(parameter.name, place)
    return True


def _shown(parameters: Sequence[Parameter]) -> list[str]:
    arrows = {Direction.INPUT: ":=", Direction.OUTPUT: "=>", Direction.IN_OUT: ":="}
    shown = [one for one in parameters if not (one.optional and one.name[-1:] in "23456789")]
    return [f"{one.name} {arrows[one.direction]}" for one in shown]


def _wrong_way(ctx: Context, parameter: Parameter, argument: ast.Argument, where: str) -> bool:
    if argument.kind is _POSITIONAL or parameter.direction is Direction.IN_OUT:
        return False
    if (argument.kind is _ARROW) == parameter.is_output:
        return False
    if parameter.is_output and ctx.rules.outputs_by_assignment:
        return False
    ctx.findings.error(
        "FB4041",
        f"{where} is given by {argument.kind.value}",
        argument.span,
        f"write {parameter.name} {'=>' if parameter.is_output else ':='} ...",
    )
    return True


def _types(ctx: Context, parameter: Parameter) -> tuple[Type, ...]:
    """The types among the words of a parameter, as the dialect has them."""
    return tuple(of_dialect(kind, ctx.rules.dialect) for kind in parameter.types)


def _input(
    ctx: Context, parameter: Parameter, node: ast.Expression, where: str, found: _Arguments
) -> Expression:
    word = parameter.words[0]
    if word in _NUMBERED:
        return _numbered(ctx, node, word, where)
    types = _types(ctx, parameter)
    hint = types[0] if types else found.same if word == SAME else None
    value = check_expression(ctx, node, hint)
    if value.type == ERRONEOUS:
        return value
    if types:
        return _of_types(ctx, value, parameter, where)
    if word == SAME and found.same is not None:
        return coerce(ctx, value, found.same, where)
    value = as_typed(value)
    if word == SAME:
        found.same = value.type
    if _suits(word, value.type):
        return value
    ctx.findings.error(
        "FB4010",
        f"{where} takes {_WORDS[word]}, not {spelled(value.type)}",
        value.span,
        "convert the value",
    )
    return erroneous(value.span)


_WORDS = {WHOLE: "a whole number", NUMBER: "a number"}


def _suits(word: str, kind: Type) -> bool:
    if word in (ANYTHING, SAME):
        return True
    if not isinstance(kind, Elementary):
        return False
    return kind.is_integer or (word == NUMBER and kind.family is Family.REAL)


def _of_types(ctx: Context, value: Expression, parameter: Parameter, where: str) -> Expression:
    types = _types(ctx, parameter)
    kind = value.type
    if isinstance(kind, StringType) and any(
        isinstance(one, StringType) and one.wide == kind.wide for one in types
    ):
        return value
    if kind in types or _is_structure(kind, parameter):
        return value
    if S5TIME in types and kind == TIME:
        return StandardCall(value.span, "TIME_TO_S5TIME", (value,), S5TIME)
    if is_untyped(kind) or len(types) == 1:
        return coerce(ctx, value, types[0], where)
    names = " or ".join(parameter.words)
    ctx.findings.error(
        "FB4010",
        f"{where} takes {names}, not {spelled(kind)}",
        value.span,
        "use a variable of such a type",
    )
    return erroneous(value.span)


def _is_structure(kind: Type, parameter: Parameter) -> bool:
    return isinstance(kind, StructType) and kind.name.upper() in parameter.words


def _output(
    ctx: Context,
    parameter: Parameter,
    argument: ast.Argument,
    where: str,
    found: _Arguments,
) -> Place | None:
    assert argument.value is not None
    place = check_target(ctx, argument.value, where)
    if place is None:
        return None
    word, kind, types = parameter.words[0], place.type, _types(ctx, parameter)
    if word not in (SAME, ANYTHING, WHOLE, NUMBER):
        fits = _is_structure(kind, parameter) or any(
            _fits_place(one, kind, parameter) for one in types
        )
        given = " or ".join(parameter.words)
    elif word == SAME:
        fits = found.same is None or keeps_representation(found.same, kind)
        given = spelled(found.same) if found.same is not None else ""
    else:
        fits, given = _suits(word, kind), _WORDS.get(word, "a value")
    if fits:
        return place
    if parameter.direction is Direction.OUTPUT and len(types) == 1:
        behind = converted_output(ctx, argument.value.span, types[0], place)
        if behind is not None:
            return behind
    _refuse_place(ctx, argument, where, given, kind)
    return None


def _fits_place(source: Type, kind: Type, parameter: Parameter) -> bool:
    if isinstance(source, StringType):
        return isinstance(kind, StringType) and kind.wide == source.wide
    if parameter.direction is Direction.IN_OUT:
        return source == kind
    return keeps_representation(source, kind)


def _numbered(ctx: Context, node: ast.Expression, word: str, where: str) -> Expression:
    """The number of a timer or counter: T1, C1 (or Z1), %T1, or a whole number."""
    number = number_named(ctx, node, _NUMBERED[word])
    if number is not None:
        return Constant(node.span, number, UINT)
    value = as_typed(check_expression(ctx, node, UINT))
    if value.type == ERRONEOUS:
        return value
    if isinstance(value.type, Elementary) and value.type.family in _COUNTS:
        return value
    letter = "T" if word == "TIMER" else "C"
    ctx.findings.error(
        "FB4010",
        f"{where} is the number of a {word.lower()}, not {spelled(value.type)}",
        node.span,
        f"write {letter}1, or give the number",
    )
    return erroneous(node.span)
