"""How a character travels, and what a receiver with another setting makes of it.

A character is one start bit, eight data bits with the lowest first, a parity bit unless the parity
is none, and the stop bits. The gateway sends 8E1, that is 11 bits, the inverters send a second stop
bit, 12 bits, and are content with one when they receive (TOSPBDP001 manual, section 1; VF-S11
communications manual E6581222, p. 4).
"""

from dataclasses import field
from enum import Enum
from sys import intern

from fbgen.dataclass import dataclass
from harness.kernel import NS_PER_S

DATA_BITS = 8
PARITY_ERROR = 1
FRAMING_ERROR = 2
_SHORT = 32
"""Characters up to which durations are kept; frames of the drives have fewer."""


class Parity(Enum):
    """The ninth bit of a character."""

    NONE = "N"
    EVEN = "E"
    ODD = "O"


@dataclass(frozen=True, slots=True)
class SerialFormat:
    """The setting of one serial port. `baud` in bit/s."""

    baud: int
    parity: Parity
    stop_bits: int
    char_bits: int = field(init=False, compare=False)
    wire: str = field(init=False, compare=False, repr=False)
    _durations_ns: tuple[int, ...] = field(init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        parity_bits = 0 if self.parity is Parity.NONE else 1
        object.__setattr__(self, "char_bits", 1 + DATA_BITS + parity_bits + self.stop_bits)
        object.__setattr__(self, "wire", intern(f"{self.baud} {DATA_BITS}{self.parity.value}"))

        durations = tuple(map(self._duration_ns, range(_SHORT + 1)))
        object.__setattr__(self, "_durations_ns", durations)

    def duration_ns(self, characters: int) -> int:
        """Time that so many characters take one right behind the other, in nanoseconds."""
        if 0 <= characters <= _SHORT:
            return self._durations_ns[characters]
        return self._duration_ns(characters)

    def _duration_ns(self, characters: int) -> int:
        return characters * self.char_bits * NS_PER_S // self.baud

    def __str__(self) -> str:
        return f"{self.wire}{self.stop_bits}"


GATEWAY_FORMAT = SerialFormat(19_200, Parity.EVEN, 1)
"""19200 8E1, 11 bits a character: what the TOSPBDP001 sends."""

DRIVE_FORMAT = SerialFormat(19_200, Parity.EVEN, 2)
"""19200 8E2, 12 bits a character: what an inverter sends that is set to 19200 and even parity."""


def parity_bit(byte: int, parity: Parity) -> int:
    """The bit that makes the number of ones even or odd; 1, the idle level, without parity."""
    if parity is Parity.NONE:
        return 1
    return (byte.bit_count() + (parity is Parity.ODD)) & 1


def marks_of_mismatch(data: bytes, sent: SerialFormat, own: SerialFormat) -> bytes:
    """Error marks of each byte for a receiver whose setting `own` is not the sender's.

    Another baud rate makes every byte a framing error. Another parity shows where the bit in the
    place of parity or stop bit is not the one that the receiver waits for.
    """
    if sent.baud != own.baud:
        return bytes([FRAMING_ERROR]) * len(data)
    if own.parity is Parity.NONE:
        return bytes(0 if parity_bit(byte, sent.parity) else FRAMING_ERROR for byte in data)
    marks = bytearray(
        PARITY_ERROR if parity_bit(byte, sent.parity) != parity_bit(byte, own.parity) else 0
        for byte in data
    )
    if sent.parity is Parity.NONE and sent.stop_bits == 1:
        for index in range(len(data) - 1):
            marks[index] |= FRAMING_ERROR
    return bytes(marks)
