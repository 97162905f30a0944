"""VARIANT: asking for the type, reading and writing what it refers to, attempts to assign it.

Sources: TIA Portal help, "VARIANT", "TypeOf: Check data type of a VARIANT tag", "TypeOfElements",
"IS_ARRAY", "CountOfElements", "VariantGet", "VariantPut", "Assignment attempt".
"""

from collections.abc import Sequence

from fbgen.diagnostics import Note
from fbgen.lang import ast, checked
from fbgen.lang.checked import (
    Binary,
    Constant,
    Dereference,
    ElementCount,
    Expression,
    Place,
    ReferenceTo,
    SameTypes,
    Statement,
    TypeTest,
    Unary,
)
from fbgen.lang.checker.calls.arguments import bind, only_argument
from fbgen.lang.checker.calls.binding import report_missing
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.types.coercion import coerce, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS, NULL, erroneous
from fbgen.lang.types import (
    BOOL,
    UDINT,
    VARIANT_VALUE,
    ArrayType,
    OpenArrayType,
    ReferenceType,
    StringType,
    Type,
    is_of_type,
    refers_to_anything,
)
from fbgen.source import Span

_QUESTIONS = ("typeof", "typeofelements")
_FUNCTIONS = ("is_array", "countofelements", *_QUESTIONS)
_ACCESSES = ("variantget", "variantput")
_TEXTS = {"STRING": StringType(0), "WSTRING": StringType(0, wide=True)}
"""The names of texts: whatever their length."""
_LONGEST = 16382


def is_variant_function(ctx: Context, name: str) -> bool:
    """True for the functions that ask a VARIANT."""
    return ctx.rules.dialect == "tia" and name.casefold() in _FUNCTIONS


def is_variant_access(ctx: Context, name: str) -> bool:
    """True for VariantGet and VariantPut."""
    return ctx.rules.dialect == "tia" and name.casefold() in _ACCESSES


def is_variant_name(name: str) -> bool:
    """True for the names of all of them."""
    return name.casefold() in (*_FUNCTIONS, *_ACCESSES)


def asks_for_type(ctx: Context, node: ast.Expression) -> bool:
    """True for TypeOf(...) and TypeOfElements(...)."""
    return (
        isinstance(node, ast.Call)
        and isinstance(node.callee, ast.Name)
        and not (node.callee.quoted or node.callee.local)
        and node.callee.name.casefold() in _QUESTIONS
        and ctx.rules.dialect == "tia"
    )


def compares_types(ctx: Context, node: ast.Binary) -> bool:
    """True for `TypeOf(x) = Int` and its like."""
    return node.operator in ("=", "<>") and (
        asks_for_type(ctx, node.left) or asks_for_type(ctx, node.right)
    )


# --- the type -----------------------------------------------------------------------------------


class _Asked:
    """What one side of a comparison asks: a variant, or a type that is known."""

    __slots__ = ("of_elements", "type", "variant")

    def __init__(self, variant: Expression | None, of_elements: bool, kind: Type | None) -> None:
        self.variant = variant
        self.of_elements = of_elements
        self.type = kind


def _operand(ctx: Context, node: ast.Call, name: str) -> Expression | None:
    """The argument as a VARIANT, None after reporting errors; asking does not write."""
    argument = only_argument(ctx, node, name)
    if argument is None:
        return None
    value = check_expression(ctx, argument)
    if value.type == ERRONEOUS or refers_to_anything(value.type):
        return None if value.type == ERRONEOUS else value
    if isinstance(value, Place):
        return ReferenceTo(value.span, value, VARIANT_VALUE)
    ctx.findings.error(
        "FB4022",
        f"{name} takes a variable, not a value",
        argument.span,
        "give the VARIANT that is meant",
    )
    return None


