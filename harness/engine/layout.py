"""How a variable lies in memory on S7: values to bytes and back.

Numbers are big endian. BOOLs are packed from bit 0 upwards; one byte wide types take the next
byte; everything wider, arrays and structures start at an even byte, arrays and structures end at
one too. STRING[n] is n + 2 bytes: room, length, characters; WSTRING[n] the same in words. Each row
of an array of several dimensions starts at an even byte. DATE_AND_TIME is BCD with milliseconds
and weekday (Sunday = 1).
Sources: STEP 7 System Software reference, "Format of the data type ..."; TIA Portal help, "Basics
of data types"; rows of arrays are inferred from "Format of ARRAY".
"""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime, timedelta
from struct import pack, unpack

from fbgen.lang.types import (
    DATE_AND_TIME,
    ArrayType,
    Elementary,
    Family,
    Scalar,
    StringType,
    StructType,
    Type,
)
from harness.engine.faults import no_layout
from harness.engine.interface import Value

_EPOCH = datetime(1970, 1, 1, tzinfo=UTC)
_LATIN = "latin-1"
_WIDE = "utf-16-be"


def size_bits(kind: Type) -> int:
    """The size in bits; only BOOL is not whole bytes. Raises FB6013 for types without layout."""
    if isinstance(kind, Elementary):
        return kind.bits
    if isinstance(kind, StringType):
        return _even((kind.length + 2) * (16 if kind.wide else 8))
    if isinstance(kind, ArrayType):
        return _rows_bits(kind, 0)
    if isinstance(kind, StructType):
        end = 0
        for field in kind.fields:
            end = _aligned(end, field.type) + size_bits(field.type)
        return _even(end)
    raise no_layout(None, kind)


def size_bytes(kind: Type) -> int:
    """The size in bytes; a BOOL takes one."""
    return (size_bits(kind) + 7) // 8


def encode(kind: Type, value: Value) -> bytes:
    """The bytes of a value in the shape that `interface.Value` describes."""
    memory = bytearray(size_bytes(kind))
    _write(memory, 0, kind, value)
    return bytes(memory)


def decode(kind: Type, data: bytes) -> Value:
    """The value in `size_bytes(kind)` bytes; a date that is none gives 1990-01-01."""
    return _read(data, 0, kind)


def _aligned(bit: int, kind: Type) -> int:
    """The first bit from `bit` on where a variable of the type may start."""
    if isinstance(kind, Elementary) and kind.bits == 1:
        return bit
    if isinstance(kind, Elementary) and kind.bits == 8:
        return (bit + 7) & ~7
    return _even(bit)


def _even(bit: int) -> int:
    return (bit + 15) & ~15


def _rows_bits(kind: ArrayType, dimension: int) -> int:
    first, last = kind.bounds[dimension]
    if dimension + 1 < len(kind.bounds):
        return (last - first + 1) * _rows_bits(kind, dimension + 1)
    return _even((last - first + 1) * _stride(kind.element))


def _stride(element: Type) -> int:
    return size_bits(element)


