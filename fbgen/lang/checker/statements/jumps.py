"""GOTO and its labels: where a jump may lead.

Sources: TIA Portal help, "GOTO: Jump" (the label stands in the same block; no jump into a loop, but
out of one); S7-SCL V5.3 manual, "GOTO statement" (labels are declared in LABEL ... END_LABEL).
"""

from collections.abc import Sequence

from fbgen.diagnostics import Note
from fbgen.lang import ast, checked
from fbgen.lang.checked import Statement
from fbgen.lang.checker.context import Context, Place
from fbgen.nearest import nearest


def check_label(ctx: Context, node: ast.Label) -> Sequence[Statement]:
    """A label; its name is there once in a block."""
    key = node.name.casefold()
    first = ctx.labels.get(key)
    if first is not None:
        ctx.findings.error(
            "FB4080",
            f"jump label '{node.name}' stands twice in this block",
            node.span,
            "give one of them another name (upper and lower case are the same)",
            (Note("the first one is here", first.span),),
        )
        return ()
    ctx.labels[key] = Place(node.name, node.span, ctx.loops)
    return (checked.Label(node.span, key),)


def check_goto(ctx: Context, node: ast.Goto) -> Sequence[Statement]:
    """A jump; whether its label is there is known at the end of the block."""
    key = node.label.casefold()
    ctx.jumps.append(Place(node.label, node.span, ctx.loops))
    return (checked.Goto(node.span, key, backward=key in ctx.labels),)


def check_jumps(ctx: Context, syntax: ast.Block) -> None:
    """Compare the jumps of a whole block with its labels."""
    for jump in ctx.jumps:
        label = ctx.labels.get(jump.name.casefold())
        if label is None:
            ctx.findings.error(
                "FB4081",
                f"there is no jump label '{jump.name}' in this block",
                jump.span,
                nearest(jump.name, [known.name for known in ctx.labels.values()]),
            )
        elif jump.loops[: len(label.loops)] != label.loops:
            ctx.findings.error(
                "FB4082",
                f"this jump leads into a loop, to '{label.name}'",
                jump.span,
                "put the label in front of the loop: a loop begins at its head only",
                (Note("the label is here", label.span),),
            )
    if ctx.rules.labels_declared and ctx.labels:
        _check_declarations(ctx, syntax)


def _check_declarations(ctx: Context, syntax: ast.Block) -> None:
    declared = {name.name.casefold() for section in syntax.labels for name in section.names}
    for key, label in ctx.labels.items():
        if key not in declared:
            ctx.findings.error(
                "FB4083",
                f"jump label '{label.name}' is not declared",
                label.span,
                f"declare it in front of BEGIN: LABEL {label.name}; END_LABEL",
            )
