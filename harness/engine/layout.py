"""Values to bytes and back, as `fbgen.lang.layout` says where they lie.

Numbers are big endian on S7, little endian on the controllers of the other dialects. STRING[n] is
room, length, characters on S7, characters with a zero behind them elsewhere. DATE_AND_TIME is BCD
with milliseconds and weekday (Sunday = 1) on S7; elsewhere it counts seconds since 1970-01-01, like
DATE, in 32 bits.
"""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime, timedelta
from struct import pack, unpack

from fbgen.dataclass import dataclass
from fbgen.lang.layout import Sizes
from fbgen.lang.types import (
    DATE_AND_TIME,
    ArrayType,
    Elementary,
    Family,
    ReferenceType,
    Scalar,
    StringType,
    StructType,
    Type,
)
from harness.engine.interface import Value

_EPOCH = datetime(1970, 1, 1, tzinfo=UTC)
_LATIN = "latin-1"


def _is_row_of_bytes(kind: ArrayType) -> bool:
    """Whether elements stand as they are, one behind the other: the buffers of telegrams."""
    element = kind.element
    if not isinstance(element, Elementary) or len(kind.bounds) != 1:
        return False
    return element.bits == 8 and element.family in (Family.BITS, Family.UNSIGNED)


@dataclass(frozen=True, slots=True)
class Layout(Sizes):
    """The rules of one kind of controller."""

    # --- values ---------------------------------------------------------------------------------

    def encode(self, kind: Type, value: Value) -> bytes:
        """The bytes of a value in the shape that `interface.Value` describes."""
        memory = bytearray(self.size_bytes(kind))
        self.write(memory, 0, kind, value)
        return bytes(memory)

    def decode(self, kind: Type, data: bytes) -> Value:
        """The value in `size_bytes(kind)` bytes; a date that is none gives 1990-01-01."""
        return self.read(data, 0, kind)

    def write(self, memory: bytearray, bit: int, kind: Type, value: Value) -> None:
        """Put a value where a variable of the type begins; of a structure what is named."""
        if isinstance(kind, StructType):
            assert isinstance(value, Mapping)
            for field, start in self.placed(kind):
                if field.name in value:
                    self.write(memory, bit + start, field.type, value[field.name])
        elif isinstance(kind, ArrayType):
            assert isinstance(value, Sequence)
            if _is_row_of_bytes(kind):
                assert len(value) == kind.count
                memory[bit >> 3 : (bit >> 3) + kind.count] = bytes(value)  # type: ignore[arg-type]
                return
            for start, element in zip(self.element_bits(kind), value, strict=True):
                self.write(memory, bit + start, kind.element, element)
        elif isinstance(kind, Elementary) and kind.bits == 1 and self.is_s7:
            mask = 1 << (bit & 7)
            memory[bit >> 3] = memory[bit >> 3] & ~mask | (mask if value else 0)
        elif not isinstance(kind, ReferenceType):  # what it points to is written by the engine
            assert isinstance(value, bool | int | float | str)
            data = self._scalar_bytes(kind, value)
            memory[bit >> 3 : (bit >> 3) + len(data)] = data

    def read(self, memory: bytes | bytearray, bit: int, kind: Type) -> Value:
        """The value of a variable of the type that begins at `bit`."""
        if isinstance(kind, StructType):
            return {
                field.name: self.read(memory, bit + start, field.type)
                for field, start in self.placed(kind)
            }
        if isinstance(kind, ArrayType):
            if _is_row_of_bytes(kind):
                return list(memory[bit >> 3 : (bit >> 3) + kind.count])
            return [
                self.read(memory, bit + start, kind.element) for start in self.element_bits(kind)
            ]
        if isinstance(kind, ReferenceType):
            return any(memory[bit >> 3 : (bit >> 3) + self.size_bytes(kind)])
        if isinstance(kind, Elementary) and kind.bits == 1:
            return bool(memory[bit >> 3] >> (bit & 7) & 1)
        return self._scalar(kind, bytes(memory[bit >> 3 : (bit >> 3) + self.size_bytes(kind)]))

    @property
    def _order(self) -> str:
        return ">" if self.is_s7 else "<"

    @property
    def _wide(self) -> str:
        return "utf-16-be" if self.is_s7 else "utf-16-le"

    def _scalar_bytes(self, kind: Type, value: Scalar) -> bytes:
        if isinstance(kind, StringType):
            return self._text_bytes(kind, str(value))
        assert isinstance(kind, Elementary)
        if kind.family is Family.REAL:
            return pack(self._order + ("f" if kind.bits == 32 else "d"), value)
        if kind.family is Family.CHAR:
            return str(value).encode(self._wide if kind.bits == 16 else _LATIN, "surrogatepass")
        number = int(value)
        if kind == DATE_AND_TIME and self.is_s7:
            return _date_and_time_bytes(number)
        size = self.size_bytes(kind)
        number &= (1 << 8 * size) - 1
        return number.to_bytes(size, "big" if self.is_s7 else "little")

    def _text_bytes(self, kind: StringType, text: str) -> bytes:
        """A text with its head or its end; what lies behind it in memory stays."""
        data = text.encode(self._wide if kind.wide else _LATIN, "surrogatepass")
        if not self.is_s7:
            return data + (b"\0\0" if kind.wide else b"\0")
        head = (kind.length, len(text))
        return (pack(">HH", *head) if kind.wide else bytes(head)) + data

    def _text(self, kind: StringType, data: bytes) -> str:
        wide = self._wide
        if not self.is_s7:
            text = data.decode(wide if kind.wide else _LATIN, "surrogatepass")
            return text[: kind.length].partition("\0")[0]
        if kind.wide:
            length = min(unpack(">H", data[2:4])[0], kind.length)
            return data[4 : 4 + 2 * length].decode(wide, "surrogatepass")
        return data[2 : 2 + min(data[1], kind.length)].decode(_LATIN)

    def _scalar(self, kind: Type, data: bytes) -> Scalar:
        if isinstance(kind, StringType):
            return self._text(kind, data)
        assert isinstance(kind, Elementary)
        if kind.family is Family.REAL:
            real: float = unpack(self._order + ("f" if kind.bits == 32 else "d"), data)[0]
            return real
        if kind.family is Family.CHAR:
            return data.decode(self._wide if kind.bits == 16 else _LATIN, "surrogatepass")
        if kind == DATE_AND_TIME and self.is_s7:
            return _date_and_time(data)
        return int.from_bytes(data, "big" if self.is_s7 else "little", signed=kind.is_signed)


S7 = Layout(is_s7=True)
PC = Layout(is_s7=False)

size_bits = S7.size_bits
size_bytes = S7.size_bytes
encode = S7.encode
decode = S7.decode


def layout_of(dialect: str) -> Layout:
    """How variables lie in memory on the controllers of a dialect."""
    return S7 if dialect in ("tia", "step7") else PC


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
