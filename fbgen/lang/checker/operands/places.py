"""Names, members, indices, slices and absolute addresses: what can be read and written."""

import re

from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    IN_OUTS,
    Address,
    AddressRef,
    Constant,
    Expression,
    FieldRef,
    IndexRef,
    Place,
    ReferenceTo,
    SliceRef,
    StandardBlock,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.calls.members import of_owner, own_variable, read_property, read_special
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.enumerations import (
    bare_enumerator,
    enumeration_named,
    enumerator_value,
)
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.checker.operands.block_members import addressed_member
from fbgen.lang.checker.operands.characters import character, has_characters
from fbgen.lang.checker.operands.elsewhere import value_help
from fbgen.lang.checker.operands.foreign_names import library_help
from fbgen.lang.checker.operands.name_lookup import (
    find_symbol,
    is_program,
    listed,
    may_be_inherited,
    names_list,
    without_library,
)
from fbgen.lang.checker.operands.pointers import has_addresses, is_pointer
from fbgen.lang.checker.supplied.standard_blocks import parameter_name, standard_block
from fbgen.lang.checker.symbols import NamedConstant, Symbol
from fbgen.lang.checker.types.coercion import as_counted, as_typed, converted, spelled
from fbgen.lang.checker.types.conversions import UNSIGNED_OF
from fbgen.lang.checker.types.literals import ERRONEOUS, NULL, erroneous
from fbgen.lang.types import (
    BOOL,
    BYTE,
    DWORD,
    LWORD,
    WORD,
    ArrayType,
    BlockType,
    Elementary,
    Enumeration,
    Family,
    OpenArrayType,
    ReferenceType,
    StringType,
    StructType,
    Subrange,
    Type,
)
from fbgen.nearest import nearest
from fbgen.source import Span

_SIZES = {"X": BOOL, "B": BYTE, "W": WORD, "D": DWORD, "L": LWORD}
_PARAMETERS = (VariableKind.INPUT, VariableKind.OUTPUT, *IN_OUTS)
_BARE_SLICE = re.compile(r"[XBWD][0-9]{1,2}", re.IGNORECASE)


def is_place(expression: Expression) -> bool:
    """True for what can stand on the left of an assignment."""
    return isinstance(expression, Place)


def root_variable(place: Expression) -> Variable | None:
    """The variable that a place is a part of; None for absolute addresses."""
    while isinstance(place, FieldRef | IndexRef | SliceRef):
        place = place.base
    return place.variable if isinstance(place, VariableRef) else None


def _is_null(ctx: Context, node: ast.Name) -> bool:
    """True for NULL, and for NIL of STEP 7."""
    name = node.name.upper()
    return not (node.local or node.quoted) and (
        name == "NULL" or (name == "NIL" and ctx.rules.dialect == "step7")
    )


def check_name(ctx: Context, node: ast.Name, expected: Type | None = None) -> Expression:
    """A variable, or the value of a named constant or enumerator."""
    symbol = find_symbol(ctx, node)
    if ctx.owner is not None and not node.quoted and ctx.local(node.name.casefold()) is None:
        found = of_owner(ctx, node) or (read_property(ctx, node) if symbol is None else None)
        if found is not None:
            return found
    if symbol is None:
        enumerator = None if node.local else bare_enumerator(ctx, node, expected)
        if enumerator is not None:
            return enumerator
        if _is_null(ctx, node):
            return ReferenceTo(node.span, None, NULL)
        if node.name and not _is_known_as_erroneous(ctx, node):
            _unknown_name(ctx, node)
        return erroneous(node.span)
    if (
        isinstance(symbol, Variable)
        and symbol.kind is VariableKind.GLOBAL
        and ctx.rules.externals_required
        and ctx.block is not None
        and ctx.library.lists.is_of_configuration(symbol)
        and node.name.casefold() not in ctx.scope.entries
    ):
        ctx.findings.warning(
            "FB4104",
            f"global variable '{symbol.name}' is used without VAR_EXTERNAL",
            node.span,
            f"declare it in the block: VAR_EXTERNAL {symbol.name} : {symbol.type.name}; END_VAR",
        )
    return _meant(ctx, node, symbol)


def _meant(ctx: Context, node: ast.Name | ast.Member, symbol: Symbol) -> Expression:
    """What a symbol is in an expression."""
    ctx.used.add(symbol)
    ctx.library.access.check(ctx, node.span, symbol)
    if node.name != symbol.name.rpartition(".")[2]:
        ctx.respelled.setdefault(symbol, node.span)
    if isinstance(symbol, NamedConstant):
        return Constant(node.span, symbol.value, symbol.type)
    return VariableRef(node.span, symbol, symbol.type)


