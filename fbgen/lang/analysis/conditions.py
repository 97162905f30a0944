"""Conditions whose answer is known, and those that an earlier branch has asked already."""

import re

from fbgen.lang.analysis.effects import same_value
from fbgen.lang.analysis.report import Report
from fbgen.lang.checked import Branch, Case, Constant, Expression
from fbgen.lang.types import BOOL, Enumeration

_WORD = re.compile(r"[^\W\d]\w*", re.UNICODE)
_ELSE = re.compile(r"\bELSE\b", re.IGNORECASE)
_WORDS_OF_CONSTANTS = frozenset(("TRUE", "FALSE", "AND", "OR", "XOR", "NOT", "BOOL"))


def check_condition(report: Report, condition: Expression) -> None:
    """FB4211. A named constant is a switch that somebody may set otherwise: no warning."""
    if not isinstance(condition, Constant) or condition.type != BOOL:
        return
    words = {word.upper() for word in _WORD.findall(condition.span.text)}
    if words <= _WORDS_OF_CONSTANTS:
        report.warning(
            "FB4211",
            f"this condition is always {str(condition.value).upper()}",
            condition.span,
            "remove the condition, or give the switch a name in VAR CONSTANT",
        )


def check_repeated_conditions(report: Report, branches: tuple[Branch, ...]) -> None:
    """FB4212: an ELSIF that asks what an earlier branch has asked is never reached."""
    if len(branches) == 1:
        return
    asked: dict[str, Expression] = {}
    for branch in branches:
        condition = branch.condition
        if isinstance(condition, Constant):
            continue
        text = "".join(condition.span.text.split()).casefold()
        earlier = asked.setdefault(text, condition)
        if earlier is not condition and same_value(earlier, condition):
            report.warning(
                "FB4212",
                f"line {earlier.span.line} has the same condition, so this branch is never taken",
                condition.span,
                "ask for something else, or remove the branch",
            )


def check_case(report: Report, node: Case) -> None:
    """FB4216: a CASE over an enumeration leaves names out and has no ELSE for them."""
    kind = node.selector.type
    if not isinstance(kind, Enumeration) or node.otherwise or _has_else(node):
        return
    missing = [
        name
        for name, value in kind.members
        if not any(first <= value <= last for arm in node.arms for first, last in arm.ranges)
    ]
    if missing:
        report.hint(
            "FB4216",
            f"this CASE leaves out {', '.join(missing)} of {kind.name} and has no ELSE",
            node.selector.span,
            "add the missing names, or ELSE with a lone ; if nothing is to be done for them",
        )


def _has_else(node: Case) -> bool:
    """True for an ELSE without statements, which is not in the checked program any more."""
    start = node.arms[-1].span.end if node.arms else node.selector.span.end
    return _ELSE.search(node.span.source.text, start, node.span.end) is not None
