"""Whole numbers: division, powers, shifts and selections whose operands are not constant.

Source: IEC 61131-3 third edition, tables 29 to 32; TIA Portal help, "SHL", "SHR", "ROL", "ROR".
"""

import operator
from collections.abc import Callable
from typing import TypeVar

from harness.engine.compiled.library.stops import (
    Endless,
    IndexOutside,
    NoFit,
    NoInput,
    OutsideLimits,
    StepZero,
    ZeroDivisor,
)

_Value = TypeVar("_Value")


def quotient(left: int, right: int) -> int:
    """Division that cuts towards zero."""
    if right == 0:
        raise ZeroDivisor
    whole = abs(left) // abs(right)
    return whole if (left < 0) == (right < 0) else -whole


def remainder(left: int, right: int) -> int:
    """The rest of that division: it has the sign of `left`."""
    if right == 0:
        raise ZeroDivisor
    rest = abs(left) % abs(right)
    return rest if left >= 0 else -rest


def power(base: int, exponent: int, bits: int) -> int:
    """`base ** exponent` in its low `bits` bits; a negative exponent gives the whole part."""
    if exponent >= 0:
        return pow(base, exponent, 1 << bits)
    if base == 0:
        raise ZeroDivisor
    if base in (1, -1):
        return base if exponent % 2 else 1
    return 0


def scaled(ticks: int, factor: float, low: int, high: int) -> int:
    """A duration times a number, to the nearest tick."""
    return _to_ticks(ticks * factor, low, high)


def divided(ticks: int, divisor: float, low: int, high: int) -> int:
    """A duration divided by a number, to the nearest tick."""
    if divisor == 0:
        raise ZeroDivisor
    return _to_ticks(ticks / divisor, low, high)


def _to_ticks(value: float, low: int, high: int) -> int:
    if value - value == 0 and low <= (ticks := round(value)) <= high:
        return ticks
    raise NoFit(value)


def shift_left(value: int, places: int, bits: int) -> int:
    """SHL of an unsigned value; a negative number of places counts as a huge one."""
    return value << places & (1 << bits) - 1 if 0 <= places < bits else 0


def shift_right(value: int, places: int, bits: int) -> int:
    """SHR of an unsigned value."""
    return value >> places if 0 <= places < bits else 0


def shift_right_signed(value: int, places: int, bits: int) -> int:
    """SHR of a signed value: the sign moves in."""
    return value >> (places if 0 <= places < bits else bits - 1)


def rotate_left(value: int, places: int, bits: int) -> int:
    """ROL of an unsigned value."""
    places %= bits
    return (value << places | value >> (bits - places)) & (1 << bits) - 1


def rotate_right(value: int, places: int, bits: int) -> int:
    """ROR of an unsigned value."""
    places %= bits
    return (value >> places | value << (bits - places)) & (1 << bits) - 1


def limit(low: _Value, value: _Value, high: _Value) -> _Value:
    """LIMIT; where the limits cross, `high` wins."""
    if value < low:  # type: ignore[operator]  # all values of elementary types have an order
        value = low
    return high if value > high else value  # type: ignore[operator]  # as above


def limit_or_operand(low: _Value, value: _Value, high: _Value) -> _Value:
    """LIMIT of TIA Portal: where the limits cross, nothing is limited."""
    return value if low > high else limit(low, value, high)  # type: ignore[operator]  # as above


def select(selector: int, values: tuple[_Value, ...]) -> _Value:
    """MUX."""
    if 0 <= selector < len(values):
        return values[selector]
    raise NoInput(selector, len(values))


def select_or_else(selector: int, values: tuple[_Value, ...], otherwise: _Value) -> _Value:
    """MUX with INELSE."""
    return values[selector] if 0 <= selector < len(values) else otherwise


def lowest_one(value: int) -> int:
    """ENCO: the place of the lowest 1; 0 if there is none."""
    return (value & -value).bit_length() - 1 if value else 0


def swapped_signed(value: int, count: int) -> int:
    """The bytes of a signed number in reverse order."""
    return int.from_bytes(value.to_bytes(count, "big", signed=True), "little", signed=True)


def bad_index(index: int, dimension: int = 1) -> int:
    """What stands where an index turned out to be outside of the array."""
    raise IndexOutside(index, dimension)


def checked_index(index: int, first: int, last: int, dimension: int = 1) -> int:
    """The index itself if it lies in the bounds."""
    if first <= index <= last:
        return index
    raise IndexOutside(index, dimension)


def limited(value: int, lowest: int, highest: int) -> int:
    """The value itself if the limits of a subrange allow it."""
    if lowest <= value <= highest:
        return value
    raise OutsideLimits(value)


def runaway() -> None:
    """What stands where the loops have begun too many passes."""
    raise Endless


def no_step() -> None:
    """What stands where the step of a FOR turned out to be zero."""
    raise StepZero


def rotated_bytes(value: int, count: int) -> int:
    """SWAP: the bytes in reverse order."""
    return int.from_bytes(value.to_bytes(count, "big"), "little")


def _chain(holds: Callable[[object, object], bool]) -> Callable[..., bool]:
    def in_order(*values: object) -> bool:
        return all(map(holds, values, values[1:]))

    return in_order


CHAINS: dict[str, Callable[..., bool]] = {
    name: _chain(getattr(operator, name)) for name in ("gt", "ge", "eq", "le", "lt")
}
"""Comparisons of each value with the next one."""