def _is_known_as_erroneous(ctx: Context, node: ast.Name) -> bool:
    return not node.quoted and node.name.casefold() in ctx.scope.entries


def _unknown_name(ctx: Context, node: ast.Name) -> None:
    if may_be_inherited(ctx):
        return
    block = ctx.library.block(node.name)
    if block is not None:
        if isinstance(block, StandardBlock) or block.kind is BlockKind.FUNCTION_BLOCK:
            help_text = f"declare an instance of it: inst : {node.name}; and use the instance"
        else:
            help_text = f"call it: {node.name}(...)"
        ctx.findings.error(
            "FB4047", f"'{node.name}' is a block, not a variable", node.span, help_text
        )
        return
    message = f"no variable or constant is called '{node.name}'"
    if node.quoted and not node.local:
        ctx.findings.unknown(
            "FB4001", message, node.span, lambda: _near_names(ctx, node), node.name
        )
    elif has_addresses(ctx) or (ctx.rules.dialect in ("tia", "step7") and not node.local):
        ctx.findings.unknown("FB4001", message, node.span, lambda: _near_names(ctx, node))
    else:
        ctx.findings.error("FB4001", message, node.span, _near_names(ctx, node))


def _near_names(ctx: Context, node: ast.Name) -> str:
    if node.quoted and not node.local:
        return value_help(node.name, ctx.library.globals.names())
    if ctx.rules.dialect == "step7" and not node.local:
        return value_help(node.name, ctx.scope.names() + ctx.library.globals.names())
    known = ctx.scope.names()
    if not node.local:
        known += ctx.library.globals.names()
    return (library_help if has_addresses(ctx) else nearest)(node.name, known)


def check_member(ctx: Context, node: ast.Member, _expected: Type | None = None) -> Expression:
    """A part of a structure, a variable of an instance, or a property of one."""
    if ctx.this is not None and (own := own_variable(ctx, node) or read_special(ctx, node)):
        return own
    if not _is_of_local(node):
        plain = without_library(ctx, node)
        if isinstance(plain, ast.Name):
            return check_name(ctx, plain)
        named = enumeration_named(ctx, node.base)
        if named is not None and not _is_variable(ctx, node.base):
            return enumerator_value(ctx, node.span, named, node.name)
        if names_list(ctx, node.base):
            return _of_list(ctx, node)
    base = check_expression(ctx, node.base)
    kind = base.type
    if kind == ERRONEOUS:
        return erroneous(node.span)
    if has_addresses(ctx) and not is_place(base) and not isinstance(kind, Elementary):
        return cannot_run(ctx, node.span, "a part of what a call gives")
    if isinstance(kind, StructType):
        field = kind.field(node.name)
        if field is not None and is_place(base):
            return FieldRef(node.span, as_place(base), field.name, field.type)
        known = [part.name for part in kind.fields]
    elif isinstance(kind, BlockType):
        found = _instance_variable(ctx, node, kind)
        if found is not None:
            return FieldRef(node.span, as_place(base), found.name, found.type)
        asked = read_property(ctx, node)
        if asked is not None:
            return asked
        known = [part.name for part in ctx.library.variables_of(kind) if part.kind in _PARAMETERS]
    elif (addressed := addressed_member(ctx, node, base)) is not None:
        return addressed
    elif isinstance(kind, ReferenceType) and kind.is_interface:
        asked = read_property(ctx, node)
        if asked is not None:
            return asked
        promised = ctx.library.objects.interfaces.asked(base)
        members = None if promised is None else ctx.library.objects.members_of(promised[1])
        known = [] if members is None else members.names()
    else:
        ctx.findings.error(
            "FB4005",
            f"{spelled(as_typed(base).type)} has no member '{node.name}'",
            node.span,
            _no_members(ctx, node.name),
        )
        return erroneous(node.span)
    if _is_partial(ctx, kind) or ctx.library.is_incomplete(kind):
        return erroneous(node.span)
    message = f"{kind.name} has no member '{node.name}'"
    if kind.name.casefold() in ctx.library.unmodelled and not ctx.library.is_stubbed(kind.name):
        message = f"'{node.name}' of {kind.name} has no model, so this program cannot run"
        ctx.findings.gap(message, node.span, "to run it, give the value as a parameter of the call")
    else:
        ctx.findings.error("FB4005", message, node.span, nearest(node.name, known))
    return erroneous(node.span)


