"""From a written type to the type it means."""

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Note
from fbgen.lang import ast
from fbgen.lang.checked import Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.enumerations import enumeration, subrange, typed_enumerator
from fbgen.lang.checker.declared.namespaces import namespace_help
from fbgen.lang.checker.operands.elsewhere import type_help
from fbgen.lang.checker.operands.foreign_names import is_library, library_help
from fbgen.lang.checker.operands.references import reference_type
from fbgen.lang.checker.types.codesys_types import codesys_type
from fbgen.lang.checker.types.constants import whole_number
from fbgen.lang.checker.types.identifier_types import HARDWARE_TYPES
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.checker.types.system_types import system_type
from fbgen.lang.dates import exists_in, of_dialect
from fbgen.lang.layout import holds_blocks, holds_values
from fbgen.lang.types import (
    ALIASES,
    ANY_VALUE,
    DTL,
    ELEMENTARY,
    NUMBER_TYPES,
    POINTER_VALUE,
    VARIANT_VALUE,
    VOID,
    ArrayInitial,
    ArrayType,
    Elementary,
    Enumeration,
    Field,
    Initial,
    OpenArrayType,
    ReferenceType,
    StringType,
    StructType,
    Type,
)
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library

CELL_LIMIT = 1 << 22
"""How many elementary values one variable may have: more than any CPU has memory for."""
_LONGEST_STRING = 16382
_TYPE_NESTING = 60


_OBJECT = re.compile(r"TO_\w+", re.IGNORECASE)
"""Technology objects: axes, cams, encoders (TIA Portal help, "Motion control")."""
_OBJECT_HELP = "to run it, write a FUNCTION_BLOCK or TYPE of that name with what the program uses"


@dataclass(frozen=True, slots=True)
class Resolved:
    """A type, and the initial value that belongs to it (`TYPE t : INT := 5`)."""

    type: Type
    initial: Initial | None = None


_ANYTHING = {"variant": VARIANT_VALUE, "any": ANY_VALUE, "pointer": POINTER_VALUE}
_OF_DIALECT = {"tia": ("variant", "any", "pointer"), "step7": ("any", "pointer")}


def type_of_anything(library: "Library", node: ast.TypeSpec) -> ReferenceType | None:
    """VARIANT of S7-1200 and S7-1500, ANY and POINTER; None for every other type."""
    if not isinstance(node, ast.NamedType) or node.quoted:
        return None
    key = node.name.casefold()
    return _ANYTHING[key] if key in _OF_DIALECT.get(library.rules.dialect, ()) else None


def elementary_type(name: str, dialect: str) -> Elementary | None:
    """The elementary type with that name in a dialect, whatever its case and spelling."""
    key = name.upper()
    kind = HARDWARE_TYPES.get(key) or ELEMENTARY.get(ALIASES.get(key, key))
    if kind is None or not exists_in(kind, dialect):
        return None
    return of_dialect(kind, dialect)


