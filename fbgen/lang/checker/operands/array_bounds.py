"""LOWER_BOUND and UPPER_BOUND: constants of an array, and what comes with an ARRAY[*].

Source: IEC 61131-3 third edition, table 33; TIA Portal help, "LOWER_BOUND", "UPPER_BOUND".
"""

from fbgen.lang import ast
from fbgen.lang.checked import BoundOf, Constant, Expression
from fbgen.lang.checker.calls.arguments import bind
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.places import as_place
from fbgen.lang.checker.types.coercion import spelled
from fbgen.lang.checker.types.constants import whole_number
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous
from fbgen.lang.types import DINT, ArrayType, OpenArrayType

BOUNDS = ("LOWER_BOUND", "UPPER_BOUND")
_PARAMETERS = (("ARR", 0), ("DIM", 1))


def check_bound(ctx: Context, node: ast.Call, name: str) -> Expression:
    """The call of one of both functions."""
    found = bind(ctx, node, name, _PARAMETERS)
    given = {} if found is None else {number: one.value for number, one in found}
    array, dimension = given.get(0), given.get(1)
    if array is None or dimension is None:
        if found is not None:
            ctx.findings.error(
                "FB4040",
                f"{name} needs the array and the dimension",
                node.span,
                f"write {name}(ARR := values, DIM := 1)",
            )
        return erroneous(node.span)
    base = check_expression(ctx, array)
    number = whole_number(ctx, dimension, f"the dimension of {name}")
    kind = base.type
    if kind == ERRONEOUS or number is None:
        return erroneous(node.span)
    if not isinstance(kind, ArrayType | OpenArrayType):
        ctx.findings.error(
            "FB4019",
            f"{spelled(kind)} is not an array and has no bounds",
            array.span,
            "give an array, or a parameter that is ARRAY[*]",
        )
        return erroneous(node.span)
    count = kind.dimensions if isinstance(kind, OpenArrayType) else len(kind.bounds)
    if not 1 <= number <= count:
        ctx.findings.error(
            "FB4015",
            f"{kind.name} has the dimensions 1 to {count}, not {number}",
            dimension.span,
            "count the dimensions from 1",
        )
        return erroneous(node.span)
    upper = name == "UPPER_BOUND"
    if isinstance(kind, OpenArrayType):
        return BoundOf(node.span, as_place(base), number - 1, upper, DINT)
    return Constant(node.span, kind.bounds[number - 1][upper], DINT)
