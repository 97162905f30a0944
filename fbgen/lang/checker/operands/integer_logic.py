"""Whole numbers as CODESYS and TwinCAT take them: as patterns of bits, and of mixed signs.

Source: TwinCAT 3 help, "Bit string operators"; published projects, which do it with integers too.
"""

from fbgen.lang.checked import Constant, Expression
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.types.coercion import as_typed, converted
from fbgen.lang.checker.types.literals import is_untyped
from fbgen.lang.types import BYTE, DWORD, LWORD, WORD, Elementary, Family, Type

_OF_WIDTH = {8: BYTE, 16: WORD, 32: DWORD, 64: LWORD}


def are_numbers(ctx: Context, left: Expression, right: Expression) -> bool:
    """True for whole numbers whose bits CODESYS and TwinCAT combine."""
    return (
        ctx.rules.shifts_integers
        and ctx.rules.bits_are_numbers
        and isinstance(left.type, Elementary)
        and left.type.is_integer
        and not (isinstance(left, Constant) and isinstance(right, Constant))
    )


def as_bits(
    ctx: Context, left: Expression, right: Expression
) -> tuple[Expression, Expression] | None:
    """Two whole numbers as bit strings of the wider one; None for anything else."""
    if not ctx.rules.bits_are_numbers:
        return None
    kinds = [as_typed(left).type, as_typed(right).type]
    if not all(isinstance(kind, Elementary) and _has_bits(kind) for kind in kinds):
        return None
    width = max(kind.bits for kind in kinds if isinstance(kind, Elementary))
    target = _OF_WIDTH[width]
    return converted(as_typed(left), target), converted(as_typed(right), target)


def _has_bits(kind: Elementary) -> bool:
    return kind.is_integer or kind.family is Family.BITS


def is_bit_pattern(ctx: Context, operand: Expression) -> bool:
    """True for a variable whole number, whose bits NOT turns round."""
    is_whole = isinstance(operand.type, Elementary) and operand.type.is_integer
    return ctx.rules.bits_are_numbers and is_whole and not isinstance(operand, Constant)


def as_pattern(operand: Expression) -> Expression:
    """A whole number as the bit string of its width."""
    assert isinstance(operand.type, Elementary)
    return converted(operand, _OF_WIDTH[operand.type.bits])


def type_of_mixed_signs(ctx: Context, left: Type, right: Type) -> Elementary | None:
    """In what a signed and an unsigned number are calculated: the wider one's, else the signed one.

    None for anything else.
    """
    if not ctx.rules.sign_may_change or is_untyped(left) or is_untyped(right):
        return None
    if not isinstance(left, Elementary) or not isinstance(right, Elementary):
        return None
    families = {left.family, right.family}
    if families != {Family.SIGNED, Family.UNSIGNED} or not (left.is_integer and right.is_integer):
        return None
    if left.bits != right.bits:
        return left if left.bits > right.bits else right
    return left if left.family is Family.SIGNED else right