def _no_members(ctx: Context, name: str) -> str:
    if ctx.rules.dialect in ("tia", "iec") and _BARE_SLICE.fullmatch(name):
        return f"a slice is written with '%': .%{name.upper()}"
    return "only structures and instances of function blocks have members"


def _is_partial(ctx: Context, kind: Type) -> bool:
    """True if the base of a structure or block is in no file."""
    if isinstance(kind, StructType):
        return ctx.library.types.is_partial(kind)
    return isinstance(kind, BlockType) and ctx.library.objects.is_partial(
        ctx.library.user_block(kind.name)
    )


def _is_of_local(node: ast.Expression) -> bool:
    """Whether it begins with `#`: then no name of a library, a type or a list is in front."""
    while isinstance(node, ast.Member):
        node = node.base
    return isinstance(node, ast.Name) and node.local


def _is_variable(ctx: Context, node: ast.Expression) -> bool:
    while isinstance(node, ast.Member):
        node = node.base
    return isinstance(node, ast.Name) and find_symbol(ctx, node) is not None


def _of_list(ctx: Context, node: ast.Member) -> Expression:
    """`GVL.x`."""
    symbol = listed(ctx, node)
    if symbol is not None:
        return _meant(ctx, node, symbol)
    assert isinstance(node.base, ast.Name)
    ctx.findings.error(
        "FB4005",
        f"the list {node.base.name} has no variable '{node.name}'",
        node.span,
        nearest(node.name, ctx.library.lists.names_in(node.base.name)),
    )
    return erroneous(node.span)


def _instance_variable(ctx: Context, node: ast.Member, kind: BlockType) -> Variable | None:
    key = node.name.casefold()
    if has_addresses(ctx) and standard_block(kind.name) is not None:
        key = parameter_name(kind.name, node.name).casefold()
    for variable in ctx.library.variables_of(kind):
        if variable.name.casefold() != key:
            continue
        if variable.kind in (VariableKind.INPUT, VariableKind.OUTPUT, VariableKind.KEPT):
            return variable
        if variable.kind is VariableKind.STATIC and (
            ctx.library.access.word(variable) or ctx.rules.statics_visible or is_program(ctx, kind)
        ):
            ctx.library.access.check(ctx, node.span, variable)
            return variable
        if variable.kind is not VariableKind.RESULT:
            ctx.findings.error(
                "FB4058",
                f"{variable.kind.value} '{variable.name}' of {kind.name} is not there from outside",
                node.span,
                "make it an output of the block, or ask the block's own outputs",
            )
            return variable
    return None


def as_place(expression: Expression) -> Place:
    """An expression that `is_place` as one."""
    assert isinstance(expression, Place)
    return expression


def check_index(ctx: Context, node: ast.Index, _expected: Type | None = None) -> Expression:
    """An element of an array; constant indices are compared with the bounds."""
    base = check_expression(ctx, node.base)
    if isinstance(base.type, StringType) and has_characters(base.type, node):
        return character(ctx, node, base.type)
    indices = [_index(ctx, one) for one in node.indices]
    kind = base.type
    if kind == ERRONEOUS or any(index.type == ERRONEOUS for index in indices):
        return erroneous(node.span)
    if is_pointer(kind) and has_addresses(ctx):
        return cannot_run(ctx, node.span, "an index of a pointer")
    if isinstance(kind, OpenArrayType):
        limits: tuple[tuple[int, int] | None, ...] = (None,) * kind.dimensions
    elif isinstance(kind, ArrayType) and is_place(base):
        limits = kind.bounds
    else:
        ctx.findings.error(
            "FB4019",
            f"{spelled(as_typed(base).type)} is not an array and takes no index",
            node.span,
            "remove the index, or declare the variable as ARRAY[...] OF ...",
        )
        return erroneous(node.span)
    if 0 < len(indices) < len(limits) and ctx.rules.dialect == "step7":
        return cannot_run(ctx, node.span, "a part of an array with several dimensions")
    if len(indices) != len(limits):
        ctx.findings.error(
            "FB4019",
            f"{kind.name} takes {len(limits)} indices, not {len(indices)}",
            node.span,
            "give one index for each dimension: a[i, j]",
        )
        return erroneous(node.span)
    for index, bounds in zip(indices, limits, strict=True):
        _check_one_index(ctx, index, bounds)
    return IndexRef(node.span, as_place(base), tuple(indices), kind.element)