def _element_bits(kind: ArrayType, start: int) -> list[int]:
    """The first bit of each element, in flat order."""
    row = kind.bounds[-1][1] - kind.bounds[-1][0] + 1
    row_bits = _rows_bits(kind, len(kind.bounds) - 1)
    stride = _stride(kind.element)
    return [start + (i // row) * row_bits + (i % row) * stride for i in range(kind.count)]


def _write(memory: bytearray, bit: int, kind: Type, value: Value) -> None:
    if isinstance(kind, StructType):
        assert isinstance(value, Mapping)
        position = bit
        for field in kind.fields:
            position = _aligned(position, field.type)
            _write(memory, position, field.type, value[field.name])
            position += size_bits(field.type)
    elif isinstance(kind, ArrayType):
        assert isinstance(value, Sequence)
        for position, element in zip(_element_bits(kind, bit), value, strict=True):
            _write(memory, position, kind.element, element)
    elif isinstance(kind, Elementary) and kind.bits == 1:
        mask = 1 << (bit & 7)
        memory[bit >> 3] = memory[bit >> 3] & ~mask | (mask if value else 0)
    else:
        assert isinstance(value, bool | int | float | str)
        data = _scalar_bytes(kind, value)
        memory[bit >> 3 : (bit >> 3) + len(data)] = data


def _read(data: bytes, bit: int, kind: Type) -> Value:
    if isinstance(kind, StructType):
        parts: dict[str, Value] = {}
        position = bit
        for field in kind.fields:
            position = _aligned(position, field.type)
            parts[field.name] = _read(data, position, field.type)
            position += size_bits(field.type)
        return parts
    if isinstance(kind, ArrayType):
        return [_read(data, position, kind.element) for position in _element_bits(kind, bit)]
    if isinstance(kind, Elementary) and kind.bits == 1:
        return bool(data[bit >> 3] >> (bit & 7) & 1)
    return _scalar(kind, data[bit >> 3 : (bit >> 3) + size_bytes(kind)])


def _scalar_bytes(kind: Type, value: Scalar) -> bytes:
    size = size_bytes(kind)
    if isinstance(kind, StringType):
        text = str(value)
        if kind.wide:
            head = pack(">HH", kind.length, len(text))
            return (head + text.encode(_WIDE, "surrogatepass")).ljust(size, b"\0")
        return (bytes((kind.length, len(text))) + text.encode(_LATIN)).ljust(size, b"\0")
    assert isinstance(kind, Elementary)
    if kind.family is Family.REAL:
        return pack(">f" if kind.bits == 32 else ">d", value)
    if kind.family is Family.CHAR:
        return str(value).encode(_WIDE if kind.bits == 16 else _LATIN, "surrogatepass")
    if kind == DATE_AND_TIME:
        return _date_and_time_bytes(int(value))
    return (int(value) & ((1 << kind.bits) - 1)).to_bytes(size, "big")


def _scalar(kind: Type, data: bytes) -> Scalar:
    if isinstance(kind, StringType):
        if kind.wide:
            length = min(unpack(">H", data[2:4])[0], kind.length)
            return data[4 : 4 + 2 * length].decode(_WIDE, "surrogatepass")
        return data[2 : 2 + min(data[1], kind.length)].decode(_LATIN)
    assert isinstance(kind, Elementary)
    if kind.family is Family.REAL:
        number: float = unpack(">f" if kind.bits == 32 else ">d", data)[0]
        return number
    if kind.family is Family.CHAR:
        return data.decode(_WIDE if kind.bits == 16 else _LATIN, "surrogatepass")
    if kind == DATE_AND_TIME:
        return _date_and_time(data)
    return int.from_bytes(data, "big", signed=kind.is_signed)


def _date_and_time_bytes(nanoseconds: int) -> bytes:
    moment = _EPOCH + timedelta(microseconds=nanoseconds // 1000)
    milliseconds = moment.microsecond // 1000
    numbers = (moment.year % 100, moment.month, moment.day, moment.hour, moment.minute)
    head = bytes(_bcd(number) for number in (*numbers, moment.second, milliseconds // 10))
    weekday = moment.isoweekday() % 7 + 1
    return head + bytes(((milliseconds % 10) << 4 | weekday,))


def _date_and_time(data: bytes) -> int:
    year, month, day, hour, minute, second, hundredths = (_from_bcd(byte) for byte in data[:7])
    try:
        moment = datetime(
            *(year + (1900 if year >= 90 else 2000), month, day, hour, minute, second),
            microsecond=(hundredths * 10 + min(data[7] >> 4, 9)) * 1000,
            tzinfo=UTC,
        )
    except ValueError:
        moment = datetime(1990, 1, 1, tzinfo=UTC)
    return (moment - _EPOCH) // timedelta(microseconds=1) * 1000


def _bcd(number: int) -> int:
    return number // 10 << 4 | number % 10


def _from_bcd(byte: int) -> int:
    return min(byte >> 4, 9) * 10 + min(byte & 15, 9)
