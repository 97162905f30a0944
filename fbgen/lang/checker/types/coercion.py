"""Giving an expression the type that its place asks for, or saying why that cannot be."""

from fbgen.lang.checked import (
    Constant,
    Convert,
    Expression,
    FieldRef,
    IndexRef,
    Place,
    ReferenceTo,
    SliceRef,
    VariableRef,
)
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.operands.operator_help import IN_CODESYS
from fbgen.lang.checker.operands.pointers import as_pointer
from fbgen.lang.checker.rules import Rules
from fbgen.lang.checker.types.conversions import (
    changes_sign,
    conversion_between,
    converts_in_codesys,
    is_implicit,
    is_likely_unchecked,
)
from fbgen.lang.checker.types.folding import fold_conversion
from fbgen.lang.checker.types.literals import (
    ERRONEOUS,
    NULL,
    UNTYPED_INTEGER,
    erroneous,
    fitted,
    is_untyped,
    settled,
    settled_bits,
)
from fbgen.lang.types import (
    BOOL,
    POINTER_VALUE,
    REAL,
    AnyType,
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
    counting_type,
    refers_to_anything,
)
from fbgen.source import Span


def spelled(kind: Type) -> str:
    """A type as a message names it."""
    if isinstance(kind, BlockType):
        return f"an instance of {kind.name}"
    if isinstance(kind, AnyType):
        return f"an area ({kind.name})"
    return kind.name


def converted(expression: Expression, target: Type) -> Expression:
    """The expression in a type that it becomes by itself; constants at once."""
    if expression.type == target:
        return expression
    if isinstance(expression, Constant):
        value = fold_conversion(expression, target)
        if value is not None:
            return Constant(expression.span, value, target)
    return Convert(expression.span, expression, target, implicit=True)


def as_typed(expression: Expression) -> Expression:
    """An untyped constant in its own type; anything else as it is."""
    return settled(expression) if isinstance(expression, Constant) else expression


def coerce(ctx: Context, expression: Expression, target: Type, where: str) -> Expression:
    """The expression as a value of `target`; reports what stands against it.

    `where` names the place for the message, as in "the condition of IF".
    """
    source = expression.type
    if source == target and not isinstance(expression, Constant):
        return expression
    if ERRONEOUS in (source, target):
        return erroneous(expression.span)
    if isinstance(target, ReferenceType) and refers_to_anything(target):
        return as_anything(ctx, expression, target, where)
    if isinstance(target, ReferenceType):
        nothing = as_null(expression, target)
        if nothing is not None:
            return nothing
        if target.is_interface:
            instance = ctx.library.objects.interfaces.value_of(expression, target)
            if instance is not None:
                return instance
    pointer = as_pointer(ctx, expression, target)
    if pointer is not None:
        return pointer
    if isinstance(expression, Constant) and (is_untyped(source) or isinstance(source, StringType)):
        return _fit(ctx, expression, target, where)
    if source == target:
        return expression
    if is_implicit(source, target, ctx.rules):
        return converted(expression, target)
    if ctx.rules.iec_check_open and is_likely_unchecked(source, target, ctx.rules):
        warn_unchecked(ctx, expression.span, source, target)
        return converted(expression, target)
    if changes_sign(source, target, ctx.rules):
        _warn_of_change(ctx, expression, target, where)
        return converted(expression, target)
    if isinstance(target, OpenArrayType) and target.takes(source):
        return expression
    limited = _limited(ctx, expression, target, where)
    if limited is not None:
        return limited
    _refuse(ctx, expression, target, where)
    return erroneous(expression.span)


def warn_unchecked(ctx: Context, span: Span, source: Type, target: Type) -> None:
    """Report once for a block that it needs TIA Portal's IEC check to be off."""
    name = ctx.block.name if ctx.block is not None else "an initial value"
    ctx.findings.repeated_warning(
        "FB4112",
        f"{name} needs the IEC check to be off",
        span,
        f"write {conversion_between(source, target)}(...); or say --iec-check off, if it is off",
    )


def _warn_of_change(ctx: Context, expression: Expression, target: Type, where: str) -> None:
    source = expression.type
    function = conversion_between(source, target)
    lost = "digits" if target == REAL else "its sign"
    ctx.findings.warning(
        "FB4111",
        f"{where} takes {target.name}, and {spelled(source)} may lose {lost}",
        expression.span,
        f"write the conversion if that is meant: {function}(...)",
    )


