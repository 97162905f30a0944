"""Pointers as CODESYS and TwinCAT have them: addresses of bytes, under any type.

`p^` and a comparison of two pointers of one type run. What takes a pointer for a number is
right and cannot run here, because a reference refers to a variable and not to bytes.
Sources: CODESYS help, "Pointers", "ADR", "SIZEOF"; TwinCAT 3 help, "MEMCPY", "MEMSET", "MEMMOVE",
"MEMCMP".
"""

from fbgen.diagnostics import DiagnosticError
from fbgen.lang import ast
from fbgen.lang.checked import Constant, Expression, Place, ReferenceTo
from fbgen.lang.checker.calls.arguments import only_argument
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression, check_itself
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.checker.types.literals import ERRONEOUS, NULL, UNTYPED_INTEGER, erroneous
from fbgen.lang.layout import PC_SIZES
from fbgen.lang.types import BlockType, Elementary, ReferenceType, Type

SIZES = ("SIZEOF", "XSIZEOF")
RAW_MEMORY = ("MEMCPY", "MEMSET", "MEMMOVE", "MEMCMP")
_DIALECTS = ("iec", "twincat")
_NUMBER = "a pointer as a number"
_POINTER_BYTES = 8


def has_addresses(ctx: Context) -> bool:
    """True in the dialects whose pointers are addresses."""
    return ctx.rules.dialect in _DIALECTS


def is_pointer(kind: Type) -> bool:
    """True for POINTER TO."""
    return isinstance(kind, ReferenceType) and kind.keyword == "POINTER TO"


def as_pointer(ctx: Context, expression: Expression, target: Type) -> Expression | None:
    """What becomes a pointer, or a number of one, by itself; None for anything else."""
    source = expression.type
    if not has_addresses(ctx):
        return None
    if isinstance(target, ReferenceType) and target.is_implicit and isinstance(expression, Place):
        return _as_reference(ctx, expression, target)
    if is_pointer(target):
        assert isinstance(target, ReferenceType)
        if isinstance(source, BlockType) and isinstance(expression, Place) and _is_this(expression):
            if source == target.target:
                return ReferenceTo(expression.span, expression, target)
            return cannot_run(ctx, expression.span, "a pointer to a block as one to another type")
        if is_pointer(source):
            return cannot_run(ctx, expression.span, "a pointer as one to another type")
        if isinstance(source, Elementary) and _counts(source):
            return cannot_run(ctx, expression.span, "a number as a pointer")
    elif is_pointer(source) and isinstance(target, Elementary) and _counts(target):
        return cannot_run(ctx, expression.span, _NUMBER)
    return None


def _as_reference(ctx: Context, place: Place, target: ReferenceType) -> Expression | None:
    """A variable that is handed over as REFERENCE TO; a derived block stands for its base."""
    if place.type == target.target:
        return ReferenceTo(place.span, place, target)
    if isinstance(place.type, BlockType) and isinstance(target.target, BlockType):
        objects = ctx.library.objects
        block = ctx.library.user_block(place.type.name)
        base = ctx.library.user_block(target.target.name)
        if block is not None and base is not None and objects.is_kind_of(block, base):
            return cannot_run(ctx, place.span, "a reference to a block as one to its base")
    return None


def calculated(ctx: Context, left: Expression, right: Expression) -> Expression | None:
    """`p + 4`, `p > q` and the like; None if no pointer is in it."""
    if not has_addresses(ctx) or not (is_pointer(left.type) or is_pointer(right.type)):
        return None
    other = right if is_pointer(left.type) else left
    if is_pointer(other.type) or other.type == NULL or _counts(other.type):
        return cannot_run(ctx, left.span, _NUMBER)
    return None


def _counts(kind: Type) -> bool:
    is_bits = isinstance(kind, Elementary) and kind.family.name == "BITS"
    return kind == UNTYPED_INTEGER or (isinstance(kind, Elementary) and kind.is_integer) or is_bits


def _is_this(expression: Expression) -> bool:
    return expression.span.text.upper() == "THIS"


def check_size(ctx: Context, node: ast.Call, name: str) -> Expression:
    """SIZEOF of a variable or a type, in bytes."""
    argument = only_argument(ctx, node, name)
    if argument is None:
        return erroneous(node.span)
    kind = _kind_of(ctx, argument)
    if kind == ERRONEOUS:
        return erroneous(node.span)
    if isinstance(kind, ReferenceType):
        return Constant(node.span, _POINTER_BYTES, UNTYPED_INTEGER)
    try:
        return Constant(node.span, PC_SIZES.size_bytes(kind), UNTYPED_INTEGER)
    except DiagnosticError:
        return cannot_run(ctx, node.span, f"{name} of {kind.name}")


def _kind_of(ctx: Context, node: ast.Expression) -> Type:
    name = node.name if isinstance(node, ast.Name) else ""
    if name and ctx.library.types.is_known(name) and ctx.local(name.casefold()) is None:
        return ctx.library.types.named(ctx, name, node.span).type
    kind = check_itself(ctx, node).type
    if isinstance(kind, ReferenceType) and kind.is_implicit:
        return kind.target
    return kind


def check_raw_memory(ctx: Context, node: ast.Call, name: str) -> Expression:
    """MEMCPY and its kin: the arguments are looked at, and that is all."""
    for argument in node.arguments:
        if argument.value is not None:
            check_expression(ctx, argument.value)
    return cannot_run(ctx, node.span, name.upper())
