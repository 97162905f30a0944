"""Structures and arrays that are declared apart and have the same parts: S7 copies them.

In TIA Portal the types of the parts must be the same in the same order, whatever the names of
types and parts, and arrays as long; in STEP 7 V5 the names of the parts and the bounds must be the
same too. Sources: TIA Portal help, "Transferring a tag of the PLC data type (UDT)" and
"Transferring tags of the ARRAY / ARRAY[*] data type"; S7-SCL V5.3 manual, "Value assignments with
variables of complex data types".
"""

from collections.abc import Iterator
from itertools import product

from fbgen.lang import checked
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
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.types import DINT, DTL, ArrayType, StructType, Type
from fbgen.source import Span

_MOST_PARTS = 2000


def is_copied_by_parts(ctx: Context, source: Type, target: Type) -> bool:
    """Whether these are two types with the same parts, of a dialect that copies them."""
    dialect = ctx.rules.dialect
    if dialect not in ("tia", "step7") or source == target:
        return False
    if not isinstance(source, StructType | ArrayType):
        return False
    return _have_same_parts(source, target, dialect == "step7")


def is_array_as_long(ctx: Context, one: Type, other: Type) -> bool:
    """Whether an input of TIA Portal takes an array with other bounds and the same elements."""
    if ctx.rules.dialect != "tia" or one == other:
        return False
    if not isinstance(one, ArrayType) or not isinstance(other, ArrayType):
        return False
    return one.element == other.element and _have_same_parts(one, other, exactly=False)


def _have_same_parts(one: Type, other: Type, exactly: bool) -> bool:
    if one == other:
        return True
    if isinstance(one, ArrayType) and isinstance(other, ArrayType):
        lengths = [[last - first for first, last in kind.bounds] for kind in (one, other)]
        alike = one.bounds == other.bounds if exactly else lengths[0] == lengths[1]
        return alike and _have_same_parts(one.element, other.element, exactly)
    if not isinstance(one, StructType) or not isinstance(other, StructType):
        return False
    if DTL in (one, other) or len(one.fields) != len(other.fields):
        return False
    if one.is_union or other.is_union:
        return False
    return all(
        _have_same_parts(mine.type, yours.type, exactly)
        and not (exactly and mine.name.casefold() != yours.name.casefold())
        for mine, yours in zip(one.fields, other.fields, strict=True)
    )


def copies(ctx: Context, span: Span, target: Place, value: Expression) -> list[Statement] | None:
    """The assignments that copy a value of another type with the same parts; None after errors.

    What has to be worked out on the way to a part is worked out once.
    """
    found: list[Statement] = []
    source: Place
    if isinstance(value, VariableRef | FieldRef | IndexRef) and _stays(value):
        source = value
    else:
        source = temporary(ctx, span, value.type)
        found.append(checked.Assignment(span, source, value))
    place = target if _stays(target) else temporary(ctx, span, target.type)
    for number, (to, part) in enumerate(_parts(place, source)):
        if number == _MOST_PARTS:
            cannot_run(ctx, span, f"a copy of more than {_MOST_PARTS} parts")
            return None
        found.append(checked.Assignment(span, to, part))
    if place is not target:
        found.append(checked.Assignment(span, target, place))
    return found


def temporary(ctx: Context, span: Span, kind: Type) -> VariableRef:
    """A new temporary of the block."""
    name = f"chained{len(ctx.temporaries) + 1}"
    variable = Variable(span, name, VariableKind.TEMP, kind)
    ctx.temporaries.append(variable)
    return VariableRef(span, variable, kind)


def _stays(expression: Expression) -> bool:
    """True for a place that is the same whatever is written meanwhile."""
    if isinstance(expression, FieldRef):
        return _stays(expression.base)
    if isinstance(expression, IndexRef):
        constant = all(isinstance(index, Constant) for index in expression.indices)
        return constant and _stays(expression.base)
    return isinstance(expression, VariableRef)


def _parts(target: Place, value: Place) -> Iterator[tuple[Place, Place]]:
    """What is assigned to what: parts of the same type, or arrays of such."""
    one, other = target.type, value.type
    if isinstance(one, StructType) and isinstance(other, StructType) and one != other:
        for mine, yours in zip(one.fields, other.fields, strict=True):
            yield from _parts(
                FieldRef(target.span, target, mine.name, mine.type),
                FieldRef(value.span, value, yours.name, yours.type),
            )
    elif isinstance(one, ArrayType) and isinstance(other, ArrayType) and one != other:
        elements = zip(_elements(target, one), _elements(value, other), strict=True)
        for to, element in elements:
            yield from _parts(to, element)
    else:
        yield target, value


def _elements(array: Place, kind: ArrayType) -> Iterator[Place]:
    for indices in product(*(range(first, last + 1) for first, last in kind.bounds)):
        constants = tuple(Constant(array.span, index, DINT) for index in indices)
        yield IndexRef(array.span, array, constants, kind.element)
