"""Comparing references: do they refer to the same variable, or to nothing?"""

from fbgen.lang.checked import Expression, ReferenceTo, SameReference, Unary
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.types.coercion import as_null
from fbgen.lang.checker.types.literals import NULL
from fbgen.lang.types import BOOL, ReferenceType, refers_to_anything
from fbgen.source import Span


def null(span: Span, kind: ReferenceType) -> ReferenceTo:
    """A reference to nothing."""
    return ReferenceTo(span, None, kind)


def compare(
    ctx: Context, span: Span, operator: str, left: Expression, right: Expression
) -> Expression | None:
    """Two references, or one and NULL, by = and <>; None for what does not go together."""
    if operator not in ("=", "<>"):
        return None
    if isinstance(left.type, ReferenceType) and left.type != NULL:
        same = right.type == left.type and not refers_to_anything(left.type)
        other = right if same else as_null(right, left.type)
        if other is None and left.type.is_interface:
            other = ctx.library.objects.interfaces.value_of(right, left.type)
        return None if other is None else compared(span, operator, left, other)
    if isinstance(right.type, ReferenceType) and right.type != NULL:
        return compare(ctx, span, operator, right, left)
    return None


def compared(span: Span, operator: str, left: Expression, right: Expression) -> Expression:
    """The comparison of two references of one type."""
    same = SameReference(span, left, right, BOOL)
    return same if operator == "=" else Unary(span, "NOT", same, BOOL)
