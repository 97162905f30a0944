"""VARIANT: questions about it, and the instructions that work on variables of any type."""

from collections.abc import Callable
from functools import partial
from typing import Any

from fbgen.lang.checked import SystemCall
from fbgen.lang.types import BOOL, BYTE, CHAR, ArrayType, Elementary, Type, is_of_type
from harness.engine.compiled.data.areas import VariableArea, cell_location, fixed_location
from harness.engine.compiled.data.memory import Memory
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.expressions.bound_variants import Variant
from harness.engine.compiled.expressions.open_arrays import OpenArray


def area_of(memory: Memory, variant: Variant) -> VariableArea:
    """The bytes of what a VARIANT is bound to."""
    locate = cell_location if is_scalar(variant.kind) else fixed_location
    return VariableArea(memory, locate(variant.kind, variant.target))


def _of_open(element: Type, array: OpenArray) -> Variant:
    return Variant(ArrayType(tuple(array.bounds), element), array.elements)


# --- questions ------------------------------------------------------------------------------------


def _has_type(variant: Variant | None, wanted: Type) -> bool:
    return variant is not None and is_of_type(variant.kind, wanted)


def _elements_have_type(variant: Variant | None, wanted: Type) -> bool:
    element = None if variant is None else variant.element
    return element is not None and is_of_type(element, wanted)


def _same_types(
    left: Variant | None, left_elements: bool, right: Variant | None, right_elements: bool
) -> bool:
    if left is None or right is None:
        return False
    kind = left.element if left_elements else left.kind
    return kind is not None and kind == (right.element if right_elements else right.kind)


def _element_count(variant: Variant | None) -> int:
    return 0 if variant is None or variant.element is None else len(variant.target)


FUNCTIONS: dict[str, Callable[..., Any]] = {
    "_Variant": Variant,
    "_variant_of_open": _of_open,
    "_has_type": _has_type,
    "_elements_have_type": _elements_have_type,
    "_same_types": _same_types,
    "_element_count": _element_count,
}
"""What generated code calls."""


# --- instructions ---------------------------------------------------------------------------------

_SIGN = 1 << 16


def _move_block(
    _memory: Memory,
    source: Variant | None,
    count: int,
    first: int,
    to_first: int,
    target: Variant | None,
) -> int:
    if source is None:
        return 0x8151 - _SIGN
    if target is None:
        return 0x8551 - _SIGN
    if BOOL in (source.kind, source.element):
        return 0x8154 - _SIGN
    if BOOL in (target.kind, target.element):
        return 0x8554 - _SIGN
    if (source.element or source.kind) != (target.element or target.kind):
        return 0x80B4 - _SIGN
    if count <= 0:
        return 0x8281 - _SIGN
    room, to_room = _element_count(source) or 1, _element_count(target) or 1
    if first < 0 or first >= room:
        return 0x8382 - _SIGN
    if first + count > room:
        return 0x8383 - _SIGN
    if to_first < 0 or to_first >= to_room:
        return 0x8482 - _SIGN
    if to_first + count > to_room:
        return 0x8483 - _SIGN
    contents = [_copied(_read(source, first + number)) for number in range(count)]
    for number, content in enumerate(contents, to_first):
        _write(target, number, content)
    return 0


def _read(variant: Variant, number: int) -> Any:
    if variant.element is not None:
        return variant.target[number]
    return variant.target.value if is_scalar(variant.kind) else variant.target


def _copied(content: Any) -> Any:
    if isinstance(content, list):
        return [_copied(one) for one in content]
    return content._copy() if hasattr(content, "_copy") else content


def _write(variant: Variant, number: int, content: Any) -> None:
    element = variant.element
    if element is not None and is_scalar(element):
        variant.target[number] = content
    elif element is None and is_scalar(variant.kind):
        variant.target.value = content
    else:
        _fill(variant.target if element is None else variant.target[number], content)


