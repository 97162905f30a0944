"""Operators on statements: left out, or with the labels of another branch."""

from collections.abc import Iterator
from dataclasses import replace

from fbgen.lang.checked import (
    Assignment,
    Case,
    CaseArm,
    Continue,
    Evaluate,
    Exit,
    If,
    InstanceCall,
    Repeat,
    Return,
    Statement,
    While,
)
from fbgen.source import Span
from harness.verify.mutation.mutant import Change, Edit, Exchange, Operator
from harness.verify.mutation.operations import negations

_SIMPLE = (Assignment, Evaluate, InstanceCall, Return, Exit, Continue)


def left_out(statement: Statement) -> Iterator[Change]:
    """Nothing in the place of a statement that has none inside."""
    if not isinstance(statement, _SIMPLE):
        return
    span = statement.span
    text = span.text.removesuffix(";")
    shown = Span(span.source, span.start, span.start + len(text))
    yield Change(Operator.DROP, statement, (Exchange(statement, ()),), (Edit(shown, ""),))


def negated(statement: Statement) -> Iterator[Change]:
    """The conditions of IF, WHILE and REPEAT negated."""
    if isinstance(statement, If):
        yield from negations(statement, [branch.condition for branch in statement.branches])
    elif isinstance(statement, While | Repeat):
        yield from negations(statement, [statement.condition])


def exchanged_labels(statement: Statement) -> Iterator[Change]:
    """Two neighbouring branches of a CASE with each other's labels."""
    if not isinstance(statement, Case):
        return
    for arm, following in zip(statement.arms, statement.arms[1:], strict=False):
        one, other = labels(arm), labels(following)
        exchanges = (
            Exchange(arm, (replace(arm, ranges=following.ranges),)),
            Exchange(following, (replace(following, ranges=arm.ranges),)),
        )
        edits = (Edit(one, other.text), Edit(other, one.text))
        yield Change(Operator.CASE, statement, exchanges, edits)


def labels(arm: CaseArm) -> Span:
    """The text in front of the colon of a branch."""
    text, place = arm.span.source.text, arm.span.start
    while text[place] != ":":
        place += 1
    return Span(arm.span.source, arm.span.start, place)
