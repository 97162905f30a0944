"""Calls of methods and actions, reading and writing of properties, THIS and SUPER.

Sources: IEC 61131-3 third edition, sections 6.6.5.4 and 6.6.5.5; CODESYS online help, "THIS",
"SUPER" and "Object PROPERTY".
"""

from fbgen.dataclass import dataclass
from fbgen.lang import ast
from fbgen.lang.checked import (
    Block,
    Constant,
    Dereference,
    Expression,
    FieldRef,
    FunctionCall,
    IndexRef,
    Place,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.calls.arguments import Bound
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.objects import Members, Method
from fbgen.lang.checker.declared.variable_access import Guarded, access_word, check_who
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.name_lookup import names_list
from fbgen.lang.checker.symbols import NamedConstant
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import VOID, BlockType
from fbgen.source import Span


@dataclass(frozen=True, slots=True)
class Receiver:
    """The instance that is asked. `block` is what is known of it; `is_super`: only that counts."""

    place: Place
    block: Block
    is_super: bool = False


def this_place(ctx: Context, span: Span) -> VariableRef | None:
    """The instance whose body or method this is."""
    return None if ctx.this is None else VariableRef(span, ctx.this, ctx.this.type)


def special_receiver(ctx: Context, node: ast.Expression) -> Receiver | None:
    """THIS and SUPER, with `^` or without; None for anything else."""
    name = node.base if isinstance(node, ast.Dereference) else node
    if not isinstance(name, ast.Name) or name.quoted:
        return None
    word = name.name.upper()
    if word not in ("THIS", "SUPER"):
        return None
    place = this_place(ctx, node.span)
    if place is None or ctx.owner is None:
        return None
    if word == "THIS":
        return Receiver(place, ctx.owner)
    base = ctx.library.objects.base_of(ctx.owner)
    if base is None and ctx.library.objects.is_partial(ctx.owner):
        return None
    if base is None:
        ctx.findings.error(
            "FB4087",
            f"{ctx.owner.name} extends no block: there is no SUPER",
            node.span,
            f"write FUNCTION_BLOCK {ctx.owner.name} EXTENDS ..., or THIS^",
        )
        return None
    return Receiver(place, base, is_super=True)


def receiver_of(ctx: Context, node: ast.Expression) -> Receiver | None:
    """The instance that an expression means, if its block is one of the user's."""
    special = special_receiver(ctx, node)
    if special is not None:
        return special
    place = check_expression(ctx, node)
    promised = ctx.library.objects.interfaces.asked(place)
    if promised is not None:
        return Receiver(*promised)
    if not isinstance(place.type, BlockType):
        return None
    block = ctx.library.user_block(place.type.name)
    if block is None or not isinstance(place, VariableRef | FieldRef | IndexRef | Dereference):
        return None
    return Receiver(place, block)


def own_receiver(ctx: Context, span: Span) -> Receiver | None:
    """The instance itself, where a member is named without it."""
    place = this_place(ctx, span)
    if place is None or ctx.owner is None:
        return None
    return Receiver(place, ctx.owner)


def asked(ctx: Context, node: ast.Expression) -> tuple[Receiver, Members, str] | None:
    """Whom `name` or `base.name` asks for what; None if that can be no member."""
    if isinstance(node, ast.Name):
        if node.local or node.quoted or ctx.owner is None:
            return None
        receiver = own_receiver(ctx, node.span)
        name = node.name
    elif isinstance(node, ast.Member):
        if not ctx.library.objects.are_used or names_list(ctx, node.base):
            return None
        receiver = receiver_of(ctx, node.base)
        name = node.name
    else:
        return None
    if receiver is None:
        return None
    return receiver, ctx.library.objects.members_of(receiver.block), name.casefold()


def check_access(ctx: Context, span: Span, method: Method) -> None:
    """Report a method that is not there for everybody."""
    word = access_word(method.modifiers)
    check_who(ctx, span, Guarded(method.name, word, method.owner, method.span))


def made_call(
    ctx: Context, span: Span, receiver: Receiver, method: Method, given: Bound
) -> FunctionCall:
    """The call of a method, whatever the instance turns out to be."""
    block = method.block
    if receiver.is_super and method.is_abstract:
        ctx.findings.error(
            "FB4086",
            f"'{method.name}' of {method.owner.name} is ABSTRACT and cannot be called by SUPER",
            span,
            "leave the call out: there is nothing to be done in the base",
        )
    overrides = () if receiver.is_super else ctx.library.objects.implementations(method)
    if not ctx.library.objects.is_promise(block):
        # Behind an interface may be another instance of the same block: that is no recursion.
        for called in (block, *(one for _, one in overrides)):
            ctx.calls.setdefault(called, span)
    kind = block.result.type if block.result is not None else VOID
    this = (block.variables[0], receiver.place)
    in_outs = (this, *given.in_outs)
    return FunctionCall(span, block, given.inputs, in_outs, given.outputs, kind, overrides)


def read_property(ctx: Context, node: ast.Name | ast.Member) -> Expression | None:
    """The call of GET that a name means; None if it means something else."""
    found = asked(ctx, node)
    if found is None:
        return None
    receiver, members, key = found
    getter = members.getters.get(key)
    if getter is None:
        return None
    check_access(ctx, node.span, getter)
    return made_call(ctx, node.span, receiver, getter, Bound())


def read_special(ctx: Context, node: ast.Member) -> Expression | None:
    """`THIS^.Speed`: a property of the instance itself; None for anything else."""
    return read_property(ctx, node) if special_receiver(ctx, node.base) is not None else None


def find_setter(ctx: Context, node: ast.Expression) -> tuple[Receiver, Method] | None:
    """The SET that an assignment to this target calls; None for anything but a property."""
    if not isinstance(node, ast.Name | ast.Member):
        return None
    if isinstance(node, ast.Name) and ctx.local(node.name.casefold()) is not None:
        return None
    found = asked(ctx, node)
    if found is None:
        return None
    receiver, members, key = found
    setter = members.setters.get(key)
    if setter is None:
        return None
    check_access(ctx, node.span, setter)
    return receiver, setter


def of_owner(ctx: Context, node: ast.Name) -> Expression | None:
    """A variable or constant of its block, named in a method; None if the block has none."""
    symbol = ctx.of_owner(node.name.casefold())
    place = this_place(ctx, node.span)
    if symbol is None or ctx.owner is None or place is None:
        return None
    around = ctx.library.context_of(ctx.owner)
    around.used.add(symbol)
    ctx.library.access.check(ctx, node.span, symbol)
    if isinstance(symbol, NamedConstant):
        return Constant(node.span, symbol.value, symbol.type)
    if symbol.kind is VariableKind.GLOBAL:
        return VariableRef(node.span, symbol, symbol.type)
    if symbol.kind in (VariableKind.TEMP, VariableKind.RESULT):
        ctx.findings.error(
            "FB4058",
            f"temporary '{symbol.name}' of {ctx.owner.name} is not there in its methods",
            node.span,
            "hand it over as an input of the method, or declare it in VAR",
        )
        return VariableRef(node.span, symbol, ERRONEOUS)
    around.written.add(symbol)
    return FieldRef(node.span, place, symbol.name, symbol.type)


def called_member(ctx: Context, node: ast.Call) -> tuple[Receiver, Method | Block] | None:
    """The method or action that is called, or the body behind SUPER; None for other calls."""
    callee = node.callee
    if not ctx.library.has_members:
        return None
    special = special_receiver(ctx, callee)
    if special is not None:
        return special, special.block
    if isinstance(callee, ast.Name):
        symbol = ctx.local(callee.name.casefold())
        if isinstance(symbol, Variable) and symbol.kind is not VariableKind.RESULT:
            return None
    found = asked(ctx, callee)
    if found is None:
        return None
    receiver, members, key = found
    method = members.methods.get(key)
    if method is not None:
        check_access(ctx, node.span, method)
        return receiver, method
    action = members.actions.get(key)
    return None if action is None else (receiver, action)


def own_variable(ctx: Context, node: ast.Member) -> Expression | None:
    """`THIS^.x`: a variable of the instance; None for anything else."""
    receiver = special_receiver(ctx, node.base)
    if receiver is None:
        return None
    key = node.name.casefold()
    for variable in ctx.library.objects.inherited(receiver.block):
        if variable.name.casefold() == key:
            around = ctx.library.context_of(ctx.owner or receiver.block)
            around.used.add(variable)
            ctx.library.access.check(ctx, node.span, variable)
            if ctx.block is not None and ctx.block.kind is ast.BlockKind.FUNCTION:
                return FieldRef(node.span, receiver.place, variable.name, variable.type)
            return VariableRef(node.span, variable, variable.type)
    return None
