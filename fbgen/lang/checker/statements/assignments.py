"""Assignments, also several in one statement, and set and reset.

`a := b := c` gives c to b, then what b has got to a, from right to left with the conversions of
each step; c is read once, b is not read again (TIA Portal help, "Value assignments"; CODESYS online
help, "Assignment as an expression"). `S=` and `R=` write only where their value is TRUE; what
stands left of one in a chain takes the value at its right end (CODESYS online help, "Assignment
operator S=").
"""

from collections.abc import Sequence

from fbgen.lang import ast, checked
from fbgen.lang.checked import (
    Constant,
    Expression,
    FieldRef,
    IndexRef,
    Place,
    Statement,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.calls.arguments import Bound
from fbgen.lang.checker.calls.enabling import enabled, speaks_of_enable
from fbgen.lang.checker.calls.members import Receiver, find_setter, made_call
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.objects import Method
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.checker.operands.operators import combine
from fbgen.lang.checker.operands.pointers import has_addresses
from fbgen.lang.checker.operands.references import bind_reference
from fbgen.lang.checker.operands.variants import assignment_attempt
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.supplied.memory_instructions import check_pointer_constant, points
from fbgen.lang.checker.types.coercion import ASSIGNMENT, coerce, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.checker.types.same_structure import copies, is_copied_by_parts, temporary
from fbgen.lang.types import (
    BOOL,
    VARIANT_VALUE,
    BlockType,
    OpenArrayType,
    Type,
    is_area_pointer,
    refers_to_anything,
)
from fbgen.source import Span

_UNKNOWN = ("?=",)
_BITS = {"S=": True, "R=": False}


class _Link:
    """One target of a statement: a place or a property; neither if it may not be written."""

    __slots__ = ("node", "operator", "place", "setter", "span")

    def __init__(self, ctx: Context, node: ast.Assignment | ast.Chained) -> None:
        self.span = node.span
        self.node = node.target
        self.operator = node.operator
        self.setter = find_setter(ctx, node.target) if ctx.library.has_members else None
        self.place = None if self.setter else check_target(ctx, node.target, ASSIGNMENT)

    @property
    def type(self) -> Type | None:
        """What it takes; None after errors."""
        if self.setter is not None:
            return _input(self.setter[1]).type
        return None if self.place is None else self.place.type


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
    links = [_Link(ctx, node)]
    rest = node.value
    while isinstance(rest, ast.Chained):
        links.append(_Link(ctx, rest))
        rest = rest.value
    value = _value(ctx, call or rest, links[-1].type)
    if value.type == ERRONEOUS or any(link.type is None for link in links):
        return ()
    found = _written(ctx, links, value)
    return () if found is None else found


def _value(ctx: Context, node: ast.Expression, target: Type | None) -> Expression:
    if target is not None and is_area_pointer(target) and points(node):
        return check_pointer_constant(ctx, node, target, ASSIGNMENT)
    return check_expression(ctx, node, target)


def _input(setter: Method) -> Variable:
    """The parameter of SET."""
    return next(one for one in setter.block.variables if one.kind is VariableKind.INPUT)


def _written(ctx: Context, links: Sequence[_Link], value: Expression) -> list[Statement] | None:
    """The statements for some links, the last one first; None after reporting errors."""
    found: list[Statement] = []
    for number in range(len(links) - 1, -1, -1):
        link = links[number]
        if link.operator in _BITS:
            rest = _set_or_reset(ctx, links[: number + 1], value)
            return None if rest is None else [*found, *rest]
        if link.setter is not None:
            given = _given_to_property(ctx, link, _input(link.setter[1]), value)
            if given is None:
                return None
            if number > 0 and not isinstance(given, Constant):
                given = _kept(ctx, link.span, given, found)
            found.append(_set_property(ctx, link.span, *link.setter, given))
            value = given
            continue
        place = link.place
        assert place is not None
        if isinstance(place.type, BlockType) and value.type == place.type and has_addresses(ctx):
            cannot_run(ctx, link.span, "a copy of an instance")
            return None
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
            _refuse_unknown(ctx, link)
            return None
        if place.type == VARIANT_VALUE and not refers_to_anything(value.type):
            ctx.findings.error(
                "FB4010",
                f"{ASSIGNMENT} takes VARIANT, not {spelled(value.type)}",
                link.span,
                "VariantPut(SRC := ..., DST := ...) writes to what a VARIANT refers to",
            )
            return None
        if link.operator != ":=":
            value = combine(ctx, link.span, link.operator[:-1], place, value)
        if is_copied_by_parts(ctx, value.type, place.type):
            parts = copies(ctx, link.span, place, value)
            if parts is None:
                return None
            found += parts
            value = place
            continue
        value = coerce(ctx, value, place.type, ASSIGNMENT)
        if value.type == ERRONEOUS:
            return None
        if number and not (isinstance(value, Constant) or _reads_the_same(place)):
            value = _kept(ctx, link.span, value, found)
            found.append(checked.Assignment(link.span, place, value))
        else:
            found.append(checked.Assignment(link.span, place, value))
            value = value if isinstance(value, Constant) else place
    return found


def _reads_the_same(place: Place) -> bool:
    """True for what gives back the value that was just written, with nothing to be calculated."""
    if isinstance(place, VariableRef):
        return place.variable.address is None
    if isinstance(place, FieldRef):
        return _reads_the_same(place.base)
    if isinstance(place, IndexRef):
        constant = all(isinstance(index, Constant) for index in place.indices)
        return constant and _reads_the_same(place.base)
    return False


def _kept(ctx: Context, span: Span, value: Expression, found: list[Statement]) -> Expression:
    """The value in a temporary of its own."""
    place = temporary(ctx, span, value.type)
    found.append(checked.Assignment(span, place, value))
    return place


def _given_to_property(
    ctx: Context, link: _Link, variable: Variable, value: Expression
) -> Expression | None:
    """What SET gets; it goes on to the left, and GET is not asked. None after errors."""
    if link.operator in _UNKNOWN:
        _refuse_unknown(ctx, link)
        return None
    if link.operator != ":=":
        before = check_expression(ctx, link.node)
        value = combine(ctx, link.span, link.operator[:-1], before, value)
    value = coerce(ctx, value, variable.type, ASSIGNMENT)
    return None if value.type == ERRONEOUS else value


def _set_property(
    ctx: Context, span: Span, receiver: Receiver, setter: Method, value: Expression
) -> Statement:
    """A call of SET."""
    call = made_call(ctx, span, receiver, setter, Bound(((_input(setter), value),)))
    return checked.Evaluate(span, call)


def _refuse_unknown(ctx: Context, link: _Link) -> None:
    ctx.findings.error(
        "FB4054",
        f"the assignment {link.operator} in a chain is not supported",
        link.span,
        "write it as a statement of its own",
    )


def _set_or_reset(
    ctx: Context, links: Sequence[_Link], value: Expression
) -> list[Statement] | None:
    """The last link is S= or R=: the value is asked once, everything left of it has it then."""
    link = links[-1]
    place = link.place
    value = coerce(ctx, value, BOOL, f"{link.operator}")
    if value.type == ERRONEOUS:
        return None
    if place is None or place.type != BOOL:
        what = "a property" if place is None else spelled(place.type)
        ctx.findings.error(
            "FB4010",
            f"{link.operator} writes a variable of type BOOL, not {what}",
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
