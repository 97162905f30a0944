"""Which argument of a call belongs to which parameter."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Note
from fbgen.lang import ast
from fbgen.lang.checked import Expression, Place, Variable
from fbgen.lang.checker.context import Context
from fbgen.nearest import nearest

_P = TypeVar("_P")


@dataclass(frozen=True, slots=True)
class Bound:
    """The checked arguments of a call, by the direction of their parameters."""

    inputs: tuple[tuple[Variable, Expression], ...] = ()
    in_outs: tuple[tuple[Variable, Place], ...] = ()
    outputs: tuple[tuple[Variable, Place], ...] = ()


def bind(
    ctx: Context,
    call: ast.Call,
    name: str,
    parameters: Sequence[tuple[str, _P]],
) -> list[tuple[_P, ast.Argument]] | None:
    """Each argument with its parameter, in the order written; None after reporting errors.

    `parameters` are the names with whatever belongs to them, in positional order.
    """
    positional = [
        argument for argument in call.arguments if argument.kind is ast.ArgumentKind.POSITIONAL
    ]
    if positional and len(positional) != len(call.arguments):
        if ctx.rules.mixed_arguments and call.arguments[: len(positional)] == tuple(positional):
            return _first_by_position(ctx, call, name, parameters, len(positional))
        ctx.findings.error(
            "FB4044",
            f"the call of {name} mixes arguments with and without names",
            call.span,
            "name all of them, or none",
        )
        return None
    if positional:
        return _by_position(ctx, call, name, parameters)
    return _by_name(ctx, call, name, parameters)


def _first_by_position(
    ctx: Context,
    call: ast.Call,
    name: str,
    parameters: Sequence[tuple[str, _P]],
    count: int,
) -> list[tuple[_P, ast.Argument]] | None:
    """`f(1, 2, q => x)`: the first arguments in their order, the others by their names."""
    first = _by_position(ctx, replace(call, arguments=call.arguments[:count]), name, parameters)
    rest = _by_name(ctx, replace(call, arguments=call.arguments[count:]), name, parameters[count:])
    return None if first is None or rest is None else [*first, *rest]


def only_argument(ctx: Context, call: ast.Call, name: str) -> ast.Expression | None:
    """The argument of a call that takes one variable; None after reporting another number."""
    argument = call.arguments[0].value if len(call.arguments) == 1 else None
    if argument is None:
        ctx.findings.error(
            "FB4042" if call.arguments else "FB4040",
            f"{name} takes one variable",
            call.span,
            f"write {name}(variable)",
        )
    return argument


def _by_position(
    ctx: Context, call: ast.Call, name: str, parameters: Sequence[tuple[str, _P]]
) -> list[tuple[_P, ast.Argument]] | None:
    if len(call.arguments) > len(parameters) and name.casefold() in ctx.library.incomplete:
        return None
    if len(call.arguments) > len(parameters):
        names = ", ".join(parameter for parameter, _ in parameters)
        ctx.findings.error(
            "FB4042",
            f"{name} takes {len(parameters)} arguments, not {len(call.arguments)}",
            call.arguments[len(parameters)].span,
            f"its parameters are: {names}" if names else "it has no parameters",
        )
        return None
    pairs = zip(parameters, call.arguments, strict=False)
    return [(parameter, argument) for (_, parameter), argument in pairs]


def _by_name(
    ctx: Context, call: ast.Call, name: str, parameters: Sequence[tuple[str, _P]]
) -> list[tuple[_P, ast.Argument]] | None:
    known = {parameter.casefold(): value for parameter, value in parameters}
    seen: dict[str, ast.Argument] = {}
    bound = []
    complete = True
    for argument in call.arguments:
        key = argument.name.casefold()
        if key not in known and key in ("en", "eno"):
            complete = False
            ctx.findings.error(
                "FB4084",
                f"{argument.name} is not possible in a call inside of an expression",
                argument.span,
                "assign the result of the call to a variable first: x := f(EN := ..., ENO => ...);",
            )
        elif key not in known and name.casefold() in ctx.library.incomplete:
            complete = False
        elif key not in known:
            complete = False
            ctx.findings.error(
                "FB4006",
                f"{name} has no parameter '{argument.name}'",
                argument.span,
                nearest(argument.name, (parameter for parameter, _ in parameters)),
            )
        elif key in seen:
            complete = False
            ctx.findings.error(
                "FB4043",
                f"parameter '{argument.name}' of {name} is given twice",
                argument.span,
                "remove one of them",
                (Note("the first one is here", seen[key].span),),
            )
        else:
            seen[key] = argument
            bound.append((known[key], argument))
    return bound if complete else None
