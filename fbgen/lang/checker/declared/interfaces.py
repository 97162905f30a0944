"""The variables of blocks: sections, constants, located and external variables, results.

Sources: IEC 61131-3 third edition, tables 13 to 16 and 19; TIA Portal help, "Block interface".
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Address, Variable, VariableKind
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.kept_in_outs import in_out_kind
from fbgen.lang.checker.declared.overlays import Home, check_overlay, overlay_kind
from fbgen.lang.checker.declared.type_names import type_of_anything
from fbgen.lang.checker.operands.places import address_of
from fbgen.lang.checker.symbols import NamedConstant, PendingSymbol
from fbgen.lang.checker.types.coercion import spelled
from fbgen.lang.checker.types.constants import constant_of, untyped_constant
from fbgen.lang.checker.types.literals import ERRONEOUS, default_value
from fbgen.lang.types import (
    ArrayInitial,
    BlockType,
    Elementary,
    OpenArrayType,
    Scalar,
    StringType,
    StructInitial,
    Type,
)
from fbgen.nearest import nearest

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library

_KINDS = {
    "VAR_INPUT": VariableKind.INPUT,
    "VAR_OUTPUT": VariableKind.OUTPUT,
    "VAR_IN_OUT": VariableKind.IN_OUT,
    "VAR_TEMP": VariableKind.TEMP,
    "VAR_GLOBAL": VariableKind.GLOBAL,
}
_WITH_CONSTANTS = ("VAR", "VAR_TEMP", "VAR_GLOBAL")
_KEEPING = (VariableKind.STATIC, VariableKind.GLOBAL, VariableKind.IN_OUT)
_WITHOUT_MEMORY = (BlockKind.FUNCTION, BlockKind.ORGANIZATION_BLOCK)


class Interfaces:
    """Declares the variables of sections in a scope."""

    def __init__(self, library: "Library") -> None:
        self._library = library

    def declare_constants(
        self, ctx: Context, sections: Sequence[ast.VarSection], block: BlockKind | None
    ) -> None:
        """Make the constants known, before any type that may use them; `block` None: global."""
        for section in sections:
            if _is_constant(section):
                for declaration in section.declarations:
                    self._constants(ctx, section, declaration, block)

    def declare(
        self,
        ctx: Context,
        sections: Sequence[ast.VarSection],
        block: BlockKind | None,
        header: tuple[ast.HeaderItem, ...] = (),
    ) -> list[Variable]:
        """All variables of the sections, in their order, then the constants that are variables.

        `header` is that of the block; it says whether variables can be overlaid.
        """
        variables: list[Variable] = []
        for section in sections:
            if _is_constant(section):
                continue
            for declaration in section.declarations:
                if section.keyword == "VAR_EXTERNAL":
                    self._externals(ctx, declaration)
                elif isinstance(declaration.at, ast.Name):
                    variables += self._overlays(
                        ctx, declaration, Home(block, header, "DB_SPECIFIC" in section.qualifiers)
                    )
                else:
                    variables += self._variables(ctx, section, declaration, block)
        for key, entry in list(ctx.scope.entries.items()):
            if isinstance(entry, PendingSymbol) and entry.is_constant:
                symbol = ctx.local(key)
                if isinstance(symbol, Variable):
                    variables.append(symbol)
        return variables

    # --- constants ----------------------------------------------------------------------------

    def _constants(
        self,
        ctx: Context,
        section: ast.VarSection,
        declaration: ast.Declaration,
        block: BlockKind | None,
    ) -> None:
        for declared in declaration.names:
            name = self._claimed(ctx, section, declared)
            if name is None:
                continue

            def evaluate(
                declared: ast.DeclaredName = declared, name: str = name
            ) -> NamedConstant | Variable:
                return self._constant(ctx, declaration, declared, name, block)

            ctx.scope.entries[name.casefold()] = PendingSymbol(
                declared.span, name, evaluate, is_constant=True
            )

    def _constant(
        self,
        ctx: Context,
        declaration: ast.Declaration,
        declared: ast.DeclaredName,
        name: str,
        block: BlockKind | None,
    ) -> NamedConstant | Variable:
        if isinstance(declaration.type, ast.NamedType) and not declaration.type.name:
            return self._classic_constant(ctx, declaration, declared)
        resolved = self._library.types.resolve(ctx, declaration.type)
        kind = resolved.type
        if declaration.initial is None and ctx.rules.dialect in ("tia", "twincat"):
            return self._empty_constant(declared, name, kind, block)
        if declaration.initial is None and kind != ERRONEOUS:
            ctx.findings.error(
                "FB4059",
                f"constant '{declared.name}' has no value",
                declared.span,
                f"give it one: {declared.name} : {kind.name} := ...;",
            )
            kind = ERRONEOUS
        if isinstance(kind, Elementary | StringType):
            value: Scalar | None = default_value(kind)
            if not isinstance(resolved.initial, ArrayInitial | StructInitial | None):
                value = resolved.initial
            if kind != ERRONEOUS and declaration.initial is not None:
                value = constant_of(
                    ctx, declaration.initial, kind, f"the value of constant '{declared.name}'"
                )
            if value is None:
                return NamedConstant(declared.span, declared.name, ERRONEOUS, 0)
            return NamedConstant(declared.span, declared.name, kind, value)
        assert declaration.initial is not None
        initial = self._library.initial(ctx, declaration.initial, kind, resolved.initial)
        return Variable(declared.span, name, _place_of(block), kind, initial)

    def _empty_constant(
        self, declared: ast.DeclaredName, name: str, kind: Type, block: BlockKind | None
    ) -> NamedConstant | Variable:
        """A constant without a value has the default of its type."""
        if kind == ERRONEOUS:
            return NamedConstant(declared.span, declared.name, ERRONEOUS, 0)
        if isinstance(kind, Elementary | StringType):
            return NamedConstant(declared.span, declared.name, kind, default_value(kind))
        return Variable(declared.span, name, _place_of(block), kind, None)

    def _classic_constant(
        self, ctx: Context, declaration: ast.Declaration, declared: ast.DeclaredName
    ) -> NamedConstant:
        """A constant of a CONST section: it stands for its value, a number without type too."""
        assert declaration.initial is not None
        where = f"the value of constant '{declared.name}'"
        value = untyped_constant(ctx, declaration.initial, where)
        if value is None:
            return NamedConstant(declared.span, declared.name, ERRONEOUS, 0)
        return NamedConstant(declared.span, declared.name, value.type, value.value)

    # --- variables ----------------------------------------------------------------------------

    def _variables(
        self,
        ctx: Context,
        section: ast.VarSection,
        declaration: ast.Declaration,
        block: BlockKind | None,
    ) -> list[Variable]:
        kind = self._kind(ctx, section, block)
        bound = kind is VariableKind.IN_OUT or (
            kind is VariableKind.INPUT and block is BlockKind.FUNCTION
        )
        if type_of_anything(self._library, declaration.type) and block is not None:
            bound = kind in (VariableKind.INPUT, VariableKind.IN_OUT, VariableKind.TEMP)
            # The reference is the value: what it refers to is changed either way.
            kind = VariableKind.INPUT if kind is VariableKind.IN_OUT else kind
        types = self._library.types
        resolve = types.parameter if bound else types.resolve
        resolved = resolve(ctx, declaration.type)
        initial = resolved.initial
        if kind is VariableKind.IN_OUT and "CONSTANT" in section.qualifiers:
            # It cannot be written, so a copy of a value is as good as the variable.
            is_value = not isinstance(resolved.type, BlockType | OpenArrayType)
            kind = VariableKind.INPUT if is_value else kind
        if kind is VariableKind.IN_OUT:
            kind = in_out_kind(self._library.rules.dialect, block, resolved.type)
        if declaration.initial is not None and resolved.type != ERRONEOUS:
            ctx.not_run = None if block is None else []
            initial = self._library.initial(
                ctx, declaration.initial, resolved.type, resolved.initial
            )
            ctx.not_started += ctx.not_run or []
            ctx.not_run = None
        if isinstance(resolved.type, BlockType):
            self._check_instance(ctx, declaration, resolved.type, kind)
        address = self._address(ctx, declaration, resolved.type)
        if isinstance(resolved.type, BlockType) and not self._may_live(kind):
            ctx.findings.error(
                "FB4056",
                f"an instance of {resolved.type.name} cannot live in {section.keyword} here",
                declaration.span,
                "declare it in VAR of a FUNCTION_BLOCK or PROGRAM, hand it over by VAR_IN_OUT",
            )
        variables = []
        for declared in declaration.names:
            claimed = self._claimed(ctx, section, declared)
            if claimed is None:
                continue
            remanent = "RETAIN" in section.qualifiers
            shared = kind is VariableKind.GLOBAL and block is not None
            name = self._library.name_of_shared(declared.name) if shared else claimed
            variable = Variable(
                declared.span, name, kind, resolved.type, initial, remanent, address
            )
            self._library.starts.declare(variable, declaration)
            if _is_linked(declaration):
                self._library.linked.add(variable)
            ctx.scope.entries[claimed.casefold()] = variable
            if shared:
                self._library.globals.entries[name.casefold()] = variable
            else:
                variables.append(variable)
        return variables

    def _overlays(
        self,
        ctx: Context,
        declaration: ast.Declaration,
        home: Home,
    ) -> list[Variable]:
        kind = self._library.types.parameter(ctx, declaration.type).type
        root = check_overlay(ctx, declaration, kind, home)
        variables = []
        for declared in declaration.names:
            if not self._is_new(ctx, declared):
                continue
            where = VariableKind.TEMP
            if root is not None:
                where = overlay_kind(root, home.block not in _WITHOUT_MEMORY)
            variable = Variable(declared.span, declared.name, where, kind, overlay=root)
            ctx.scope.entries[declared.name.casefold()] = variable
            variables.append(variable)
            if root is not None:
                self._library.memory.overlay(variable, root)
        return variables

    def _check_instance(
        self, ctx: Context, declaration: ast.Declaration, kind: BlockType, where: VariableKind
    ) -> None:
        """What an instance must not be; what is handed over may be of a derived block."""
        if where is not VariableKind.IN_OUT and self._library.objects.is_abstract(kind):
            ctx.findings.error(
                "FB4089",
                f"{kind.name} is ABSTRACT and has no instances",
                declaration.type.span,
                "declare an instance of a block that extends it",
            )

    def _may_live(self, kind: VariableKind) -> bool:
        """Whether an instance can be such a variable; in CODESYS and TwinCAT it can be any."""
        return kind in _KEEPING or self._library.rules.dialect in ("iec", "twincat")

    def _kind(self, ctx: Context, section: ast.VarSection, block: BlockKind | None) -> VariableKind:
        if block is None:
            return VariableKind.GLOBAL
        parameter = section.keyword in ("VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT")
        if section.keyword == "VAR_GLOBAL" or (
            parameter and block is BlockKind.ORGANIZATION_BLOCK and section.keyword != "VAR_INPUT"
        ):
            ctx.findings.error(
                "FB4056",
                f"{section.keyword} does not belong into a {block.value}",
                section.span,
                "use VAR or VAR_TEMP"
                if parameter
                else "declare global variables in a CONFIGURATION or outside of the blocks",
            )
        if section.keyword == "VAR_STAT":
            return VariableKind.GLOBAL
        if section.keyword in _KINDS:
            return _KINDS[section.keyword]
        return VariableKind.TEMP if block in _WITHOUT_MEMORY else VariableKind.STATIC

    def _address(self, ctx: Context, declaration: ast.Declaration, kind: Type) -> Address | None:
        if not isinstance(declaration.at, ast.DirectAddress) or declaration.at.byte < 0:
            return None  # `%I*` is placed where the project links it
        address = address_of(ctx, declaration.at)
        if address is None or kind == ERRONEOUS:
            return None
        if not isinstance(kind, Elementary) or kind.bits != address.bits:
            ctx.findings.error(
                "FB4070",
                f"{spelled(kind)} does not lie on an address of {address.bits} bits",
                declaration.span,
                "use %IX for BOOL, %IB for 8, %IW for 16 and %ID for 32 bits",
            )
            return None
        if len(declaration.names) > 1:
            ctx.findings.error(
                "FB4070",
                "several variables share one address",
                declaration.span,
                "declare each with its own address",
            )
        return address

    def _externals(self, ctx: Context, declaration: ast.Declaration) -> None:
        """Global variables are looked up later, when all of them are declared."""
        for declared in declaration.names:
            if not self._is_new(ctx, declared):
                continue

            def find(declared: ast.DeclaredName = declared) -> NamedConstant | Variable:
                return self._external(ctx, declaration, declared)

            ctx.scope.entries[declared.name.casefold()] = PendingSymbol(
                declared.span, declared.name, find, is_constant=False
            )

    def _external(
        self, ctx: Context, declaration: ast.Declaration, declared: ast.DeclaredName
    ) -> NamedConstant | Variable:
        kind = self._library.types.resolve(ctx, declaration.type).type
        symbol = ctx.of_program(declared.name.casefold())
        if symbol is None:
            ctx.findings.error(
                "FB4001",
                f"there is no global variable '{declared.name}'",
                declared.span,
                nearest(declared.name, self._library.globals.names()),
            )
            return NamedConstant(declared.span, declared.name, ERRONEOUS, 0)
        if symbol.type != kind and ERRONEOUS not in (symbol.type, kind):
            ctx.findings.error(
                "FB4010",
                f"'{declared.name}' is declared as {spelled(kind)} here and as"
                f" {spelled(symbol.type)} in VAR_GLOBAL",
                declared.span,
                "write the type of VAR_GLOBAL",
            )
        return symbol

    def _claimed(
        self, ctx: Context, section: ast.VarSection, declared: ast.DeclaredName
    ) -> str | None:
        """The name that a new variable has in its scope; None if it is declared twice.

        Two lists of global variables may have the same name: one of them has that of the list
        in front then.
        """
        lists = self._library.lists
        list_name = lists.list_of(section)
        if not list_name:
            return declared.name if self._is_new(ctx, declared) else None
        earlier = ctx.scope.entries.get(declared.name.casefold())
        name = lists.place(list_name, declared.name, earlier is not None)
        if name is None:
            key = lists.key_of(list_name, declared.name)
            first = ctx.scope.entries[key or ""]
            self._library.duplicate(declared.name, declared.span, first.span)
        return name

    def _is_new(self, ctx: Context, declared: ast.DeclaredName) -> bool:
        earlier = ctx.scope.entries.get(declared.name.casefold())
        if earlier is None:
            return True
        self._library.duplicate(declared.name, declared.span, earlier.span)
        return False


def _is_linked(declaration: ast.Declaration) -> bool:
    """True for a variable at an address, and for one with an attribute: tools read and write it."""
    return isinstance(declaration.at, ast.DirectAddress) or any(
        one.kind is ast.TriviaKind.PRAGMA and "attribute" in one.text.casefold()
        for one in declaration.leading
    )


def _is_constant(section: ast.VarSection) -> bool:
    return section.keyword == "CONST" or (
        "CONSTANT" in section.qualifiers and section.keyword in _WITH_CONSTANTS
    )


def _place_of(block: BlockKind | None) -> VariableKind:
    """Where a constant that is kept as a variable has its place."""
    if block is None:
        return VariableKind.GLOBAL
    return VariableKind.TEMP if block in _WITHOUT_MEMORY else VariableKind.STATIC
