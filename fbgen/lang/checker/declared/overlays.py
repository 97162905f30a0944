"""Variables that lie over other ones: `view AT data : ARRAY[0..3] OF BYTE;`.

Sources: TIA Portal help, "Overlaying tags with AT" (only with standard access or where the
retentivity is set in the instance data block, which sources spell DB_SPECIFIC; no initial value,
not larger than what it overlays, declared behind it); STEP 7 SCL manual, "Views of variables";
published sources for overlays of in-outs.
"""

from fbgen.dataclass import dataclass
from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import LIVING, Variable, VariableKind
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.memory_use import is_optimized
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.layout import holds_blocks, holds_values, sizes_of
from fbgen.lang.types import Type
from fbgen.nearest import nearest

_PLACES = (*LIVING, VariableKind.IN_OUT, VariableKind.TEMP)


@dataclass(frozen=True, slots=True)
class Home:
    """The block that declares variables: its kind (None: global ones) and its header.

    `is_specific`: in a section DB_SPECIFIC, which has standard access in every block.
    """

    block: BlockKind | None
    header: tuple[ast.HeaderItem, ...] = ()
    is_specific: bool = False


def check_overlay(
    ctx: Context,
    declaration: ast.Declaration,
    kind: Type,
    home: Home,
) -> Variable | None:
    """The variable in whose memory the declared ones lie; None after reporting why there is none.

    What is overlaid counts as used and written, since its view shows it and changes it.
    """
    at = declaration.at
    assert isinstance(at, ast.Name)
    entry = ctx.scope.entries.get(at.name.casefold())
    if not isinstance(entry, Variable):
        known = [one.name for one in ctx.scope.entries.values() if isinstance(one, Variable)]
        ctx.findings.error(
            "FB4001",
            f"no variable '{at.name}' is declared before this one",
            at.span,
            nearest(at.name, known) or "declare what is overlaid first, in the same block",
        )
        return None
    if ERRONEOUS in (kind, entry.type):
        return None
    root = entry.overlay or entry
    problem, help_text = _problem(ctx, declaration, root, kind, home)
    if problem:
        ctx.findings.error("FB4071", problem, at.span, help_text)
        return None
    if root.kind is VariableKind.IN_OUT:
        ctx.used |= {entry, root}
        ctx.findings.gap(
            f"an overlay of in-out '{root.name}' has no model, so this program cannot run",
            at.span,
            "to run it, copy it to a variable in VAR_TEMP, overlay that, and copy it back",
        )
        return None
    ctx.used |= {entry, root}
    ctx.written.add(root)
    return root


def overlay_kind(root: Variable, has_memory: bool) -> VariableKind:
    """The kind of an overlay: it is never a parameter."""
    if root.kind is VariableKind.TEMP or not has_memory:
        return VariableKind.TEMP
    return VariableKind.STATIC


def _problem(
    ctx: Context, declaration: ast.Declaration, root: Variable, kind: Type, home: Home
) -> tuple[str, str]:
    """Why the overlay cannot be, and what to do; empty texts if it can."""
    if ctx.rules.dialect not in ("tia", "step7"):
        return "only S7 lays variables over each other", "use a UNION"
    if is_optimized(home.header) and not home.is_specific:
        return (
            f"'{root.name}' belongs to a block with optimized access, which has no overlays",
            "declare both in VAR DB_SPECIFIC, or write { S7_Optimized_Access := 'FALSE' }",
        )
    in_event = home.block is BlockKind.ORGANIZATION_BLOCK and root.kind is VariableKind.INPUT
    if root.address is not None or root.kind not in _PLACES or in_event:
        return (
            f"'{root.name}' is {root.kind.value}, and only own memory of the block has overlays",
            "copy it to a variable in VAR or VAR_TEMP and overlay that",
        )
    if declaration.initial is not None:
        return "an overlay has no value of its own", f"give the value to '{root.name}'"
    sizes = sizes_of(ctx.rules.dialect)
    for one in (root.type, kind):
        if not holds_values(one) or holds_blocks(one):
            return (
                f"a variable of type {one.name} does not lie in memory as bytes",
                "overlay elementary variables, arrays and structures",
            )
    room, size = sizes.size_bits(root.type), sizes.used_bits(kind)
    if size > room:
        return (
            f"the overlay takes {_length(size)}, '{root.name}' only {_length(room)}",
            "an overlay must not be larger than what it lies over",
        )
    return "", ""


def _length(bits: int) -> str:
    if bits < 8:
        return f"{bits} bit{'s' if bits > 1 else ''}"
    size = -(-bits // 8)
    return f"{size} byte{'s' if size > 1 else ''}"
