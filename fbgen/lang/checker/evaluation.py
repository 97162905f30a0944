"""The way from a written expression to a checked one: which function checks which node.

The modules for places, operators and calls enter their functions here, so that they can refer to
each other's expressions without importing each other.
"""

from collections.abc import Callable
from typing import Any

from fbgen.lang import ast
from fbgen.lang.checked import Dereference, Expression, Place
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous
from fbgen.lang.types import ReferenceType, Type

Check = Callable[[Context, Any, Type | None], Expression]

_CHECKS: dict[type, Check] = {}


def enter(checks: dict[type, Check]) -> None:
    """Say which functions check which nodes."""
    _CHECKS.update(checks)


def check_expression(
    ctx: Context, node: ast.Expression, expected: Type | None = None
) -> Expression:
    """The meaning of an expression.

    `expected` is the type that its place takes, a hint for functions that exist for many types.
    The result may be an untyped constant; `coercion.coerce` gives it its type.
    """
    found = check_itself(ctx, node, expected)
    kind = found.type
    if type(kind) is ReferenceType and kind.is_implicit and isinstance(found, Place):
        target = kind.target
        return (
            Dereference(node.span, found, target) if target != ERRONEOUS else erroneous(node.span)
        )
    return found


def check_itself(ctx: Context, node: ast.Expression, expected: Type | None = None) -> Expression:
    """As `check_expression`; a REFERENCE TO is not followed to what it refers to."""
    ctx.depth += 1
    try:
        if ctx.too_deep(node.span):
            return erroneous(node.span)
        found = _CHECKS[type(node)](ctx, node, expected)
        if found.type is ERRONEOUS:
            ctx.findings.unclear.append(node.span)
        return found
    finally:
        ctx.depth -= 1