def as_null(expression: Expression, target: ReferenceType) -> Expression | None:
    """NULL, and 0 for a pointer, as that kind of reference; None for anything else."""
    is_zero = (
        isinstance(expression, Constant)
        and expression.type == UNTYPED_INTEGER
        and expression.value == 0
        and target.keyword not in ("REF_TO", "VARIANT")
    )
    if is_zero or expression.type == NULL:
        return ReferenceTo(expression.span, None, target)
    return None


def as_anything(
    ctx: Context, expression: Expression, target: ReferenceType, where: str
) -> Expression:
    """A variable, a VARIANT or NULL as a VARIANT, ANY or POINTER; reports anything else."""
    source = expression.type
    if source == ERRONEOUS:
        return expression
    if source == NULL:
        return ReferenceTo(expression.span, None, target)
    if refers_to_anything(source):
        if POINTER_VALUE not in (source, target):
            return expression
        _refuse(ctx, expression, target, where)
        return erroneous(expression.span)
    root = expression
    while isinstance(root, FieldRef | IndexRef):
        root = root.base
    if isinstance(root, VariableRef):
        ctx.written.add(root.variable)
    if isinstance(expression, Place) and not isinstance(root, SliceRef):
        return ReferenceTo(expression.span, expression, target)
    ctx.findings.error(
        "FB4022",
        f"{where} takes a variable, not a value",
        expression.span,
        "put the value into a variable and give that",
    )
    return erroneous(expression.span)


def _limited(ctx: Context, expression: Expression, target: Type, where: str) -> Expression | None:
    """A number as an enumeration or in a subrange; None if it does not become one by itself."""
    source = expression.type
    if not isinstance(target, Enumeration | Subrange) or not isinstance(source, Elementary):
        return None
    source = counting_type(source) if isinstance(source, Subrange) else source
    if source != target.base and not is_implicit(source, target.base, ctx.rules):
        return None
    if isinstance(target, Subrange):
        if isinstance(expression, Constant) and isinstance(expression.value, int):
            plain = Constant(expression.span, expression.value, UNTYPED_INTEGER)
            return _fit(ctx, plain, target, where)
        return Convert(expression.span, expression, target, implicit=True)
    if not ctx.rules.enumerations_are_numbers or target.strict:
        return None
    ctx.findings.warning(
        "FB4110",
        f"{where} takes {target.name} and is given a number",
        expression.span,
        f"write the name of an enumerator: {target.name}.{target.members[0][0]}",
    )
    return converted(expression, target)


def without_limits(expression: Expression) -> Expression:
    """A value of a subrange as one of its base, in which it is calculated with."""
    kind = expression.type
    return converted(expression, kind.base) if isinstance(kind, Subrange) else expression


def as_counted(ctx: Context, expression: Expression) -> Expression:
    """A value that may count as a whole number in this dialect as that number."""
    kind = expression.type
    if isinstance(kind, Enumeration) and ctx.rules.enumerations_are_numbers:
        return converted(expression, kind.base)
    return without_limits(expression)


def _fit(ctx: Context, constant: Constant, target: Type, where: str) -> Expression:
    value = fitted(constant, target)
    if value is not None:
        return Constant(constant.span, value, target)
    if isinstance(target, Enumeration) and not isinstance(constant.value, str):
        number = settled(constant)
        if fitted(constant, target.base) is not None:
            number = Constant(constant.span, constant.value, target.base)
        limited = _limited(ctx, number, target, where)
        if limited is not None:
            return limited
    if isinstance(constant.value, str):
        _refuse_text(ctx, constant, target, where)
    elif (pattern := _pattern(constant, target, ctx.rules)) is not None:
        if ctx.rules.iec_check_open:
            warn_unchecked(ctx, constant.span, pattern.type, target)
        return converted(pattern, target)
    elif _could_hold(constant, target):
        ctx.findings.error(
            "FB4014",
            f"{_written(constant)} is outside of {target.name}, which {where} takes",
            constant.span,
            _range_help(target),
        )
    else:
        _refuse(ctx, constant, target, where)
    return erroneous(constant.span)


def _pattern(constant: Constant, target: Type, rules: Rules) -> Constant | None:
    """16#FFFF for INT and -1 for WORD: without the IEC check the bits are taken as they are."""
    if rules.iec_check and not rules.iec_check_open:
        return None
    if not isinstance(target, Elementary) or isinstance(target, Enumeration | Subrange):
        return None
    if target.is_integer and "#" in constant.span.text:
        typed = settled_bits(constant)
    elif target.family is Family.BITS and isinstance(constant.value, int) and constant.value < 0:
        typed = settled(constant)
    else:
        return None
    fits = isinstance(typed.type, Elementary) and typed.type.bits <= target.bits
    return typed if fits and not is_untyped(typed.type) else None


