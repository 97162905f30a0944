"""Absolute addresses: located variables and direct access to I, Q, M, the hardware and DBs.

Numbers are big endian, `%MX3.5` is bit 5 of byte 3, as on S7. Images and bit memory belong to the
controller, a data block to the program.
"""

from collections.abc import Callable
from struct import pack, unpack

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Address
from fbgen.lang.types import Elementary, Family, Scalar
from fbgen.source import Span
from harness.engine.environment import Environment
from harness.engine.faults import address_out_of_range, no_data_block
from harness.engine.interface import State, Value
from harness.engine.reference.storage import Storage

_SIZES = {1: "X", 8: "B", 16: "W", 32: "D", 64: "L"}


def spelling(address: Address) -> str:
    """The address as it is written: `%IW4`, `%DB100.DW2`, `%M0.3`, `%QB1:P`."""
    size = _SIZES[address.bits]
    place = f"{address.byte}.{address.bit}" if address.bits == 1 else str(address.byte)
    end = ":P" if address.peripheral else ""
    if address.area == "DB":
        return f"%DB{address.db}.DB{size}{place}{end}"
    return f"%{address.area}{'' if size == 'X' else size}{place}{end}"


@dataclass(frozen=True, slots=True)
class Memory:
    """What absolute addresses reach: the controller, and the program's data blocks by number."""

    environment: Environment
    data_block: Callable[[int], bytearray | None]


class MemoryCell(Storage):
    """A scalar that lies at an absolute address."""

    __slots__ = ("_address", "_initial", "_kind", "_memory", "_span")

    def __init__(
        self,
        kind: Elementary,
        address: Address,
        memory: Memory,
        span: Span,
        initial: Scalar | None = None,
    ) -> None:
        self._kind = kind
        self._initial = initial
        self._address = address
        self._memory = memory
        self._span = span

    @property
    def kind(self) -> Elementary:
        """The type of the scalar."""
        return self._kind

    def place(self) -> tuple[bytearray, int] | None:
        """The memory and the first bit; None past the process image, and for no data block."""
        address = self._address
        if address.peripheral:
            return None
        memory = self._memory.data_block(address.db) if address.area == "DB" else self._image()
        return None if memory is None else (memory, 8 * address.byte + address.bit)

    def read(self) -> Scalar:
        """The scalar at the address. Raises FB6010 and FB6011."""
        address = self._address
        if address.bits == 1:
            number = self._read_bytes(1)[0] >> address.bit & 1
        else:
            number = int.from_bytes(self._read_bytes(address.bits // 8), "big")
        return _from_pattern(self._kind, number)

    def write(self, value: Value) -> None:
        """Set the bytes at the address. Raises FB6010 and FB6011."""
        assert isinstance(value, bool | int | float | str)
        address = self._address
        pattern = _to_pattern(self._kind, value)
        if address.bits == 1:
            present = self._present_byte()
            mask = 1 << address.bit
            pattern = present | mask if pattern else present & ~mask
        self._write_bytes(pattern.to_bytes(max(address.bits, 8) // 8, "big"))

    def snapshot(self) -> State:
        """The memory belongs to the controller or to a data block."""
        return None

    def restore(self, state: State) -> None:
        """The memory belongs to the controller or to a data block."""

    def reset(self, fresh: Storage, warm: bool) -> None:
        """Only a declared initial value is written; the controller clears its memory itself."""
        if self._initial is not None:
            self.write(self._initial)

    def _image(self) -> bytearray:
        environment = self._memory.environment
        images = {"I": environment.inputs, "Q": environment.outputs, "M": environment.markers}
        return images[self._address.area]

    def _block(self) -> bytearray:
        block = self._memory.data_block(self._address.db)
        if block is None:
            raise no_data_block(self._span, self._address.db)
        return block

    def _present_byte(self) -> int:
        """The byte around a bit that is to be written; outputs cannot be read from hardware."""
        if self._address.peripheral:
            return self._checked(self._image(), 1)[0]
        return self._read_bytes(1)[0]

    def _read_bytes(self, count: int) -> bytes:
        address = self._address
        if address.area == "DB":
            return self._checked(self._block(), count)
        if address.peripheral:
            data = b""
            while len(data) < count:
                size = min(count - len(data), 4)
                number = self._memory.environment.read_peripheral(address.byte + len(data), size)
                data += number.to_bytes(size, "big")
            return data
        return self._checked(self._image(), count)

    def _write_bytes(self, data: bytes) -> None:
        address = self._address
        if address.area == "DB":
            memory = self._block()
            self._checked(memory, len(data))
            memory[address.byte : address.byte + len(data)] = data
        elif address.peripheral:
            for start in range(0, len(data), 4):
                part = data[start : start + 4]
                number = int.from_bytes(part, "big")
                self._memory.environment.write_peripheral(address.byte + start, len(part), number)
        else:
            image = self._image()
            self._checked(image, len(data))
            image[address.byte : address.byte + len(data)] = data

    def _checked(self, memory: bytes | bytearray, count: int) -> bytes:
        start = self._address.byte
        if start < 0 or start + count > len(memory):
            raise address_out_of_range(self._span, spelling(self._address), len(memory))
        return bytes(memory[start : start + count])


def _to_pattern(kind: Elementary, value: Scalar) -> int:
    if kind.family is Family.REAL:
        data = pack(">f" if kind.bits == 32 else ">d", value)
        return int.from_bytes(data, "big")
    if isinstance(value, str):
        return ord(value)
    return int(value) & ((1 << kind.bits) - 1)


def _from_pattern(kind: Elementary, number: int) -> Scalar:
    if kind.family is Family.BOOL:
        return bool(number)
    if kind.family is Family.REAL:
        data = number.to_bytes(kind.bits // 8, "big")
        real: float = unpack(">f" if kind.bits == 32 else ">d", data)[0]
        return real
    if kind.family is Family.CHAR:
        return chr(number)
    return number - (1 << kind.bits) if kind.is_signed and number > kind.maximum else number