def _index(ctx: Context, node: ast.Expression) -> Expression:
    index = as_counted(ctx, as_typed(check_expression(ctx, node)))
    if ctx.rules.bits_are_numbers and isinstance(index.type, Elementary):
        return converted(index, UNSIGNED_OF.get(index.type, index.type))
    return index


def _check_one_index(ctx: Context, index: Expression, bounds: tuple[int, int] | None) -> None:
    """`bounds` None: they are known when the program runs."""
    if not isinstance(index.type, Elementary) or not index.type.is_integer:
        ctx.findings.error(
            "FB4010",
            f"an array index is a whole number, not {spelled(index.type)}",
            index.span,
            "use a variable of type INT or DINT, or convert it",
        )
        return
    if bounds is None or not isinstance(index, Constant):
        return
    first, last = bounds
    if not first <= int(index.value) <= last:
        ctx.findings.error(
            "FB4015",
            f"index {index.value} is outside of the array's {first}..{last}",
            index.span,
            f"use an index from {first} to {last}, or declare the array larger",
        )


def check_slice(ctx: Context, node: ast.Slice, _expected: Type | None = None) -> Expression:
    """A part of a bit string or integer; a part of a part is one of the whole."""
    base = check_expression(ctx, node.base)
    kind = base.type
    if kind == ERRONEOUS:
        return base
    part = _SIZES.get(node.size)
    countable = isinstance(kind, Elementary) and kind.family in (
        Family.BITS,
        Family.SIGNED,
        Family.UNSIGNED,
    )
    if isinstance(kind, Enumeration | Subrange):
        countable = False
    if part is None or not countable or not is_place(base):
        ctx.findings.error(
            "FB4018",
            f"{spelled(as_typed(base).type)} cannot be sliced here",
            node.span,
            "slices work on variables that are bit strings or integers",
        )
        return erroneous(node.span)
    assert isinstance(kind, Elementary)
    if (node.index + 1) * part.bits > kind.bits or node.index < 0:
        last = kind.bits // part.bits - 1
        help_text = (
            f"{kind.name} has %{node.size}0 to %{node.size}{last}"
            if last >= 0
            else f"{kind.name} is narrower than that"
        )
        ctx.findings.error(
            "FB4018", f"{kind.name} has no part %{node.size}{node.index}", node.span, help_text
        )
        return erroneous(node.span)
    if isinstance(base, SliceRef):
        index = base.index * (kind.bits // part.bits) + node.index
        return SliceRef(node.span, base.base, index, part)
    return SliceRef(node.span, as_place(base), node.index, part)


def report_no_value(ctx: Context, span: Span, area: str) -> None:
    """T5 and C3 stand only where an instruction takes a timer or counter."""
    what, how = "counter", "S_CU(C_NO := ..., Q => notZero, CV => count)"
    if area == "T":
        what, how = "timer", "S_ODT(T_NO := ..., Q => over, BI => rest)"
    ctx.findings.error(
        "FB4047",
        f"{span.text} is a {what}, and SCL has no value for it",
        span,
        f"take what you need from its call: {how}",
    )


def address_of(ctx: Context, node: ast.DirectAddress) -> Address | None:
    """The absolute address that is written; reports addresses that cannot be reached."""
    if node.size not in _SIZES:
        report_no_value(ctx, node.span, node.area)
        return None
    if node.area == "DB" and not _may_be_addressed(ctx, node):
        return None
    if node.size == "X" and not 0 <= node.bit <= 7:
        ctx.findings.error(
            "FB4070", f"a byte has no bit {node.bit}", node.span, "bits count from 0 to 7"
        )
        return None
    return Address(node.area, _SIZES[node.size].bits, node.byte, node.bit, node.db, node.peripheral)


def report_optimized(ctx: Context, span: Span, block: Variable) -> None:
    """FB4073: an absolute address in a data block that has none."""
    ctx.findings.error(
        "FB4073",
        f"'{block.name}' has optimized access, so nothing in it has an address",
        span,
        f"name the member, \"{block.name}\".member, or write S7_Optimized_Access := 'FALSE'",
    )


def _may_be_addressed(ctx: Context, node: ast.DirectAddress) -> bool:
    memory = ctx.library.memory
    memory.address(node.db)
    block = memory.block_with(node.db)
    if block is None or block not in memory.optimized:
        return True
    report_optimized(ctx, node.span, block)
    return False


def check_address(
    ctx: Context, node: ast.DirectAddress, _expected: Type | None = None
) -> Expression:
    """An absolute address, as a bit string of its width."""
    address = address_of(ctx, node)
    if address is None:
        return erroneous(node.span)
    return AddressRef(node.span, address, _SIZES[node.size])
