"""VARIANT: asking for types, and the instructions that work on variables of any type.

Sources: TIA Portal help, "TypeOf", "CountOfElements", "MOVE_BLK_VARIANT", "Serialize",
"Deserialize", "READ_LITTLE" and the like, with the values of RET_VAL.
"""

from collections.abc import Callable, Sequence

from fbgen.lang.checked import ElementCount, Expression, SameTypes, TypeTest
from fbgen.lang.types import BOOL, BYTE, CHAR, ArrayType, Elementary, Type, is_of_type
from fbgen.source import Span
from harness.engine.reference.areas import StorageArea
from harness.engine.reference.storage import Array, Storage


def _kind(storage: Storage | None, of_elements: bool) -> Type | None:
    """The type of a variable or of its elements; None if there is nothing, or no array."""
    if storage is None or not of_elements:
        return None if storage is None else storage.kind
    return storage.kind.element if isinstance(storage.kind, ArrayType) else None


def ask(
    question: TypeTest | SameTypes | ElementCount, find: Callable[[Expression], Storage | None]
) -> bool | int:
    """The answer to a question about types; `find` says what a VARIANT refers to."""
    match question:
        case TypeTest():
            kind = _kind(find(question.variant), question.of_elements)
            return kind is not None and is_of_type(kind, question.wanted)
        case SameTypes():
            of_left, of_right = question.of_elements
            left = _kind(find(question.left), of_left)
            right = _kind(find(question.right), of_right)
            return left is not None and left == right
        case ElementCount():
            storage = find(question.variant)
            return len(storage.elements) if isinstance(storage, Array) else 0


Arguments = Sequence[Storage | int | None]


def _error(code: int) -> int:
    """A code of RET_VAL as INT."""
    return code - 0x10000


def _number(argument: Storage | int | None) -> int:
    assert isinstance(argument, int)
    return argument


def _variable(argument: Storage | int | None) -> Storage | None:
    assert not isinstance(argument, int)
    return argument


def _elements(storage: Storage) -> tuple[Type, Sequence[Storage]]:
    """The elements of an array, or the variable alone."""
    if isinstance(storage, Array):
        return storage.kind.element, storage.elements
    return storage.kind, (storage,)


def _move_block(arguments: Arguments, _span: Span) -> int:
    """Elements of one array to another one, counted from 0 on both sides."""
    source, target = _variable(arguments[0]), _variable(arguments[4])
    count, first, to_first = (_number(one) for one in arguments[1:4])
    if source is None or target is None:
        return _error(0x8151 if source is None else 0x8551)
    kind, parts = _elements(source)
    to_kind, to_parts = _elements(target)
    if kind == BOOL:
        return _error(0x8154)
    if to_kind == BOOL:
        return _error(0x8554)
    if kind != to_kind:
        return _error(0x80B4)
    if count < 1:
        return _error(0x8281)
    for room, start, code in ((parts, first, 0x8382), (to_parts, to_first, 0x8482)):
        if not 0 <= start < len(room):
            return _error(code)
        if start + count > len(room):
            return _error(code + 1)
    values = [part.read() for part in parts[first : first + count]]
    for part, value in zip(to_parts[to_first : to_first + count], values, strict=True):
        part.write(value)
    return 0


def _is_buffer(storage: Storage) -> bool:
    return isinstance(storage.kind, ArrayType) and storage.kind.element in (BYTE, CHAR)


def _serialize(arguments: Arguments, span: Span) -> int:
    """The bytes of a variable into a buffer from a position on, which goes on behind them."""
    source, buffer, position = (_variable(one) for one in arguments)
    if source is None or buffer is None or position is None:
        return _error(0x8150 if source is None else 0x8250)
    if not _is_buffer(buffer):
        return _error(0x8254)
    data, area = StorageArea(source, span).read(), StorageArea(buffer, span)
    start = position.read()
    assert isinstance(start, int)
    if not 0 <= start < area.length:
        return _error(0x8382)
    if start + len(data) > area.length:
        return _error(0x8253)
    area.write(area.read()[:start] + data)
    position.write(start + len(data))
    return 0


def _deserialize(arguments: Arguments, span: Span) -> int:
    """The bytes of a buffer from a position on into a variable."""
    buffer, target, position = (_variable(one) for one in arguments)
    if buffer is None or target is None or position is None:
        return _error(0x8150 if buffer is None else 0x8250)
    if not _is_buffer(buffer):
        return _error(0x8154)
    data, area = StorageArea(buffer, span).read(), StorageArea(target, span)
    start = position.read()
    assert isinstance(start, int)
    if not 0 <= start < len(data):
        return _error(0x8382)
    if start + area.length > len(data):
        return _error(0x8153)
    area.write(data[start : start + area.length])
    position.write(start + area.length)
    return 0


def _is_single(storage: Storage | None) -> bool:
    """True for a variable of an elementary type whose bytes have an order."""
    kind = None if storage is None else storage.kind
    return isinstance(kind, Elementary) and kind.bits >= BYTE.bits


def _writing(order: int) -> Callable[[Arguments, Span], int]:
    """WRITE_BIG and WRITE_LITTLE: `order` is the step through the bytes."""

    def write(arguments: Arguments, span: Span) -> int:
        source, buffer, position = (_variable(one) for one in arguments)
        if not _is_single(source) or not _is_bytes(buffer):
            return _error(0x80B4)
        assert source is not None
        assert buffer is not None
        data = StorageArea(source, span).read()[::order]
        problem, start = _room(buffer, position, len(data), span)
        if problem:
            return problem
        area = StorageArea(buffer, span)
        area.write(area.read()[:start] + data)
        _move_on(position, start + len(data))
        return 0

    return write


def _reading(order: int) -> Callable[[Arguments, Span], int]:
    """READ_BIG and READ_LITTLE."""

    def read(arguments: Arguments, span: Span) -> int:
        buffer, target, position = (_variable(one) for one in arguments)
        if not _is_single(target) or not _is_bytes(buffer):
            return _error(0x80B4)
        assert target is not None
        assert buffer is not None
        area = StorageArea(target, span)
        problem, start = _room(buffer, position, area.length, span)
        if problem:
            return problem
        data = StorageArea(buffer, span).read()[start : start + area.length]
        area.write(data[::order])
        _move_on(position, start + area.length)
        return 0

    return read


def _is_bytes(storage: Storage | None) -> bool:
    kind = None if storage is None else storage.kind
    return isinstance(kind, ArrayType) and kind.element == BYTE


def _room(buffer: Storage, position: Storage | None, count: int, span: Span) -> tuple[int, int]:
    """What is wrong with the position, 0 for nothing, and the position."""
    start = 0 if position is None else position.read()
    assert isinstance(start, int)
    length = StorageArea(buffer, span).length
    if not 0 <= start < length:
        return _error(0x8382), start
    return (_error(0x8383) if start + count > length else 0), start


def _move_on(position: Storage | None, end: int) -> None:
    if position is not None:
        position.write(end)


ON_VARIANTS: dict[str, Callable[[Arguments, Span], int]] = {
    "MOVE_BLK_VARIANT": _move_block,
    "SERIALIZE": _serialize,
    "DESERIALIZE": _deserialize,
    "WRITE_BIG": _writing(1),
    "WRITE_LITTLE": _writing(-1),
    "READ_BIG": _reading(1),
    "READ_LITTLE": _reading(-1),
}
"""By canonical name; each gives its RET_VAL."""
