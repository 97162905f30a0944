"""Binary coded decimal numbers, and bits counted and numbered.

S7 codes a signed number in three or seven digits and a sign, which is negative if its top bit is
set; the standard codes an unsigned number with a digit in each four bits. Sources: TIA Portal help,
"BCD16", "BCD32", "DECO", "ENCO", "BITSUM"; IEC 61131-3 third edition, table 22.
"""

from collections.abc import Callable, Sequence

from fbgen.lang.types import Elementary, Scalar
from harness.engine.faults import not_decimal, value_out_of_range
from harness.engine.reference.functions import Function, Signature


def _whole(value: Scalar) -> int:
    assert isinstance(value, int)
    return value


def _digits(value: int, count: int) -> list[int]:
    return [value >> 4 * place & 15 for place in range(count - 1, -1, -1)]


def _number(value: int, count: int, signature: Signature) -> int:
    """The number in the low `count` digits. Raises FB6014."""
    digits = _digits(value, count)
    if max(digits) > 9:
        raise not_decimal(signature.span, value)
    return int("".join(map(str, digits)))


def _coded(number: int, count: int) -> int:
    return int(f"{number:0{count}d}", 16)


def _of_signed(count: int) -> Function:
    def convert(values: Sequence[Scalar], signature: Signature) -> Scalar:
        value = _whole(values[0])
        number = _number(value, count, signature)
        return -number if value >> (4 * count + 3) & 1 else number

    return convert


def _to_signed(count: int) -> Function:
    """Raises FB6006 for more than `count` digits."""

    def convert(values: Sequence[Scalar], signature: Signature) -> Scalar:
        value = _whole(values[0])
        if abs(value) >= 10**count:
            raise value_out_of_range(signature.span, value, signature.result)
        return (15 << 4 * count if value < 0 else 0) | _coded(abs(value), count)

    return convert


def _of_unsigned(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """FROM_BCD. Raises FB6014, and FB6006 if the type is too narrow."""
    number = _number(_whole(values[0]), signature.number.bits // 4, signature)
    assert isinstance(signature.result, Elementary)
    if number > signature.result.maximum:
        raise value_out_of_range(signature.span, number, signature.result)
    return number


def _to_unsigned(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """TO_BCD. Raises FB6006 for too many digits."""
    value = _whole(values[0])
    assert isinstance(signature.result, Elementary)
    count = signature.result.bits // 4
    if value >= 10**count:
        raise value_out_of_range(signature.span, value, signature.result)
    return _coded(value, count)


def _is_decimal(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return max(_digits(_whole(values[0]), signature.number.bits // 4)) <= 9


def _ones(values: Sequence[Scalar], signature: Signature) -> Scalar:
    return bin(_whole(values[0])).count("1")


def _lowest_one(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """ENCO: the place of the lowest 1; 0 if there is none."""
    digits = f"{_whole(values[0]):b}"[::-1]
    return max(digits.find("1"), 0)


def _one_bit(values: Sequence[Scalar], signature: Signature) -> Scalar:
    """DECO: the places count modulo the width."""
    assert isinstance(signature.result, Elementary)
    return 1 << _whole(values[0]) % signature.result.bits


def _in_order(big_endian: bool) -> Callable[[Sequence[Scalar], Signature], Scalar]:
    """To and from a byte order: S7 is big endian, everything else little endian."""

    def convert(values: Sequence[Scalar], signature: Signature) -> Scalar:
        value, kind = _whole(values[0]), signature.number
        if big_endian == signature.on_s7:
            return value
        octets = value.to_bytes(kind.bits // 8, "big", signed=kind.is_signed)
        return int.from_bytes(octets, "little", signed=kind.is_signed)

    return convert


BIT_FUNCTIONS: dict[str, Function] = {
    "BCD16_TO_INT": _of_signed(3),
    "INT_TO_BCD16": _to_signed(3),
    "BCD32_TO_DINT": _of_signed(7),
    "DINT_TO_BCD32": _to_signed(7),
    "FROM_BCD": _of_unsigned,
    "TO_BCD": _to_unsigned,
    "IS_VALID_BCD": _is_decimal,
    "BITSUM": _ones,
    "ENCO": _lowest_one,
    "DECO": _one_bit,
    "TO_BIG_ENDIAN": _in_order(big_endian=True),
    "FROM_BIG_ENDIAN": _in_order(big_endian=True),
    "TO_LITTLE_ENDIAN": _in_order(big_endian=False),
    "FROM_LITTLE_ENDIAN": _in_order(big_endian=False),
}
"""By canonical name."""
