"""Enumerations and subranges: what their declarations mean, and finding an enumerator by its name.

An enumerator without a value has the one after its predecessor, the first one 0. Without a base an
enumeration counts in INT. Its variables start with the first enumerator, those of a subrange with
the lowest value. Enumerators of TYPEs are known in the whole program, those of a variable's own
enumeration in its block; a name that several enumerations have needs its type: `Colour#red`,
`Colour.red`, unless its place asks for one of them.
Sources: IEC 61131-3 third edition, table 11 and 6.4.4.3 to 6.4.4.5; CODESYS and TwinCAT help,
"Enumerations", pragmas `qualified_only` and `strict`.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from fbgen.diagnostics import Note
from fbgen.lang import ast
from fbgen.lang.checked import Constant, Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.types.constants import constant_of, whole_number
from fbgen.lang.checker.types.folding import COMPARISONS
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous
from fbgen.lang.types import INT, Elementary, Enumeration, Family, Subrange, Type
from fbgen.nearest import nearest
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library

_SHOWN_NAMES = 3
_COUNTING = (Family.SIGNED, Family.UNSIGNED, Family.BITS)


def enumeration(
    library: "Library",
    ctx: Context,
    node: ast.EnumSpec,
    declaration: ast.TypeDeclaration | None,
) -> Enumeration | None:
    """The type that a list of names makes; None after reporting what is wrong with its base."""
    base: Elementary = INT
    if node.base is not None:
        found = library.types.named(ctx, node.base.name, node.base.span).type
        if found == ERRONEOUS:
            return None
        if not isinstance(found, Elementary) or found.family not in _COUNTING:
            library.findings.error(
                "FB4055",
                f"an enumeration cannot count in {found.name}",
                node.base.span,
                "leave its base out, or write an integer type: DINT (a, b)",
            )
            return None
        base = found
    members: list[tuple[str, int]] = []
    seen: dict[str, Span] = {}
    following = 0
    for one in node.enumerators:
        key = one.name.casefold()
        if key in seen:
            library.duplicate(one.name, one.span, seen[key])
            continue
        seen[key] = one.span
        value = following
        if one.value is not None:
            value = _value(ctx, one, base, members, following)
        elif value > base.maximum:
            library.findings.error(
                "FB4014",
                f"the value {value} of '{one.name}' is outside of {base.name}",
                one.span,
                "give the enumeration a wider base, or the enumerator a value",
            )
        following = value + 1
        members.append((one.name, value))
    names = [name for name, _ in members[:_SHOWN_NAMES]]
    dots = ", ..." if len(members) > _SHOWN_NAMES else ""
    name = declaration.name.name if declaration is not None else f"({', '.join(names)}{dots})"
    pragmas = _pragmas(declaration)
    return Enumeration(
        name,
        base.family,
        base.bits,
        tuple(members),
        base,
        qualified="qualified_only" in pragmas,
        strict="'strict'" in pragmas,
    )


def _value(
    ctx: Context,
    one: ast.Enumerator,
    base: Elementary,
    members: Sequence[tuple[str, int]],
    following: int,
) -> int:
    """A written value; it may name the enumerators before it."""
    assert one.value is not None
    where = f"the value of enumerator '{one.name}'"
    if isinstance(one.value, ast.Name):
        key = one.value.name.casefold()
        for name, value in members:
            if name.casefold() == key:
                return value
    given = constant_of(ctx, one.value, base, where)
    return following if given is None else int(given)


def _pragmas(declaration: ast.TypeDeclaration | None) -> str:
    if declaration is None:
        return ""
    trivia = (*declaration.leading, *declaration.header_comments)
    return " ".join(one.text for one in trivia if one.kind is ast.TriviaKind.PRAGMA).casefold()


def subrange(library: "Library", ctx: Context, node: ast.SubrangeSpec) -> Subrange | None:
    """The type with these limits; None after reporting what is wrong with it."""
    base = library.types.named(ctx, node.base.name, node.base.span).type
    if not isinstance(base, Elementary) or not base.is_integer:
        if base != ERRONEOUS:
            library.findings.error(
                "FB4055",
                f"{base.name} has no subranges",
                node.span,
                "limit an integer type: INT (0..100)",
            )
        return None
    lowest = whole_number(ctx, node.first, "the lower limit")
    highest = whole_number(ctx, node.last, "the upper limit")
    if lowest is None or highest is None:
        return None
    if lowest > highest:
        library.findings.error(
            "FB4055",
            f"the limits {lowest}..{highest} are the wrong way round",
            node.span,
            f"write {highest}..{lowest}",
        )
        return None
    for limit, part in ((lowest, node.first), (highest, node.last)):
        if not base.minimum <= limit <= base.maximum:
            library.findings.error(
                "FB4014",
                f"{limit} is outside of {base.name}",
                part.span,
                f"{base.name} holds {base.minimum} to {base.maximum}",
            )
            return None
    name = f"{base.name} ({lowest}..{highest})"
    return Subrange(name, base.family, base.bits, base, lowest, highest)


def enumerator_value(ctx: Context, span: Span, kind: Enumeration, name: str) -> Expression:
    """The enumerator of a known enumeration; reports FB4005 if it has none of that name."""
    value = kind.value_of(name)
    if value is not None:
        return Constant(span, value, kind)
    ctx.findings.error(
        "FB4005",
        f"{kind.name} has no enumerator '{name}'",
        span,
        nearest(name, [known for known, _ in kind.members]),
    )
    return erroneous(span)


def bare_enumerator(ctx: Context, node: ast.Name, expected: Type | None) -> Expression | None:
    """The enumerator that a name alone means; None if it means none."""
    found = ctx.library.types.enumerations_with(ctx, node.name)
    if isinstance(expected, Enumeration) and expected in found:
        found = [expected]
    free = [kind for kind in found if not kind.qualified]
    if not found:
        return None
    if ctx.library.types.is_declaring(found):
        return enumerator_value(ctx, node.span, found[0], node.name)
    if len(free) == 1:
        return enumerator_value(ctx, node.span, free[0], node.name)
    choices = [f"{kind.name}.{node.name}" for kind in (free or found)]
    message = (
        f"'{node.name}' is reached by the name of its type only"
        if not free
        else f"'{node.name}' is an enumerator of several types"
    )
    ctx.findings.error(
        "FB4090", message, node.span, f"write {' or '.join(choices)}", _notes(ctx, free)
    )
    return erroneous(node.span)


def _notes(ctx: Context, kinds: Sequence[Enumeration]) -> tuple[Note, ...]:
    notes = []
    for kind in kinds:
        place = ctx.library.types.declared_at(kind.name)
        if place is not None:
            notes.append(Note(f"{kind.name} is declared here", place))
    return tuple(notes)


def typed_enumerator(ctx: Context, node: ast.Literal) -> Expression:
    """`Colour#red`."""
    kind = ctx.library.types.named(ctx, node.type_name, node.span).type
    if isinstance(kind, Enumeration):
        return enumerator_value(ctx, node.span, kind, str(node.value))
    if kind != ERRONEOUS:
        ctx.findings.error(
            "FB4005",
            f"{kind.name} is no enumeration and has no '{node.value}'",
            node.span,
            "write the name of an enumeration in front of #",
        )
    return erroneous(node.span)


def enumeration_named(ctx: Context, node: ast.Expression) -> Enumeration | None:
    """The enumeration whose name an expression is, as in `Colour.red`."""
    name = dotted(node)
    return None if name is None else ctx.library.types.enumeration(name)


def dotted(node: ast.Expression) -> str | None:
    """The name that `a` or `a.b.c` spells; None for any other expression."""
    if isinstance(node, ast.Member):
        base = dotted(node.base)
        return None if base is None else f"{base}.{node.name}"
    return node.name if isinstance(node, ast.Name) and not node.local else None


def is_strict(kind: Type, operator: str) -> bool:
    """True for an enumeration that is compared, and not calculated with."""
    return isinstance(kind, Enumeration) and kind.strict and operator not in COMPARISONS
