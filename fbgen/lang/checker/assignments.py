"""Assignments, also several in one statement, and set and reset.

`a := b := c` is `b := c; a := b`, from right to left with the conversions of each step (TIA Portal
help, "Value assignments"). `S=` and `R=` write only where their value is TRUE; what stands left of
one in a chain takes the value at its right end (CODESYS online help, "Assignment operator S=").
"""

from collections.abc import Sequence

from fbgen.lang import ast, checked
from fbgen.lang.checked import Constant, Expression, Place, Statement, VariableKind
from fbgen.lang.checker.arguments import Bound
from fbgen.lang.checker.coercion import coerce, spelled
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.enabling import enabled, speaks_of_enable
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.literals import ERRONEOUS, NULL
from fbgen.lang.checker.members import Receiver, find_setter, made_call
from fbgen.lang.checker.objects import Method
from fbgen.lang.checker.operators import combine
from fbgen.lang.checker.references import bind_reference
from fbgen.lang.checker.targets import check_target
from fbgen.lang.checker.variants import assignment_attempt
from fbgen.lang.types import BOOL, VARIANT_VALUE, BlockType, OpenArrayType
from fbgen.source import Span

_WHERE = "this assignment"
_UNKNOWN = ("?=",)
_BITS = {"S=": True, "R=": False}


class _Link:
    """One target of a statement; `place` None if it may not be written."""

    __slots__ = ("operator", "place", "span")

    def __init__(self, span: Span, place: Place | None, operator: str) -> None:
        self.span = span
        self.place = place
        self.operator = operator


def check_assignment(ctx: Context, node: ast.Assignment) -> Sequence[Statement]:
    """An assignment with all its targets."""
    if node.operator == "REF=":
        return bind_reference(ctx, node)
    if node.operator == "?=" and not isinstance(node.value, ast.Chained):
        return assignment_attempt(ctx, node)
    rest = node.value
    while isinstance(rest, ast.Chained | ast.Parenthesized):
        rest = rest.inner if isinstance(rest, ast.Parenthesized) else rest.value
    if isinstance(rest, ast.Call) and speaks_of_enable(rest):
        return enabled(ctx, node.span, rest, lambda call: _assignment(ctx, node, call))
    return _assignment(ctx, node, None)


def _assignment(ctx: Context, node: ast.Assignment, call: ast.Call | None) -> Sequence[Statement]:
    """`call` takes the place of the value, if it is one with EN or ENO."""
    setter = find_setter(ctx, node.target) if ctx.library.has_members else None
    if setter is not None:
        return _set_property(ctx, node, *setter, call or node.value)
    links = [_Link(node.span, check_target(ctx, node.target, _WHERE), node.operator)]
    rest = node.value
    while isinstance(rest, ast.Chained):
        links.append(_Link(rest.span, check_target(ctx, rest.target, _WHERE), rest.operator))
        rest = rest.value
    innermost = links[-1].place
    value = check_expression(ctx, call or rest, innermost.type if innermost is not None else None)
    if value.type == ERRONEOUS or any(link.place is None for link in links):
        return ()
    found = _written(ctx, links, value)
    return () if found is None else found


def _set_property(
    ctx: Context,
    node: ast.Assignment,
    receiver: Receiver,
    setter: Method,
    written: ast.Expression,
) -> Sequence[Statement]:
    """An assignment that calls SET."""
    variable = next(one for one in setter.block.variables if one.kind is VariableKind.INPUT)
    value = check_expression(ctx, written, variable.type)
    if node.operator != ":=" and value.type != ERRONEOUS:
        value = combine(
            ctx, node.span, node.operator[:-1], check_expression(ctx, node.target), value
        )
    value = coerce(ctx, value, variable.type, _WHERE)
    if value.type == ERRONEOUS:
        return ()
    call = made_call(ctx, node.span, receiver, setter, Bound(((variable, value),)))
    return (checked.Evaluate(node.span, call),)


def _written(ctx: Context, links: Sequence[_Link], value: Expression) -> list[Statement] | None:
    """The statements for some links, the last one first; None after reporting errors."""
    found: list[Statement] = []
    for number in range(len(links) - 1, -1, -1):
        link = links[number]
        place = link.place
        assert place is not None
        if link.operator in _BITS:
            rest = _set_or_reset(ctx, links[: number + 1], value)
            return None if rest is None else [*found, *rest]
        if isinstance(place.type, BlockType | OpenArrayType):
            ctx.findings.error(
                "FB4010",
                f"{spelled(place.type)} cannot be assigned",
                link.span,
                "assign the inputs that you want to change: inst.in := ..."
                if isinstance(place.type, BlockType)
                else "assign its elements one by one, in a loop",
            )
            return None
        if link.operator in _UNKNOWN:
            ctx.findings.error(
                "FB4054",
                f"the assignment {link.operator} in a chain is not supported",
                link.span,
                "write it as a statement of its own",
            )
            return None
        if place.type == VARIANT_VALUE and value.type not in (VARIANT_VALUE, NULL):
            ctx.findings.error(
                "FB4010",
                f"{_WHERE} takes VARIANT, not {spelled(value.type)}",
                link.span,
                "VariantPut(SRC := ..., DST := ...) writes to what a VARIANT refers to",
            )
            return None
        if link.operator != ":=":
            value = combine(ctx, link.span, link.operator[:-1], place, value)
        value = coerce(ctx, value, place.type, _WHERE)
        if value.type == ERRONEOUS:
            return None
        found.append(checked.Assignment(link.span, place, value))
        value = place
    return found


def _set_or_reset(
    ctx: Context, links: Sequence[_Link], value: Expression
) -> list[Statement] | None:
    """The last link is S= or R=: the value is asked once, everything left of it has it then."""
    link = links[-1]
    place = link.place
    assert place is not None
    value = coerce(ctx, value, BOOL, f"{link.operator}")
    if value.type == ERRONEOUS:
        return None
    if place.type != BOOL:
        ctx.findings.error(
            "FB4010",
            f"{link.operator} writes BOOL, not {spelled(place.type)}",
            link.span,
            "set and reset single bits: word.3 S= condition",
        )
        return None
    written = checked.Assignment(link.span, place, Constant(link.span, _BITS[link.operator], BOOL))
    holds = _written(ctx, links[:-1], Constant(value.span, True, BOOL))
    fails = _written(ctx, links[:-1], Constant(value.span, False, BOOL))
    if holds is None or fails is None:
        return None
    branch = checked.Branch(link.span, value, (written, *holds))
    return [checked.If(link.span, (branch,), tuple(fails))]
