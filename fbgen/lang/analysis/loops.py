"""Loops that do not end, and FOR variables that are changed inside of their loop."""

from collections.abc import Sequence

from fbgen.lang.analysis.effects import Effects
from fbgen.lang.analysis.report import Report
from fbgen.lang.checked import (
    LIVING,
    Constant,
    Expression,
    For,
    Repeat,
    Variable,
    VariableKind,
    VariableRef,
    While,
)
from fbgen.lang.types import BOOL
from fbgen.source import Span

_OF_THE_BLOCK = (*LIVING, VariableKind.TEMP, VariableKind.RESULT)
Write = tuple[Variable, Span, bool]


def is_always(condition: Expression, answer: bool) -> bool:
    """True if the condition is a constant with that value."""
    return isinstance(condition, Constant) and condition.type == BOOL and condition.value is answer


def surely_runs(node: For) -> bool:
    """True if the body runs at least once, whatever the variables are."""
    first, last, step = node.first, node.last, node.step
    if not (
        isinstance(first, Constant) and isinstance(last, Constant) and isinstance(step, Constant)
    ):
        return False
    if not (
        isinstance(first.value, int) and isinstance(last.value, int) and isinstance(step.value, int)
    ):
        return False
    return first.value <= last.value if step.value > 0 else first.value >= last.value


def watched_variables(effects: Effects) -> frozenset[Variable] | None:
    """What a condition depends on; None if something else than this block may change it."""
    if effects.outside or effects.members or effects.touched:
        return None
    variables = frozenset(ref.variable for ref in effects.reads)
    if not variables or any(
        one.kind not in _OF_THE_BLOCK or one.address is not None for one in variables
    ):
        return None
    return variables


def check_end(
    report: Report,
    node: While | Repeat,
    watched: frozenset[Variable] | None,
    written: Sequence[Write],
) -> None:
    """FB4213, for a loop that no EXIT, RETURN or GOTO leaves."""
    condition = node.condition
    if is_always(condition, isinstance(node, While)):
        report.warning(
            "FB4213",
            "this loop never ends",
            condition.span,
            "leave it by EXIT, or write the condition that ends it",
        )
    elif watched is not None and not any(variable in watched for variable, _, _ in written):
        names = ", ".join(sorted(f"'{variable.name}'" for variable in watched))
        keyword = "UNTIL" if isinstance(node, Repeat) else "WHILE"
        report.warning(
            "FB4213",
            f"nothing in this loop changes {names}, so the condition of {keyword} stays as it is",
            condition.span,
            "change the variable in the loop, leave it by EXIT, or use IF",
            about=next(iter(watched & report.vague), None),
        )


def check_counter(report: Report, node: For, written: Sequence[Write]) -> None:
    """FB4214: the loop alone counts its variable."""
    if not isinstance(node.variable, VariableRef):
        return
    counter = node.variable.variable
    for variable, span, whole in written:
        if variable is counter and whole:
            report.warning(
                "FB4214",
                f"'{counter.name}' is written inside of the FOR loop that counts it",
                span,
                "leave the loop by EXIT, skip by CONTINUE, or use WHILE with a variable of its own",
                about=counter,
            )
            return