def _side(ctx: Context, node: ast.Expression) -> _Asked | None:
    """One side of a comparison of types; None after reporting errors."""
    while isinstance(node, ast.Parenthesized):
        node = node.inner
    if asks_for_type(ctx, node):
        assert isinstance(node, ast.Call)
        assert isinstance(node.callee, ast.Name)
        of_elements = node.callee.name.casefold() == "typeofelements"
        variant = _operand(ctx, node, node.callee.name)
        if variant is None:
            return None
        if isinstance(variant, ReferenceTo) and variant.place is not None:
            known = variant.place.type
            if isinstance(known, ArrayType | OpenArrayType) and of_elements:
                return _Asked(None, of_elements, known.element)
            if not of_elements and not isinstance(known, OpenArrayType):
                return _Asked(None, of_elements, known)
        return _Asked(variant, of_elements, None)
    if isinstance(node, ast.Name) and not node.local:
        if not node.quoted and node.name.upper() in _TEXTS:
            return _Asked(None, False, _TEXTS[node.name.upper()])
        kind = ctx.library.types.named(ctx, node.name, node.span, node.quoted).type
        return None if kind == ERRONEOUS else _Asked(None, False, kind)
    ctx.findings.error(
        "FB4094",
        "a type is compared with something that is none",
        node.span,
        'write the name of a type: TypeOf(#x) = Int, TypeOf(#x) = "typeData"',
    )
    return None


def type_comparison(ctx: Context, node: ast.Binary) -> Expression:
    """`TypeOf(x) = Int`, `TypeOf(x) <> TypeOf(y)`."""
    left, right = _side(ctx, node.left), _side(ctx, node.right)
    if left is None or right is None:
        return erroneous(node.span)
    same = _same(node.span, left, right)
    if node.operator == "=":
        return same
    if isinstance(same, Constant):
        return Constant(node.span, not same.value, BOOL)
    return Unary(node.span, "NOT", same, BOOL)


def _same(span: Span, left: _Asked, right: _Asked) -> Expression:
    if left.variant is None and right.variant is not None:
        left, right = right, left
    if left.variant is None:
        assert left.type is not None
        assert right.type is not None
        same = is_of_type(left.type, right.type) or is_of_type(right.type, left.type)
        return Constant(span, same, BOOL)
    if right.variant is None:
        assert right.type is not None
        return TypeTest(span, left.variant, left.of_elements, right.type, BOOL)
    sides = (left.of_elements, right.of_elements)
    return SameTypes(span, left.variant, right.variant, sides, BOOL)


def case_of_type(
    ctx: Context, node: ast.Case, bodies: Sequence[tuple[Statement, ...]]
) -> checked.If:
    """`CASE TypeOf(x) OF Int: ... END_CASE`; `bodies` are those of the arms, then of ELSE."""
    asked = _side(ctx, node.selector)
    taken: list[tuple[Type, Span]] = []
    branches = []
    for arm, body in zip(node.arms, bodies, strict=False):
        condition: Expression | None = None
        for label in arm.labels:
            test = _label(ctx, label, asked, taken)
            if test is not None and condition is not None:
                condition = Binary(arm.span, "OR", condition, test, BOOL)
            else:
                condition = condition or test
        if condition is not None:
            branches.append(checked.Branch(arm.span, condition, body))
    return checked.If(node.span, tuple(branches), bodies[-1])


def _label(
    ctx: Context,
    label: ast.Expression | ast.LabelRange,
    asked: _Asked | None,
    taken: list[tuple[Type, Span]],
) -> Expression | None:
    if isinstance(label, ast.LabelRange):
        ctx.findings.error(
            "FB4094",
            "a type is compared with something that is none",
            label.span,
            "types have no ranges: write their names, with commas",
        )
        return None
    kind = _side(ctx, label)
    if kind is None or asked is None:
        return None
    if kind.type is not None:
        for other, span in taken:
            if other == kind.type:
                ctx.findings.error(
                    "FB4030",
                    f"CASE label {label.span.text} is taken already",
                    label.span,
                    "each type can select one arm only: change one of the labels",
                    (Note("the first one is here", span),),
                )
        taken.append((kind.type, label.span))
    return _same(label.span, asked, kind)


# --- functions ------------------------------------------------------------------------------------


def variant_function(ctx: Context, node: ast.Call, name: str) -> Expression:
    """IS_ARRAY(x) and CountOfElements(x)."""
    if name.casefold() in _QUESTIONS:
        ctx.findings.error(
            "FB4094",
            f"{name} stands only in a comparison of types and in CASE",
            node.span,
            f"write {name}(#x) = Int",
        )
        return erroneous(node.span)
    operand = _operand(ctx, node, name)
    if operand is None:
        return erroneous(node.span)
    count = ElementCount(node.span, operand, UDINT)
    if name.casefold() == "countofelements":
        return count
    return Binary(node.span, "<>", count, Constant(node.span, 0, UDINT), BOOL)


# --- access ---------------------------------------------------------------------------------------


