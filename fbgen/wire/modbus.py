"""MODBUS: what requests and replies say, and the check sum of RTU frames.

Facts: MODBUS Application Protocol Specification V1.1b3, sections 4 to 7, and MODBUS over Serial
Line V1.02, sections 2.2 to 2.5. Of the functions only those that Toshiba inverters have: 03 and 06
(VF-S11 communications manual E6581222, pp. 31-35), 10H, 17H and 2BH/0EH (VF-S15 RS485 manual
E6581913, pp. 25-39). Nothing here knows an inverter: which of them takes how many words, and which
numbers exist, is the catalogue's. `modbus_rtu` spells the messages in bytes.
"""

from enum import IntEnum

from fbgen.dataclass import dataclass

BROADCAST = 0
"""Address of a request to all devices. None answers it, so it makes sense for writing only."""

HIGHEST_ADDRESS = 247
EXCEPTION_BIT = 0x80
"""Added to the function of a reply that is a refusal."""

MOST_READ = 125
MOST_WRITTEN = 123
MOST_WRITTEN_BEFORE_READING = 121
LONGEST_FRAME = 256


class Function(IntEnum):
    """The functions, under the names of this project."""

    READ = 0x03
    WRITE = 0x06
    WRITE_SEVERAL = 0x10
    READ_WRITE = 0x17
    IDENTIFY = 0x2B


class ExceptionCode(IntEnum):
    """Why a device refuses. VF-S15 manual, pp. 26, 34 and section 5.3 say when it sends which."""

    FUNCTION = 1
    ADDRESS = 2
    VALUE = 3
    CANNOT_EXECUTE = 4


@dataclass(frozen=True, slots=True)
class ReadRequest:
    """03: read `count` words from `start` on."""

    address: int
    start: int
    count: int = 1


@dataclass(frozen=True, slots=True)
class ReadReply:
    """03: the words."""

    address: int
    words: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class WriteRequest:
    """06: write one word."""

    address: int
    start: int
    word: int


@dataclass(frozen=True, slots=True)
class WriteReply:
    """06: what was written, in the very bytes of the request."""

    address: int
    start: int
    word: int


@dataclass(frozen=True, slots=True)
class WriteSeveralRequest:
    """10H: write words from `start` on."""

    address: int
    start: int
    words: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class WriteSeveralReply:
    """10H: how many words were written."""

    address: int
    start: int
    count: int


@dataclass(frozen=True, slots=True)
class ReadWriteRequest:
    """17H: write words from `write_start` on, then read `read_count` words from `read_start` on."""

    address: int
    read_start: int
    read_count: int
    write_start: int
    words: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class ReadWriteReply:
    """17H: the words read."""

    address: int
    words: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class IdentifyRequest:
    """2BH/0EH: who are you? `code` 1 to 3 asks for a group of objects, 4 for the one named."""

    address: int
    code: int = 1
    object_id: int = 0


@dataclass(frozen=True, slots=True)
class IdentifyReply:
    """2BH/0EH: objects with their numbers; 0 is the maker, 1 the product, 2 its version.

    `more_follows` says that the next request should begin at `next_object`.
    """

    address: int
    code: int
    conformity: int
    objects: tuple[tuple[int, bytes], ...]
    more_follows: bool = False
    next_object: int = 0


@dataclass(frozen=True, slots=True)
class ExceptionReply:
    """A refusal. `code` is an `ExceptionCode`, or one that the inverters do not send."""

    address: int
    function: int
    code: int


@dataclass(frozen=True, slots=True)
class BadRequest:
    """A whole frame that the addressed device refuses, whatever words it has."""

    address: int
    function: int
    error: ExceptionCode


Request = ReadRequest | WriteRequest | WriteSeveralRequest | ReadWriteRequest | IdentifyRequest
Reply = ReadReply | WriteReply | WriteSeveralReply | ReadWriteReply | IdentifyReply | ExceptionReply

_POLYNOMIAL = 0xA001
_START = 0xFFFF


def _steps() -> tuple[int, ...]:
    """What each byte does to a check sum of 0 whose two bytes are exchanged."""
    steps = []
    for byte in range(256):
        value = byte
        for _ in range(8):
            value = value >> 1 ^ (_POLYNOMIAL if value & 1 else 0)
        steps.append((value & 0xFF) << 8 | value >> 8)
    return tuple(steps)


_STEPS = _steps()


def crc(data: bytes) -> int:
    """CRC-16: polynomial A001H, from FFFFH on (MODBUS over Serial Line V1.02, section 6.2.2).

    The number has its bytes in the order of the frame, so that B5A6H goes out as B5 A6. It is 0
    over a frame with its right check sum.
    """
    value = _START
    for byte in data:
        value = (value & 0xFF) << 8 ^ _STEPS[value >> 8 ^ byte]
    return value


def seal(payload: bytes) -> bytes:
    """A frame around address, function and data, whatever they are."""
    value = crc(payload)
    return b"%b%c%c" % (payload, value >> 8, value & 0xFF)
