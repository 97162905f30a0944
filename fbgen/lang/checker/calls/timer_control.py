"""RESET_TIMER and PRESET_TIMER: what is done to a timer besides calling it.

Source: TIA Portal help, "RESET_TIMER: Reset timer" and "PRESET_TIMER: Load time duration".
"""

from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.checked import Evaluate, Expression, Place, RoutineCall, StandardBlock, Statement
from fbgen.lang.checker.calls.arguments import bind
from fbgen.lang.checker.calls.binding import report_missing
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.supplied.standard_blocks import standard_block
from fbgen.lang.checker.types.coercion import coerce, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import VOID, BlockType

TIMER_CONTROLS = {"RESET_TIMER": ("TIMER",), "PRESET_TIMER": ("PT", "TIMER")}
"""Their parameters."""


def is_timer_control(ctx: Context, name: str) -> bool:
    """True for the names of both."""
    return ctx.rules.dialect == "tia" and name.upper() in TIMER_CONTROLS


def timer_control(ctx: Context, node: ast.Call, name: str) -> Sequence[Statement]:
    """The call; nothing after reporting errors."""
    key = name.upper()
    wanted = TIMER_CONTROLS[key]
    bound = bind(ctx, node, key, [(one, one) for one in wanted])
    if bound is None:
        return ()
    given: dict[str, ast.Expression] = {}
    for parameter, argument in bound:
        if argument.kind is ast.ArgumentKind.OUTPUT:
            ctx.findings.error(
                "FB4041",
                f"'{parameter}' of {key} is given by =>",
                argument.span,
                f"write {parameter} := ...",
            )
            return ()
        if argument.value is not None:
            given[parameter] = argument.value
    missing = [one for one in wanted if one not in given]
    if missing:
        report_missing(ctx, node, key, missing)
        return ()
    timer = _timer(ctx, given["TIMER"], f"parameter TIMER of {key}")
    if timer is None:
        return ()
    place, block = timer
    inputs: list[tuple[str, Expression]] = []
    if "PT" in given:
        kind = next(one.type for one in block.variables if one.name == "PT")
        value = check_expression(ctx, given["PT"], kind)
        value = coerce(ctx, value, kind, f"parameter PT of {key}")
        if value.type == ERRONEOUS:
            return ()
        inputs.append(("PT", value))
    call = RoutineCall(node.span, key, tuple(inputs), (), VOID, place)
    return (Evaluate(node.span, call),)


def _timer(ctx: Context, node: ast.Expression, where: str) -> tuple[Place, StandardBlock] | None:
    """The instance of a timer; None after reporting that it is none."""
    value = check_expression(ctx, node)
    if value.type == ERRONEOUS:
        return None
    if isinstance(value.type, BlockType) and isinstance(value, Place):
        block = ctx.library.block(value.type.name)
        if isinstance(block, StandardBlock) and block.name == "IEC_TIMER":
            block = standard_block("TONR")
        if isinstance(block, StandardBlock) and any(one.name == "ET" for one in block.variables):
            return value, block
    ctx.findings.error(
        "FB4010",
        f"{where} takes a timer, not {spelled(value.type)}",
        node.span,
        "give an instance of TON, TOF, TP, TONR or IEC_TIMER",
    )
    return None
