"""References: the object itself of what has parts, a cell of a single value, None for nothing."""

from fbgen.lang.checked import Dereference, ReferenceTo, SameReference
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.evaluation import Write, value
from harness.engine.compiled.model import is_scalar
from harness.engine.compiled.places import cell, place
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.ranges import limits


def _dereference(procedure: Procedure, node: Dereference) -> Code:
    base = place(procedure, node.base)
    low, high = limits(node.type)
    if is_scalar(node.type):
        text = f"{base.text}.value"
    else:
        text = f"_target({base.text})"
    procedure.site(text, node)
    return Code(text, Level.ATOM, low, high, base.depth + 1, safe=False, pure=base.pure)


def _reference(procedure: Procedure, node: ReferenceTo) -> Code:
    if node.place is None:
        return Code("None", simple=True)
    if is_scalar(node.place.type):
        return cell(procedure, node.place)
    return place(procedure, node.place)


def _same(procedure: Procedure, node: SameReference) -> Code:
    left, right = value(procedure, node.left), value(procedure, node.right)
    if right.text == "None":
        text, level = f"{left.at(Level.BIT_OR)} is None", Level.COMPARISON
    else:
        text, level = f"_same({left.text}, {right.text})", Level.ATOM
    return Code(
        text,
        level,
        depth=max(left.depth, right.depth) + 1,
        safe=left.safe and right.safe,
        pure=left.pure and right.pure,
    )


EXPRESSIONS: dict[type, Write] = {
    Dereference: _dereference,
    ReferenceTo: _reference,
    SameReference: _same,
}
"""Which function of this module writes which node."""