class TypeResolver:
    """Resolves written types; finds recursion among them."""

    def __init__(self, library: "Library") -> None:
        self._library = library
        self._declared: dict[str, ast.TypeDeclaration] = {}
        self._enumerators: dict[str, list[str]] = {}
        self._known: dict[str, Resolved] = {}
        self._targets: list[Callable[[], Type]] = []
        self._busy: list[str] = []
        self._cells: dict[int, int] = {}
        self._partial: set[str] = set()
        self.structures: dict[str, StructType] = {}

    def declare(self, node: ast.TypeDeclaration) -> None:
        """Make a TYPE of the text known."""
        key = node.name.name.casefold()
        self._declared[key] = node
        if isinstance(node.type, ast.EnumSpec):
            for one in node.type.enumerators:
                self._enumerators.setdefault(one.name.casefold(), []).append(key)

    def names(self) -> list[str]:
        """The names of all types of the text."""
        return [node.name.name for node in self._declared.values()]

    def is_known(self, name: str) -> bool:
        """True for the name of a type, of the text or not."""
        return (
            elementary_type(name, self._library.rules.dialect) is not None
            or name.casefold() in self._declared
            or codesys_type(self._library.rules.dialect, name) is not None
            or self._library.block_type(name) is not None
        )

    def declared(self) -> list[str]:
        """The casefolded names of all types of the text."""
        return list(self._declared)

    def resolve(self, ctx: Context, node: ast.TypeSpec) -> Resolved:
        """What a written type means; the erroneous type after reporting errors."""
        if isinstance(node, ast.NamedType):
            return self.named(ctx, node.name, node.span, node.quoted)
        if isinstance(node, ast.StringSpec):
            return Resolved(self._string(ctx, node))
        if isinstance(node, ast.ArraySpec):
            return self._array(ctx, node)
        if isinstance(node, ast.StructSpec):
            return Resolved(self.structure(ctx, node.fields, "STRUCT"))
        if isinstance(node, ast.EnumSpec):
            return self._enumeration(ctx, node, None)
        if isinstance(node, ast.SubrangeSpec):
            limited = subrange(self._library, ctx, node)
            return Resolved(ERRONEOUS) if limited is None else Resolved(limited, limited.lowest)
        if isinstance(node, ast.ReferenceSpec):
            return Resolved(reference_type(self._library, ctx, node))
        return Resolved(self.union(ctx, node, "UNION"))

    def settle_later(self, find: Callable[[], Type]) -> None:
        """The target of a reference, to be looked up when all types are known."""
        self._targets.append(find)

    def settle(self) -> None:
        """Look up the targets of all references, so that errors in unused ones are found."""
        for find in self._targets:
            find()

    def parameter(self, ctx: Context, node: ast.TypeSpec) -> Resolved:
        """What the type of a parameter means that is bound to an argument."""
        anything = type_of_anything(self._library, node)
        if anything is not None:
            return Resolved(anything)
        if not isinstance(node, ast.ArraySpec) or any(one.first for one in node.bounds):
            return self.resolve(ctx, node)
        element = self.resolve(ctx, node.element).type
        if element == ERRONEOUS:
            return Resolved(ERRONEOUS)
        return Resolved(OpenArrayType(len(node.bounds), element))

    def _enumeration(
        self, ctx: Context, node: ast.EnumSpec, declaration: ast.TypeDeclaration | None
    ) -> Resolved:
        kind = enumeration(self._library, ctx, node, declaration)
        if kind is None:
            return Resolved(ERRONEOUS)
        if declaration is None:
            ctx.scope.enumerations.append(kind)
        return Resolved(kind, kind.members[0][1] if kind.members else None)

    def enumeration(self, name: str) -> Enumeration | None:
        """The enumeration that a TYPE of the text declares; None if there is none."""
        key = name.casefold()
        node = self._declared.get(key)
        if node is None and (own := codesys_type(self._library.rules.dialect, name)) is not None:
            node = self._declared[key] = own
        if node is None:
            return None
        kind = self._user_type(key, node.name.span).type
        return kind if isinstance(kind, Enumeration) else None

    def enumerations_with(self, ctx: Context, enumerator: str) -> list[Enumeration]:
        """The enumerations that have an enumerator of that name: the block's own, else all."""
        key = enumerator.casefold()
        own = [kind for kind in ctx.scope.enumerations if kind.value_of(key) is not None]
        if own:
            return own
        found = [self.enumeration(name) for name in self._enumerators.get(key, ())]
        everywhere = self._library.globals.enumerations
        return [kind for kind in found if kind is not None] + [
            kind for kind in everywhere if kind.value_of(key) is not None
        ]

    def enumerator(self, ctx: Context, node: ast.Literal) -> Expression:
        """`Colour#red`."""
        return typed_enumerator(ctx, node)

    def declared_at(self, name: str) -> Span | None:
        """The place of the TYPE with that name."""
        node = self._declared.get(name.casefold())
        return None if node is None else node.name.span

    def named(self, ctx: Context, name: str, span: Span, quoted: bool = False) -> Resolved:
        """What a type's name means."""
        elementary = None if quoted else elementary_type(name, self._library.rules.dialect)
        if elementary is not None:
            return Resolved(elementary)
        key = name.casefold()
        if key in self._declared:
            return self._user_type(key, span)
        if self._library.rules.dialect == "tia" and not quoted:
            if key == "dtl":
                return Resolved(DTL)
            if (system := system_type(name)) is not None:
                self._declared[key] = system
                return self._user_type(key, span)
        own = codesys_type(self._library.rules.dialect, name)
        if own is not None and self._library.block_type(name) is None:
            self._declared[key] = own
            return self._user_type(key, span)
        interface = self._library.objects.interfaces.find(name)
        if interface is not None:
            return Resolved(self._library.objects.interfaces.type_of(interface))
        block = self._library.block_type(name)
        if block is not None:
            return Resolved(block)
        on_s7 = self._library.rules.dialect in ("tia", "step7")
        library, point, rest = name.partition(".")
        if point and not on_s7 and is_library(library):
            return self.named(ctx, rest, span)
        if not quoted and name.upper() in NUMBER_TYPES and on_s7:
            return Resolved(NUMBER_TYPES[name.upper()])
        findings = self._library.findings
        if type_of_anything(self._library, ast.NamedType(span, name, quoted)):
            findings.error(
                "FB4095",
                f"{name.upper()} takes what it refers to from an argument, and there is none here",
                span,
                "use it in VAR_INPUT, VAR_IN_OUT or VAR_TEMP of a block",
            )
            return Resolved(ERRONEOUS)
        if on_s7 and key in ("any", "pointer"):
            message = f"variables of type {name.upper()} have no model, so this program cannot run"
            findings.gap(message, span, "give instructions such as DPRD_DAT the variable itself")
            return Resolved(ERRONEOUS)
        user = self._library.user_block(name)
        if user is not None or self._library.is_block_name(key):
            findings.error(
                "FB4046",
                f"'{name}' is a block that has no instances",
                span,
                "only a FUNCTION_BLOCK is a type; call a FUNCTION by its name",
            )
            return Resolved(ERRONEOUS)
        if self._library.rules.dialect == "tia" and not quoted and _OBJECT.match(name):
            findings.gap(f"{name} has no model, so this program cannot run", span, _OBJECT_HELP)
            return Resolved(ERRONEOUS)
        self.report_unknown(name, span)
        return Resolved(ERRONEOUS)

    def report_unknown(self, name: str, span: Span) -> None:
        """Report the name of a type, a base or an interface that no file has."""
        dialect = self._library.rules.dialect
        on_s7 = dialect in ("tia", "step7")
        elementary = [one.name for one in ELEMENTARY.values() if exists_in(one, dialect)]
        advise = type_help if on_s7 else library_help
        self._library.findings.unknown(
            "FB4003",
            f"there is no type '{name}'",
            span,
            lambda: (
                namespace_help(self._library.namespaces, name)
                or advise(name, [*self.names(), *self._library.type_names(), *elementary, "STRING"])
            ),
        )

    def all_user_types(self) -> None:
        """Resolve every TYPE, so that errors in unused ones are found too."""
        for key, node in list(self._declared.items()):
            self._user_type(key, node.name.span)

    def _user_type(self, key: str, span: Span) -> Resolved:
        if key in self._known:
            return self._known[key]
        node = self._declared[key]
        if key in self._busy or len(self._busy) > _TYPE_NESTING:
            self._report_recursion(key, node, span)
            return Resolved(ERRONEOUS)
        self._busy.append(key)
        ctx = self._library.global_context()
        if isinstance(node.type, ast.StructSpec):
            struct = self.structure(ctx, node.type.fields, node.name.name, self._base(ctx, node))
            if isinstance(struct, StructType):
                self.structures[key] = struct
            resolved = Resolved(struct)
        elif isinstance(node.type, ast.EnumSpec):
            resolved = self._enumeration(ctx, node.type, node)
        elif isinstance(node.type, ast.UnionSpec):
            resolved = Resolved(self.union(ctx, node.type, node.name.name))
        else:
            resolved = self.resolve(ctx, node.type)
        self._known[key] = resolved  # an initial value may use the type's own enumerators
        if node.initial is not None and resolved.type != ERRONEOUS:
            initial = self._library.initial(ctx, node.initial, resolved.type, resolved.initial)
            resolved = Resolved(resolved.type, initial)
        self._busy.pop()
        self._known[key] = resolved
        return resolved

    def is_declaring(self, kinds: Sequence[Enumeration]) -> bool:
        """True for the one enumeration whose TYPE is being looked at: its names stand alone."""
        return (
            len(kinds) == 1
            and bool(self._busy)
            and self._known.get(self._busy[-1], Resolved(VOID)).type is kinds[0]
        )

    def _report_recursion(self, key: str, node: ast.TypeDeclaration, span: Span) -> None:
        if key not in self._busy:
            self._library.findings.error(
                "FB4053",
                f"types are nested deeper than {_TYPE_NESTING} levels",
                span,
                "put fewer structures into each other",
            )
            return
        chain = [self._declared[one].name.name for one in self._busy[self._busy.index(key) :]]
        self._library.findings.error(
            "FB4050",
            f"type '{node.name.name}' contains itself: {' -> '.join([*chain, chain[0]])}",
            span,
            "a structure cannot hold one of its own kind: take the inner one out",
            (Note("the type is declared here", node.name.span),),
        )

    def _base(self, ctx: Context, node: ast.TypeDeclaration) -> tuple[Field, ...]:
        """The parts that a structure has from the one that it extends."""
        if node.extends is None:
            return ()
        base = self.named(ctx, node.extends.name, node.extends.span).type
        if isinstance(base, StructType):
            if self.is_partial(base):
                self._partial.add(node.name.name.casefold())
            return base.fields
        if base == ERRONEOUS:
            self._partial.add(node.name.name.casefold())
        else:
            self._library.findings.error(
                "FB4087",
                f"{node.name.name} cannot extend '{node.extends.name}'",
                node.extends.span,
                "a structure extends a structure",
            )
        return ()

    def is_partial(self, kind: StructType) -> bool:
        """True if the base of a structure is in no file: it may have any part."""
        return kind.name.casefold() in self._partial

    def structure(
        self,
        ctx: Context,
        declarations: tuple[ast.Declaration, ...],
        name: str,
        inherited: tuple[Field, ...] = (),
    ) -> Type:
        """A new structure type with these parts, behind those that are inherited."""
        fields: list[Field] = list(inherited)
        seen: dict[str, ast.DeclaredName] = {}
        for declaration in declarations:
            resolved = self.resolve(ctx, declaration.type)
            initial = resolved.initial
            if declaration.arguments:
                self._library.findings.error(
                    "FB4054",
                    "arguments for FB_init in a structure are not supported",
                    declaration.arguments[0].span,
                    "declare the instance in VAR of a block, or give it initial values in :=",
                )
            if declaration.initial is not None and resolved.type != ERRONEOUS:
                initial = self._library.initial(
                    ctx, declaration.initial, resolved.type, resolved.initial
                )
            for declared in declaration.names:
                key = declared.name.casefold()
                if key in seen:
                    self._library.duplicate(declared.name, declared.span, seen[key].span)
                    continue
                seen[key] = declared
                fields.append(Field(declared.name, resolved.type, initial))
        return StructType(name, tuple(fields))

    def union(self, ctx: Context, node: ast.UnionSpec, name: str) -> Type:
        """A new union of these parts, which all have to lie in bytes."""
        struct = self.structure(ctx, node.fields, name)
        if not isinstance(struct, StructType):
            return struct
        for part in struct.fields:
            if part.type != ERRONEOUS and (not holds_values(part.type) or holds_blocks(part.type)):
                self._library.findings.error(
                    "FB4074",
                    f"part '{part.name}' of a union has no fixed bytes",
                    node.span,
                    "take elementary types, arrays and structures as parts of a union",
                )
                return ERRONEOUS
        return StructType(name, struct.fields, is_union=True)

    def _string(self, ctx: Context, node: ast.StringSpec) -> Type:
        if node.length is None:
            return StringType(wide=node.wide)
        length = whole_number(ctx, node.length, "the length of a STRING")
        limit = _LONGEST_STRING if node.wide or not self._library.rules.iec_check else 254
        if self._library.rules.dialect in ("iec", "twincat"):
            limit = _LONGEST_STRING
        if length is None:
            return ERRONEOUS
        if not 1 <= length <= limit:
            self._library.findings.error(
                "FB4055",
                f"a STRING cannot have {length} characters",
                node.length.span,
                f"use a length from 1 to {limit}",
            )
            return ERRONEOUS
        return StringType(length, node.wide)

    def _array(self, ctx: Context, node: ast.ArraySpec) -> Resolved:
        inner = self.resolve(ctx, node.element)
        element = inner.type
        bounds = []
        for dimension in node.bounds:
            if dimension.first is None or dimension.last is None:
                self._library.findings.error(
                    "FB4091",
                    "ARRAY[*] takes its bounds from an argument, and there is none here",
                    dimension.span,
                    "use it in VAR_IN_OUT, or VAR_INPUT of a FUNCTION, with * for all bounds",
                )
                return Resolved(ERRONEOUS)
            first = whole_number(ctx, dimension.first, "an array bound")
            last = whole_number(ctx, dimension.last, "an array bound")
            if first is None or last is None:
                return Resolved(ERRONEOUS)
            if first > last:
                self._library.findings.error(
                    "FB4055",
                    f"the array bounds {first}..{last} are the wrong way round",
                    dimension.span,
                    f"write {last}..{first}",
                )
                return Resolved(ERRONEOUS)
            bounds.append((first, last))
        if element == ERRONEOUS:
            return Resolved(ERRONEOUS)
        kind = ArrayType(tuple(bounds), element)
        if self.cells(kind) > CELL_LIMIT:
            self._library.findings.error(
                "FB4052",
                f"an array of {self.cells(kind)} values is too large",
                node.span,
                f"{CELL_LIMIT} values are the limit",
            )
            return Resolved(ERRONEOUS)
        if inner.initial is None:
            return Resolved(kind)
        return Resolved(kind, ArrayInitial((inner.initial,) * kind.count))

    def cells(self, kind: Type) -> int:
        """How many elementary values a type has; instances count as one."""
        if isinstance(kind, ArrayType):
            return kind.count * self.cells(kind.element)
        if isinstance(kind, StructType):
            key = id(kind)
            if key not in self._cells:
                self._cells[key] = sum(self.cells(field.type) for field in kind.fields)
            return self._cells[key]
        return 1
