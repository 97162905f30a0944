"""Calls of instances whose every parameter is known: no other name, and no area left out.

Which blocks that are says `routines.point_to_point`. What is no area may be left out: the instance
keeps it.
"""

from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.checked import Expression
from fbgen.lang.checker.calls.arguments import bind
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.operands.memory_access import use_block
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.supplied.routines.signature import AREA, Direction, Parameter
from fbgen.lang.checker.types.coercion import spelled
from fbgen.lang.types import BOOL, AnyType, ArrayType, BlockType

_DATA_BLOCK_NUMBER = "DB_NO"


def fits_closed_block(
    ctx: Context, node: ast.Call, name: str, parameters: Sequence[Parameter]
) -> bool:
    """False after reporting FB4006, FB4010, FB4040 or FB4043."""
    given = [one for one in parameters if one.direction is not Direction.STATIC]
    if bind(ctx, node, name, [(one.name, one) for one in given]) is None:
        return False
    arguments = {one.name.casefold(): one for one in node.arguments if one.value is not None}
    fits = True
    for area in (one.name for one in given if one.words == (AREA,)):
        fits = _is_area(ctx, node, name, area, arguments.get(area.casefold())) and fits
    return fits


def use_data_block(ctx: Context, inputs: Sequence[tuple[str, Expression]]) -> None:
    """The data block that a call of the S7-300 and S7-400 names by number lies in bytes."""
    for name, value in inputs:
        if name.upper() == _DATA_BLOCK_NUMBER:
            use_block(ctx, value)


def _is_area(
    ctx: Context, node: ast.Call, name: str, area: str, argument: ast.Argument | None
) -> bool:
    if argument is None or argument.value is None:
        ctx.findings.error(
            "FB4040",
            f"the call of {name} leaves out {area}",
            node.span,
            f"{area} is a variable, such as an array of BYTE",
        )
        return False
    place = check_target(ctx, argument.value, f"parameter {area} of {name}")
    if place is None:
        return False
    kind = place.type.element if isinstance(place.type, ArrayType) else place.type
    if kind == BOOL or isinstance(kind, AnyType | BlockType):
        ctx.findings.error(
            "FB4010",
            f"parameter {area} of {name} takes bytes, not {spelled(kind)}",
            argument.span,
            "use an array of BYTE, or a structure",
        )
        return False
    return True
