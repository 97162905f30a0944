"""Every kind of expression and the function that checks it."""

from typing import Any

from fbgen.lang import ast
from fbgen.lang.checked import Expression
from fbgen.lang.checker.calls import callees as calls
from fbgen.lang.checker.calls.members import special_receiver
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression, enter
from fbgen.lang.checker.operands import memory_access, operators, places, references
from fbgen.lang.checker.types import constants
from fbgen.lang.checker.types.literals import erroneous
from fbgen.lang.types import Type


def _parenthesized(ctx: Context, node: ast.Parenthesized, expected: Type | None) -> Expression:
    return check_expression(ctx, node.inner, expected)


def _initial_only(ctx: Context, node: Any, _expected: Type | None) -> Expression:
    ctx.findings.error(
        "FB4057",
        "a list of values stands only behind := in a declaration",
        node.span,
        "assign the elements one by one",
    )
    return erroneous(node.span)


def _unsupported(ctx: Context, node: Any, _expected: Type | None) -> Expression:
    what = _UNSUPPORTED[type(node)]
    ctx.findings.error("FB4054", f"{what} is not supported", node.span, "write it in another way")
    return erroneous(node.span)


def _dereference(ctx: Context, node: ast.Dereference, expected: Type | None) -> Expression:
    special = special_receiver(ctx, node)
    if special is not None:
        return special.place
    return references.check_dereference(ctx, node, expected)


_UNSUPPORTED = {
    ast.Chained: "an assignment in an assignment",
    ast.IndexedAddress: "an absolute address with an index",
    ast.Peripheral: "peripheral access by a name",
}

enter(
    {
        **dict.fromkeys(_UNSUPPORTED, _unsupported),
        ast.Literal: constants.check_literal,
        ast.Name: places.check_name,
        ast.Member: places.check_member,
        ast.Dereference: _dereference,
        ast.Index: places.check_index,
        ast.Slice: places.check_slice,
        ast.DirectAddress: places.check_address,
        ast.IndexedAddress: memory_access.check_indexed_address,
        ast.Call: calls.check_call,
        ast.Unary: operators.check_unary,
        ast.Binary: operators.check_binary,
        ast.Parenthesized: _parenthesized,
        ast.ArrayLiteral: _initial_only,
        ast.Repeated: _initial_only,
        ast.StructLiteral: _initial_only,
    }
)

__all__ = ["check_expression"]
