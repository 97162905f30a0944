"""References and pointers: what they point to, how they are made and bound.

REF_TO (TIA, IEC) and POINTER TO (CODESYS) are followed by `^`, REFERENCE TO (CODESYS) by itself and
bound by REF=. Only variables that outlive the call can be referred to: no temporaries, no inputs
or outputs of a FUNCTION, no bits, no absolute addresses.
Sources: IEC 61131-3 third edition, 6.4.4.10 and table 12; TIA Portal help, "References (REF_TO)";
CODESYS help, "Pointers", "References", "__ISVALIDREF".
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from fbgen.lang import ast, checked
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    AddressRef,
    Dereference,
    Expression,
    FieldRef,
    IndexRef,
    Place,
    ReferenceTo,
    SliceRef,
    Statement,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.calls.arguments import only_argument
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression, check_itself
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.checker.operands.pointers import has_addresses
from fbgen.lang.checker.operands.reference_comparison import compared, null
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.types.coercion import as_null, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous
from fbgen.lang.types import ReferenceType, Type
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library

MAKERS = {"REF": "REF_TO", "ADR": "POINTER TO"}
"""The functions that make a reference, and the kind that they make."""
IS_VALID = "__ISVALIDREF"


def reference_type(library: "Library", ctx: Context, node: ast.ReferenceSpec) -> ReferenceType:
    """The meaning of a written reference; its target is looked up later."""
    target = node.target
    if isinstance(target, ast.NamedType):
        found: list[Type] = []

        def find() -> Type:
            if not found:
                found.append(library.types.named(ctx, target.name, target.span, target.quoted).type)
            return found[0]

        library.types.settle_later(find)
        return ReferenceType(node.keyword, target.name, find)
    kind = library.types.resolve(ctx, target).type
    return ReferenceType(node.keyword, _name(kind), lambda: kind)


def _name(kind: Type) -> str:
    return kind.name


def check_dereference(ctx: Context, node: ast.Dereference, _expected: Type | None) -> Expression:
    """`base^`."""
    base = check_itself(ctx, node.base)
    if base.type == ERRONEOUS:
        return base
    if isinstance(base.type, ReferenceType) and base.type.is_implicit:
        followed_by_itself = check_expression(ctx, node.base)
        if isinstance(followed_by_itself.type, ReferenceType):
            base = followed_by_itself
    followed = isinstance(base.type, ReferenceType) and not base.type.is_interface
    if followed and not isinstance(base, Place) and has_addresses(ctx):
        return cannot_run(ctx, node.span, "a part of what a call gives")
    if not followed or not isinstance(base, Place):
        ctx.findings.error(
            "FB4092",
            f"{spelled(base.type)} is no reference and cannot be followed by ^",
            node.span,
            "remove the ^, or declare the variable as REF_TO or POINTER TO",
        )
        return erroneous(node.span)
    assert isinstance(base.type, ReferenceType)
    target = base.type.target
    return erroneous(node.span) if target == ERRONEOUS else Dereference(node.span, base, target)


def check_maker(ctx: Context, node: ast.Call, name: str) -> Expression:
    """REF(x) and ADR(x)."""
    argument = only_argument(ctx, node, name)
    if argument is None:
        return erroneous(node.span)
    return reference_to(ctx, node.span, argument, MAKERS[name])


def reference_to(ctx: Context, span: Span, node: ast.Expression, keyword: str) -> Expression:
    """A reference to a place; reports those that cannot be referred to."""
    place = _referable(ctx, span, node)
    if place is None:
        return erroneous(span)
    reason = _transient(ctx, place)
    if reason and has_addresses(ctx):
        return cannot_run(ctx, span, "a reference to " + reason.removesuffix(","))
    if reason:
        ctx.findings.error(
            "FB4093",
            f"{reason} cannot be referred to",
            node.span,
            "use a static or global variable, or an in-out",
        )
        return erroneous(span)
    kind = place.type
    return ReferenceTo(span, place, ReferenceType(keyword, _name(kind), lambda: kind))


def _referable(ctx: Context, span: Span, node: ast.Expression) -> Place | None:
    """The variable that is meant; None after saying why there is none."""
    if not has_addresses(ctx):
        return check_target(ctx, node, "this reference")
    place = check_expression(ctx, node)
    if place.type == ERRONEOUS:
        return None
    root: Expression = place
    while isinstance(root, FieldRef | IndexRef | SliceRef):
        root = root.base
    if not isinstance(place, Place) or (
        isinstance(root, VariableRef) and ctx.is_read_only(root.variable)
    ):
        cannot_run(ctx, span, "the address of what is no variable")
        return None
    if isinstance(root, VariableRef):
        ctx.written.add(root.variable)
    return place


def _transient(ctx: Context, place: Place) -> str:
    """What stands against a reference; "" if nothing."""
    root: Expression = place
    while isinstance(root, FieldRef | IndexRef):
        root = root.base
    if isinstance(root, SliceRef):
        return "a part of a variable's bits"
    if isinstance(root, AddressRef) or (
        isinstance(root, VariableRef) and root.variable.address is not None
    ):
        return "an absolute address"
    if not isinstance(root, VariableRef):
        return ""
    variable = root.variable
    copies = (VariableKind.INPUT, VariableKind.OUTPUT)
    is_function = ctx.block is not None and ctx.block.kind is BlockKind.FUNCTION
    if variable.kind in (VariableKind.TEMP, VariableKind.RESULT) or (
        is_function and variable.kind in copies
    ):
        return f"'{variable.name}', which is gone after the call,"
    return ""


def check_is_valid(ctx: Context, node: ast.Call) -> Expression:
    """__ISVALIDREF(r)."""
    argument = node.arguments[0].value if len(node.arguments) == 1 else None
    base = check_itself(ctx, argument) if argument is not None else erroneous(node.span)
    if argument is not None and base.type == ERRONEOUS:
        return base
    if not isinstance(base.type, ReferenceType):
        ctx.findings.error(
            "FB4092",
            f"{IS_VALID} takes a reference",
            node.span,
            "give a variable that is declared as REFERENCE TO",
        )
        return erroneous(node.span)
    return compared(node.span, "<>", base, null(node.span, base.type))


def bind_reference(ctx: Context, node: ast.Assignment) -> Sequence[Statement]:
    """`r REF= x`."""
    target = check_itself(ctx, node.target)
    kind = target.type
    if kind == ERRONEOUS or not isinstance(kind, ReferenceType) or not isinstance(target, Place):
        if kind != ERRONEOUS:
            ctx.findings.error(
                "FB4092",
                "REF= binds a reference",
                node.target.span,
                "declare the variable on its left as REFERENCE TO",
            )
        check_expression(ctx, node.value)
        return ()
    value = _bound(ctx, node.value, kind)
    if value.type not in (kind, ERRONEOUS):
        ctx.findings.error(
            "FB4010",
            f"this reference takes a variable of type {kind.target_name}",
            node.value.span,
            "give a variable of exactly that type",
        )
    if value.type != kind:
        return ()
    root: Expression = target
    while isinstance(root, FieldRef | IndexRef):
        root = root.base
    if isinstance(root, VariableRef):
        ctx.written.add(root.variable)
    return (checked.Assignment(node.span, target, value),)


def _bound(ctx: Context, node: ast.Expression, kind: ReferenceType) -> Expression:
    itself = check_itself(ctx, node)
    if itself.type in (kind, ERRONEOUS):
        return itself
    nothing = as_null(itself, kind)
    return nothing or reference_to(ctx, node.span, node, kind.keyword)