def _refuse_text(ctx: Context, constant: Constant, target: Type, where: str) -> None:
    value = str(constant.value)
    if isinstance(target, StringType) and len(value) > target.length:
        ctx.findings.error(
            "FB4014",
            f"a text of {len(value)} characters does not fit {target.name} of {where}",
            constant.span,
            "shorten the text or declare a longer STRING",
        )
        return
    _refuse(ctx, constant, target, where)


def _could_hold(constant: Constant, target: Type) -> bool:
    """True if another value of the same kind would fit, so that it is a matter of range."""
    if not isinstance(target, Elementary) or isinstance(target, Enumeration):
        return False
    if target.family is Family.REAL:
        return True
    return isinstance(constant.value, int) and target.family in (
        Family.BOOL,
        Family.BITS,
        Family.SIGNED,
        Family.UNSIGNED,
    )


def _range_help(target: Type) -> str:
    if not isinstance(target, Elementary) or target.family is Family.REAL:
        return "use a smaller number or a wider type"
    if isinstance(target, Subrange):
        return f"the declaration allows {target.lowest} to {target.highest}"
    if target == BOOL:
        return "write TRUE or FALSE"
    if target.family is Family.BITS:
        return f"{target.name} holds 16#0 to 16#{target.maximum:X}"
    return f"{target.name} holds {target.minimum} to {target.maximum}"


def _written(constant: Constant) -> str:
    text = constant.span.text
    return text if text and len(text) <= 40 and "\n" not in text else str(constant.value)


ASSIGNMENT = "this assignment"
"""Where an assignment takes its value."""
_SAME_PARTS = {
    "tia": "both sides need parts of the same types in the same order, and arrays as long",
    "step7": "both sides need parts with the same names and types, and arrays with the same bounds",
}


def _refuse(ctx: Context, expression: Expression, target: Type, where: str) -> None:
    shown = as_typed(expression)
    source = expression.type if isinstance(shown, Constant) else shown.type
    function = conversion_between(shown.type, target)
    code, help_text = "FB4010", _mismatch_help(shown.type, target)
    if function and not (isinstance(shown, Constant) and is_untyped(expression.type)):
        code, help_text = "FB4011", f"write the conversion: {function}(...)"
    elif isinstance(expression, Constant) and is_untyped(source):
        help_text = _constant_help(target)
    elif where == ASSIGNMENT and isinstance(target, StructType | ArrayType):
        help_text = _SAME_PARTS.get(ctx.rules.dialect, help_text)
    if ctx.rules.dialect == "iec" and converts_in_codesys(source, target):
        help_text += f"; {IN_CODESYS}"
    ctx.findings.error(
        code, f"{where} takes {spelled(target)}, not {spelled(source)}", expression.span, help_text
    )


def _mismatch_help(source: Type, target: Type) -> str:
    if isinstance(target, Enumeration) and target.members:
        return f"use one of its enumerators, such as {target.name}#{target.members[0][0]}"
    if target == BOOL:
        return "compare it with something: x <> 0"
    if source == BOOL:
        return "use SEL(x, 0, 1) or a BOOL variable"
    if isinstance(target, ReferenceType) and target.is_interface:
        return f"give an instance of a block with IMPLEMENTS {target.target_name}, or NULL"
    if isinstance(target, ReferenceType):
        maker = "ADR" if target.keyword == "POINTER TO" else "REF"
        return f"write {maker}(x) of a variable of type {target.target_name}, or NULL"
    if isinstance(target, OpenArrayType):
        return f"give an array of {target.element.name} with {target.dimensions} dimensions"
    if isinstance(target, StructType | ArrayType):
        return "both sides need the same declared type: declare it once with TYPE, and use its name"
    return "use a value of that type"


def _constant_help(target: Type) -> str:
    if isinstance(target, Enumeration):
        return _mismatch_help(target, target)
    if isinstance(target, Elementary):
        if target.family is Family.DURATION:
            return f"write a duration, such as {'T' if target.bits == 32 else 'LT'}#100ms"
        if target.is_integer or target.family is Family.BITS:
            return "write a whole number, or convert it with ROUND or TRUNC"
        if target.family is Family.CHAR:
            return "write a character in quotes"
    return "use a value of that type"