def variant_access(ctx: Context, node: ast.Call, name: str) -> Sequence[Statement]:
    """VariantGet and VariantPut: nothing happens where the types are not the same."""
    is_get = name.casefold() == "variantget"
    bound = bind(ctx, node, name, [("SRC", "SRC"), ("DST", "DST")])
    if bound is None:
        return ()
    given: dict[str, ast.Expression] = {}
    for parameter, argument in bound:
        arrow = is_get and parameter == "DST"
        kind = argument.kind
        if kind is not ast.ArgumentKind.POSITIONAL and arrow != (kind is ast.ArgumentKind.OUTPUT):
            ctx.findings.error(
                "FB4041",
                f"'{parameter}' of {name} is given by {kind.value}",
                argument.span,
                f"write {parameter} {'=>' if arrow else ':='} ...",
            )
            return ()
        if argument.value is not None:
            given[parameter] = argument.value
    missing = [one for one in ("SRC", "DST") if one not in given]
    if missing:
        report_missing(ctx, node, name, missing)
        return ()
    if is_get:
        variant = _variant(ctx, given["SRC"], f"parameter SRC of {name}")
        target = check_target(ctx, given["DST"], f"parameter DST of {name}")
        return () if variant is None or target is None else (_got(ctx, node.span, variant, target),)
    value = check_expression(ctx, given["SRC"])
    variant = _variant(ctx, given["DST"], f"parameter DST of {name}")
    if variant is None or value.type == ERRONEOUS:
        return ()
    if not isinstance(value, Place) or refers_to_anything(value.type):
        ctx.findings.error(
            "FB4022",
            f"parameter SRC of {name} takes a variable",
            given["SRC"].span,
            "put the value into a variable of the right type and give that",
        )
        return ()
    place = Dereference(node.span, variant, value.type)
    return (_if_type(node.span, variant, value.type, checked.Assignment(node.span, place, value)),)


def _variant(ctx: Context, node: ast.Expression, where: str) -> Place | None:
    value = check_expression(ctx, node)
    if value.type == ERRONEOUS:
        return None
    if refers_to_anything(value.type) and isinstance(value, Place):
        return value
    ctx.findings.error(
        "FB4010",
        f"{where} takes VARIANT, not {spelled(value.type)}",
        node.span,
        "assign variables of other types by :=",
    )
    return None


def _got(ctx: Context, span: Span, variant: Place, target: Place) -> checked.If:
    kind = wanted = source = target.type
    if isinstance(kind, StringType):
        wanted, source = StringType(0, kind.wide), StringType(_LONGEST, kind.wide)
    value = coerce(ctx, Dereference(span, variant, source), kind, "VariantGet")
    return _if_type(span, variant, wanted, checked.Assignment(span, target, value))


def _if_type(
    span: Span, variant: Place, wanted: Type, done: Statement, otherwise: tuple[Statement, ...] = ()
) -> checked.If:
    test = TypeTest(span, variant, False, wanted, BOOL)
    return checked.If(span, (checked.Branch(span, test, (done,)),), otherwise)


# --- attempts -------------------------------------------------------------------------------------


def assignment_attempt(ctx: Context, node: ast.Assignment) -> Sequence[Statement]:
    """`reference ?= variant`: a reference to what the VARIANT refers to, NULL for another type."""
    target = check_target(ctx, node.target, "?=")
    value = check_expression(ctx, node.value)
    if target is None or value.type == ERRONEOUS:
        return ()
    kind = target.type
    if not isinstance(kind, ReferenceType) or refers_to_anything(kind):
        ctx.findings.error(
            "FB4092",
            f"?= binds a reference, and {spelled(kind)} is none",
            node.target.span,
            "declare the variable on its left as REF_TO, or read the value by VariantGet",
        )
        return ()
    nothing = checked.Assignment(node.span, target, ReferenceTo(node.span, None, kind))
    if value.type == NULL:
        return (nothing,)
    if value.type != VARIANT_VALUE or not isinstance(value, Place):
        ctx.findings.error(
            "FB4010",
            f"?= takes VARIANT, not {spelled(value.type)}",
            node.value.span,
            "assign a reference of the same type by :=, or REF(variable)",
        )
        return ()
    if kind.target == ERRONEOUS:
        return ()
    found = ReferenceTo(node.span, Dereference(node.span, value, kind.target), kind)
    done = checked.Assignment(node.span, target, found)
    return (_if_type(node.span, value, kind.target, done, (nothing,)),)
