"""Operators on what is written as a number: values, masks, bits, bytes and times.

A generated text knows which entry of the catalogue a word came from; its bits are moved as if the
entry had them wrong.
"""

from collections.abc import Iterator
from dataclasses import replace

from fbgen.lang.ast import LiteralKind
from fbgen.lang.checked import (
    Assignment,
    Binary,
    Constant,
    Expression,
    FieldRef,
    IndexRef,
    InstanceCall,
    StandardBlock,
    StandardCall,
    Statement,
    VariableKind,
)
from fbgen.lang.types import BOOL, INT, TIME, WORD, Elementary, Family, counting_type
from harness.verify.mutation.mutant import Change, Edit, Operator, exchanged
from harness.verify.mutation.places import Seat, in_parentheses, is_operation, written
from harness.verify.mutation.spelling import duration, literal_of, read_real, real, whole_number

_TIMERS = ("TON", "TOF", "TP", "TONR", "IEC_TIMER")


def values(seat: Seat) -> Iterator[Change]:
    """A number one more or one less, TRUE for FALSE, a time twice as long."""
    node = seat.expression
    if not isinstance(node, Constant) or not isinstance(node.type, Elementary):
        return
    literal = literal_of(node)
    if literal is None:
        return
    kind = counting_type(node.type)
    if kind == BOOL and literal.kind is LiteralKind.BOOL:
        yield _changed(Operator.CONSTANT, seat, node, not node.value, str(not node.value).upper())
    elif kind.family is Family.REAL and isinstance(node.value, float):
        if isinstance(literal.value, float) and not node.span.text.startswith("-"):
            more = real(literal.value + 1.0)
            yield _changed(Operator.CONSTANT, seat, node, read_real(more, kind), more)
    elif kind.is_integer and isinstance(node.value, int):
        yield from _beside(seat, node, kind)
    elif kind.family is Family.BITS and isinstance(node.value, int):
        yield from _bits(seat, node, kind)
    elif kind.family is Family.DURATION and isinstance(node.value, int):
        ticks = 2 * node.value or 1000
        text = duration(kind, ticks)
        if text is not None and ticks <= kind.maximum:
            yield _changed(Operator.TIMER, seat, node, ticks, text)


def _beside(seat: Seat, node: Constant, kind: Elementary) -> Iterator[Change]:
    """One more; one less too where the number is not only compared for being equal."""
    assert isinstance(node.value, int)
    compared = isinstance(seat.parent, Binary) and seat.parent.operator in ("=", "<>")
    for value in (node.value + 1,) if compared else (node.value + 1, node.value - 1):
        text = whole_number(node, value)
        if text is None or not kind.minimum <= value <= kind.maximum:
            continue
        if isinstance(seat.parent, IndexRef) and not _is_index(seat.parent, node, value):
            continue
        yield _changed(Operator.CONSTANT, seat, node, value, text)


def _is_index(element: IndexRef, node: Constant, value: int) -> bool:
    """True if the array has an element with this index: the checker refuses any other."""
    bounds = getattr(element.base.type, "bounds", None)
    if bounds is None:
        return False
    first, last = bounds[element.indices.index(node)]
    return bool(first <= value <= last)


def _bits(seat: Seat, node: Constant, kind: Elementary) -> Iterator[Change]:
    """The lowest bit cleared, bits moved to the next free place, the two bytes exchanged."""
    value = node.value
    assert isinstance(value, int)
    found: dict[int, Operator] = {}
    cleared = value & (value - 1) if value else 1
    found[cleared] = Operator.MASK
    if value:
        lowest = value & -value
        up = lowest
        while up & value:
            up <<= 1
        if up <= kind.maximum:
            found.setdefault(value - lowest + up, Operator.BITS)
        highest = 1 << (value.bit_length() - 1)
        down = highest
        while down & value:
            down >>= 1
        if down:
            found.setdefault(value - highest + down, Operator.BITS)
    if kind.bits == 16:
        turned = (value >> 8 | value << 8) & 0xFFFF
        if turned != value:
            found.setdefault(turned, Operator.BYTE_ORDER)
    for new, operator in found.items():
        if (text := whole_number(node, new)) is not None:
            yield _changed(operator, seat, node, new, text)