def _fill(target: Any, content: Any) -> None:
    if hasattr(target, "_assign"):
        target._assign(content)
        return
    for number, one in enumerate(content):
        if hasattr(one, "_assign") or isinstance(one, list):
            _fill(target[number], one)
        else:
            target[number] = one


def _is_buffer(variant: Variant) -> bool:
    return variant.element in (BYTE, CHAR)


def _serialize(
    memory: Memory, source: Variant | None, buffer: Variant | None, position: Variant
) -> int:
    if source is None:
        return 0x8150 - _SIGN
    if buffer is None:
        return 0x8250 - _SIGN
    if not _is_buffer(buffer):
        return 0x8254 - _SIGN
    start, room = position.target.value, len(buffer.target)
    if start < 0 or start >= room:
        return 0x8382 - _SIGN
    data = area_of(memory, source).read()
    end = start + len(data)
    if end > room:
        return 0x8253 - _SIGN
    contents = data.decode("latin-1") if buffer.element == CHAR else data
    for number, content in enumerate(contents, start):
        buffer.target[number] = content
    position.target.value = end
    return 0


def _deserialize(
    memory: Memory, buffer: Variant | None, target: Variant | None, position: Variant
) -> int:
    if buffer is None:
        return 0x8150 - _SIGN
    if target is None:
        return 0x8250 - _SIGN
    if not _is_buffer(buffer):
        return 0x8154 - _SIGN
    start, room = position.target.value, len(buffer.target)
    if start < 0 or start >= room:
        return 0x8382 - _SIGN
    area = area_of(memory, target)
    end = start + area.length
    if end > room:
        return 0x8153 - _SIGN
    area.write(area_of(memory, buffer).read()[start:end])
    position.target.value = end
    return 0


def _single(variant: Variant | None) -> bool:
    kind = None if variant is None else variant.kind
    return isinstance(kind, Elementary) and kind != BOOL


def _start(buffer: Variant, position: Variant | None, size: int) -> int:
    """Where the bytes begin; an error as a negative number."""
    start: int = 0 if position is None else position.target.value
    room = len(buffer.target)
    if start < 0 or start >= room:
        return 0x8382 - _SIGN
    return 0x8383 - _SIGN if start + size > room else start


def _write_in_order(
    memory: Memory,
    source: Variant | None,
    buffer: Variant | None,
    position: Variant | None,
    step: int,
) -> int:
    if source is None or buffer is None or not _single(source) or buffer.element != BYTE:
        return 0x80B4 - _SIGN
    data = area_of(memory, source).read()[::step]
    start = _start(buffer, position, len(data))
    if start < 0:
        return start
    for number, byte in enumerate(data, start):
        buffer.target[number] = byte
    if position is not None:
        position.target.value = start + len(data)
    return 0


def _read_in_order(
    memory: Memory,
    buffer: Variant | None,
    target: Variant | None,
    position: Variant | None,
    step: int,
) -> int:
    if target is None or buffer is None or not _single(target) or buffer.element != BYTE:
        return 0x80B4 - _SIGN
    area = area_of(memory, target)
    start = _start(buffer, position, area.length)
    if start < 0:
        return start
    end = start + area.length
    area.write(bytes(buffer.target[number] for number in range(start, end))[::step])
    if position is not None:
        position.target.value = end
    return 0


_INSTRUCTIONS: dict[str, Callable[..., int]] = {
    "MOVE_BLK_VARIANT": _move_block,
    "SERIALIZE": _serialize,
    "DESERIALIZE": _deserialize,
    "WRITE_BIG": partial(_write_in_order, step=1),
    "WRITE_LITTLE": partial(_write_in_order, step=-1),
    "READ_BIG": partial(_read_in_order, step=1),
    "READ_LITTLE": partial(_read_in_order, step=-1),
}


def run(node: SystemCall, memory: Memory, *arguments: Any) -> int:
    """One of the instructions on VARIANTs; gives its RET_VAL."""
    return _INSTRUCTIONS[node.name](memory, *arguments)
