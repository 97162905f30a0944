"""Outputs of a call that become another type on their way: `block(status => number)`.

The call gives such an output to a temporary, which a statement behind the call converts.
"""

from fbgen.lang.checked import Assignment, Place, Variable, VariableKind, VariableRef
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.types.coercion import converted, warn_unchecked
from fbgen.lang.checker.types.conversions import is_implicit, is_likely_unchecked
from fbgen.lang.types import Type
from fbgen.source import Span


def converted_output(ctx: Context, span: Span, source: Type, place: Place) -> Place | None:
    """The temporary; None if the place takes no such value, or there is no statement behind."""
    if ctx.copies is None:
        return None
    if not is_implicit(source, place.type, ctx.rules):
        if not ctx.rules.iec_check_open or not is_likely_unchecked(source, place.type, ctx.rules):
            return None
        warn_unchecked(ctx, span, source, place.type)
    return taken_back(ctx, span, source, place)


def taken_back(ctx: Context, span: Span, source: Type, place: Place) -> Place | None:
    """A temporary that takes a value, which goes from there to the place behind the statement."""
    if ctx.copies is None:
        return None
    variable = Variable(span, f"output{len(ctx.temporaries) + 1}", VariableKind.TEMP, source)
    ctx.temporaries.append(variable)
    given = VariableRef(span, variable, source)
    ctx.copies.append(Assignment(span, place, converted(given, place.type)))
    return given
