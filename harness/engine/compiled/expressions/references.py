"""References: the object itself of what has parts, a cell of a single value, None for nothing."""

from fbgen.lang.checked import (
    Dereference,
    ElementCount,
    Place,
    ReferenceTo,
    SameReference,
    SameTypes,
    TypeTest,
    VariableRef,
)
from fbgen.lang.types import VARIANT_VALUE, OpenArrayType, refers_to_anything
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.evaluation import Write, value
from harness.engine.compiled.expressions.addresses import as_memory_ref
from harness.engine.compiled.expressions.places import cell, place
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits


def _dereference(procedure: Procedure, node: Dereference) -> Code:
    base = place(procedure, node.base)
    low, high = limits(node.type)
    if refers_to_anything(node.base.type):
        # Its type is known by now, but for an area, which any type is good for.
        text = f"{base.text}.target"
        if node.type == VARIANT_VALUE:
            text = f"_target({base.text})"
        elif is_scalar(node.type):
            text += ".value"
    elif is_scalar(node.type):
        text = f"{base.text}.value"
    else:
        text = f"_target({base.text})"
    procedure.site(text, node)
    return Code(text, Level.ATOM, low, high, base.depth + 1, safe=False, pure=base.pure)


def _reference(procedure: Procedure, node: ReferenceTo) -> Code:
    if node.place is None:
        return Code("None", simple=True)
    if refers_to_anything(node.type):
        return _variant(procedure, node.place)
    if is_scalar(node.place.type):
        return cell(procedure, node.place)
    return place(procedure, node.place)


def _variant(procedure: Procedure, node: Place) -> Code:
    if isinstance(node, VariableRef) and node.variable.address is not None:
        node = as_memory_ref(node, node.variable.address)
    code = cell(procedure, node) if is_scalar(node.type) else place(procedure, node)
    if isinstance(node.type, OpenArrayType):
        element = procedure.context.table("kind", node.type.element)
        text = f"_variant_of_open({element}, {code.text})"
    else:
        text = f"_Variant({procedure.context.table('kind', node.type)}, {code.text})"
    return Code(text, depth=code.depth + 1, safe=code.safe, pure=code.pure)


def _has_type(procedure: Procedure, node: TypeTest) -> Code:
    code = value(procedure, node.variant)
    wanted = procedure.context.table("kind", node.wanted)
    function = "_elements_have_type" if node.of_elements else "_has_type"
    text = f"{function}({code.text}, {wanted})"
    procedure.site(text, node.variant)
    return code._replace(text=text, level=Level.ATOM, depth=code.depth + 1)


def _same_types(procedure: Procedure, node: SameTypes) -> Code:
    left, right = value(procedure, node.left), value(procedure, node.right)
    of_left, of_right = node.of_elements
    return Code(
        f"_same_types({left.text}, {of_left}, {right.text}, {of_right})",
        depth=max(left.depth, right.depth) + 1,
        safe=left.safe and right.safe,
        pure=left.pure and right.pure,
    )


def _element_count(procedure: Procedure, node: ElementCount) -> Code:
    code = value(procedure, node.variant)
    low, high = limits(node.type)
    return code._replace(
        text=f"_element_count({code.text})", low=low, high=high, depth=code.depth + 1, simple=False
    )


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
    TypeTest: _has_type,
    SameTypes: _same_types,
    ElementCount: _element_count,
}
"""Which function of this module writes which node."""
