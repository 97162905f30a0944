"""What may be written: on the left of :=, behind =>, as an in-out and as a FOR variable."""

from fbgen.lang import ast
from fbgen.lang.checked import (
    IN_OUTS,
    AddressRef,
    Constant,
    Dereference,
    Expression,
    FieldRef,
    IndexRef,
    MemoryRef,
    Place,
    SliceRef,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.name_lookup import is_program
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import VARIANT_VALUE, BlockType


def check_target(ctx: Context, node: ast.Expression, where: str) -> Place | None:
    """A place that may be written; None after reporting why it may not."""
    place = check_expression(ctx, node)
    if place.type == ERRONEOUS:
        return None
    if isinstance(place, Constant):
        ctx.findings.error(
            "FB4020", f"{where} writes a constant", node.span, "declare it in VAR to change it"
        )
        return None
    if not isinstance(place, Place):
        ctx.findings.error(
            "FB4022",
            f"{where} writes a value that is no variable",
            node.span,
            "give a variable, or a part of one",
        )
        return None
    return place if _may_be_written(ctx, place, where) else None


def _may_be_written(ctx: Context, place: Place, where: str) -> bool:
    base: Expression = place
    while isinstance(base, FieldRef | IndexRef | SliceRef):
        inner = base.base
        if isinstance(base, FieldRef) and isinstance(inner.type, BlockType):
            if isinstance(inner, VariableRef) and inner.variable in ctx.library.receivers:
                own = _member(ctx, base, inner.type)
                return _variable_may_be_written(ctx, VariableRef(base.span, own, own.type), where)
            return _member_may_be_written(ctx, base, inner.type, where)
        base = inner
    if isinstance(base, Dereference):
        return True
    if isinstance(base, AddressRef):
        return _address_may_be_written(ctx, base, where)
    if isinstance(base, MemoryRef):
        return True
    assert isinstance(base, VariableRef)
    return _variable_may_be_written(ctx, base, where)


def _variable_may_be_written(ctx: Context, ref: VariableRef, where: str) -> bool:
    variable = ref.variable
    ctx.written.add(variable)
    if ctx.is_read_only(variable):
        ctx.findings.error(
            "FB4020",
            f"{where} writes the constant '{variable.name}'",
            ref.span,
            "declare it in VAR to change it",
        )
        return False
    if variable.kind is not VariableKind.INPUT or variable.type == VARIANT_VALUE:
        return True
    ctx.findings.warning(
        "FB4103",
        f"{where} changes the block's own input '{variable.name}'",
        ref.span,
        "copy it to a variable of the block and change that",
    )
    return True


def _member(ctx: Context, field: FieldRef, instance: BlockType) -> Variable:
    return next(one for one in ctx.library.variables_of(instance) if one.name == field.name)


def _member_may_be_written(ctx: Context, field: FieldRef, instance: BlockType, where: str) -> bool:
    variable = _member(ctx, field, instance)
    if variable.kind in (VariableKind.INPUT, *IN_OUTS):
        return True
    if ctx.library.access.word(variable):
        return True  # who may use it at all has been looked at with its name
    message = f"{where} writes {variable.kind.value} '{field.name}' of {instance.name} from outside"
    help_text = "let the block write it, and give it what it needs as an input"
    if ctx.rules.statics_visible or is_program(ctx, instance):
        ctx.findings.warning("FB4106", message, field.span, help_text)
        return True
    ctx.findings.error("FB4023", message, field.span, help_text)
    return False


def _address_may_be_written(ctx: Context, ref: AddressRef, where: str) -> bool:
    address = ref.address
    if address.area != "I" or not address.peripheral:
        return True
    ctx.findings.error(
        "FB4023",
        f"{where} writes an input of the periphery",
        ref.span,
        "outputs are written by %Q; inputs come from outside",
    )
    return False
