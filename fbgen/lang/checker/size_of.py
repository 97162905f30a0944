"""SIZEOF: how many bytes a variable or a type takes.

Source: CODESYS help, "SIZEOF"; how variables lie in memory is said in `fbgen.lang.layout`.
"""

from fbgen.diagnostics import DiagnosticError
from fbgen.lang import ast
from fbgen.lang.checked import Constant, Expression
from fbgen.lang.checker.coercion import as_typed, spelled
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.literals import ERRONEOUS, erroneous
from fbgen.lang.checker.places import find_symbol
from fbgen.lang.layout import PC_SIZES, holds_blocks, holds_values
from fbgen.lang.types import UDINT, OpenArrayType, Type

SIZE_OF = "SIZEOF"


def is_size_of(ctx: Context, name: str) -> bool:
    """True for SIZEOF, which is of CODESYS and TwinCAT."""
    return name.upper() == SIZE_OF and ctx.rules.dialect in ("iec", "twincat")


def size_of(ctx: Context, node: ast.Call) -> Expression:
    """The call, which is a constant."""
    argument = node.arguments[0].value if len(node.arguments) == 1 else None
    if argument is None:
        ctx.findings.error(
            "FB4042" if node.arguments else "FB4040",
            "SIZEOF takes one variable or type",
            node.span,
            "write SIZEOF(variable)",
        )
        return erroneous(node.span)
    kind = _type(ctx, argument)
    if kind == ERRONEOUS:
        return erroneous(node.span)
    size = None
    if holds_values(kind) and not holds_blocks(kind) and not isinstance(kind, OpenArrayType):
        try:
            size = PC_SIZES.size_bytes(kind)
        except DiagnosticError:
            size = None
    if size is None:
        ctx.findings.error(
            "FB4054",
            f"SIZEOF of {spelled(kind)} is not supported",
            node.span,
            "what has no fixed bytes here has another size on each controller",
        )
        return erroneous(node.span)
    return Constant(node.span, size, UDINT)


def _type(ctx: Context, node: ast.Expression) -> Type:
    """The type of a variable, or the type that is named."""
    if isinstance(node, ast.Name) and find_symbol(ctx, node) is None:
        return ctx.library.types.named(ctx, node.name, node.span, node.quoted).type
    return as_typed(check_expression(ctx, node)).type