def _changed(
    operator: Operator, seat: Seat, node: Constant, value: bool | int | float, text: str
) -> Change:
    return exchanged(
        operator, seat.statement, node, replace(node, value=value), Edit(node.span, text)
    )


# --- byte order -----------------------------------------------------------------------------------


def byte_order(statement: Statement) -> Iterator[Change]:
    """A word that goes to somebody else, as a part of an in-out or to the outputs, turned."""
    if not isinstance(statement, Assignment) or statement.value.type != WORD:
        return
    value = statement.value
    if isinstance(written(value), Constant) or not _leaves_the_block(statement):
        return
    eight = Constant(value.span, 8, INT)
    new = StandardCall(value.span, "ROL", (value, eight), WORD)
    edit = Edit(value.span, f"ROL(IN := {value.span.text}, N := 8)")
    yield exchanged(Operator.BYTE_ORDER, statement, value, new, edit)


def _leaves_the_block(statement: Assignment) -> bool:
    place = statement.target
    if not isinstance(place, FieldRef):
        return hasattr(place, "address")
    while isinstance(place, FieldRef | IndexRef):
        place = place.base
    variable = getattr(place, "variable", None)
    return variable is not None and variable.kind in (
        VariableKind.IN_OUT,
        VariableKind.KEPT,
        VariableKind.GLOBAL,
    )


def assembled(seat: Seat) -> Iterator[Change]:
    """`SHL(high, 8) OR low` with the two bytes exchanged."""
    node = seat.expression
    if not isinstance(node, Binary) or node.operator not in ("OR", "+"):
        return
    for shifted, other in ((node.left, node.right), (node.right, node.left)):
        if not _is_high_byte(shifted):
            continue
        assert isinstance(shifted, StandardCall)
        high = shifted.arguments[0]
        if high.type != other.type or _is_high_byte(other):
            continue
        call = replace(shifted, arguments=(other, *shifted.arguments[1:]))
        pair = (call, high) if shifted is node.left else (high, call)
        new = replace(node, left=pair[0], right=pair[1])
        first, second = sorted((high, other), key=lambda one: one.span.start)
        edits = (Edit(first.span, second.span.text), Edit(second.span, first.span.text))
        yield exchanged(Operator.BYTE_ORDER, seat.statement, node, new, *edits)
        return


def _is_high_byte(expression: Expression) -> bool:
    return (
        isinstance(expression, StandardCall)
        and expression.name == "SHL"
        and isinstance(expression.arguments[1], Constant)
        and expression.arguments[1].value == 8
    )


# --- timers ---------------------------------------------------------------------------------------


def preset_times(statement: Statement) -> Iterator[Change]:
    """A timer with a preset time that is worked out: twice as long, and over at once.

    A preset time that is written there is found among the `values`; here it is only made 0.
    """
    if not isinstance(statement, InstanceCall) or not isinstance(statement.block, StandardBlock):
        return
    if statement.block.name.partition("_")[0] not in _TIMERS:
        return
    for variable, value in statement.inputs:
        if variable.name != "PT" or value.type != TIME:
            continue
        span = value.span
        text = duration(TIME, 0)
        if text is not None and span.text != text:
            zero = Constant(span, 0, TIME)
            yield exchanged(Operator.TIMER, statement, value, zero, Edit(span, text))
        if isinstance(written(value), Constant):
            continue
        twice = Binary(span, "+", value, value, TIME)
        edits = in_parentheses(span) if is_operation(written(value)) else ()
        shown = f"({span.text})" if edits else span.text
        yield exchanged(Operator.TIMER, statement, value, twice, Edit(span, f"{shown} + {shown}"))
