"""Toshiba inverter protocol: what a request and a reply say, whichever way they are spelled.

Facts: VF-S11 communications manual E6581222, sections 4.1 to 4.4 (pp. 6-13, 22); VF-AS1 RS485
manual E6581315, pp. 7-20; VF-S15 RS485 manual E6581913, pp. 5-14. The spelling in bytes is in
`toshiba_binary`, `toshiba_block` and `toshiba_ascii`; `toshiba_stream` finds frames in what comes
over a line. The rules that the codecs keep:

* Who is meant: one number, 0 to 63 in binary and 0 to 99 in ASCII; all (FFH, `**`); in ASCII all
  with one tens or units digit; without a number the one drive on the line (E6581222, pp. 9-11, 22).
* Who answers what is for several: number 0, or the smallest number of the group. Only W and P are
  valid for several (E6581222, p. 22). S and s are answered by nobody (E6581315, p. 19).
* None from a parser is what a drive meets with silence: an unknown CMD in binary, a number of one
  digit, any other wrong form, more than two words in X (E6581222, p. 11; E6581315, p. 20; E6581913,
  p. 13). Silent too are a number that is another's and a byte with an error: that the caller sees.
* `BadRequest` is what it refuses: a wrong sum with 4; an unknown command, in ASCII only, with 3;
  in ASCII data of too many digits, or none where some belong, with 1 (E6581315, p. 20).
  Codes 0, 1 and 2 of a request in good form are the drive's own to give.
"""

from enum import Enum, IntEnum
from functools import lru_cache
from typing import NamedTuple

from fbgen.dataclass import dataclass

BINARY_START = 0x2F
ASCII_START = 0x28
BROADCAST = 0xFF
"""INV-NO of a telegram to all drives, `**` in ASCII. No drive can have it."""

HIGHEST_BINARY_INV_NO = 0x3F
TRIPPED_BIT = 0x20
"""Added to the CMD of every reply while the drive is tripped: P becomes p."""


class Form(Enum):
    """How a frame is spelled; its first byte says so."""

    BINARY = "binary"
    ASCII = "ASCII"


class Command(IntEnum):
    """CMD of a request. S and s have no reply; s says that the sending master is tripped."""

    R = 0x52
    G = 0x47
    W = 0x57
    P = 0x50
    S = 0x53
    S_TRIPPED = 0x73


class ErrorCode(IntEnum):
    """What a drive says behind N or n."""

    CANNOT_EXECUTE = 0
    DATA = 1
    COM_NO = 2
    COMMAND = 3
    CHECKSUM = 4


class Group(NamedTuple):
    """ASCII address of several drives: all with this tens digit, or all with this units digit."""

    tens: int | None
    units: int | None

    def includes(self, inv_no: int) -> bool:
        """True if a drive with this number is meant."""
        return inv_no // 10 == self.tens if self.units is None else inv_no % 10 == self.units

    @property
    def lowest(self) -> int:
        """The smallest number that is meant: the only drive that answers."""
        return self.units if self.units is not None else 10 * (self.tens or 0)


Address = int | Group | None
"""INV-NO, `BROADCAST`, a group, or None where the frame leaves it out (one drive on the line)."""


@dataclass(frozen=True, slots=True)
class Request:
    """A telegram to a drive. `checked` says that it carries a checksum, as binary always does."""

    address: Address
    command: Command
    com_no: int
    data: int = 0
    form: Form = Form.BINARY
    checked: bool = True


@dataclass(frozen=True, slots=True)
class BadRequest:
    """A whole frame that the addressed drive refuses with an error code."""

    address: Address
    error: ErrorCode
    form: Form = Form.BINARY
    checked: bool = True


class Reply(NamedTuple):
    """A drive's answer: the value read or written."""

    address: Address
    command: Command
    com_no: int
    data: int
    tripped: bool = False
    form: Form = Form.BINARY
    checked: bool = True


class ErrorReply(NamedTuple):
    """A drive's refusal."""

    address: Address
    error: ErrorCode
    tripped: bool = False
    form: Form = Form.BINARY
    checked: bool = True


def checksum(data: bytes | bytearray) -> int:
    """Low byte of the sum of all bytes, the start code included."""
    return sum(data) & 0xFF


@lru_cache(maxsize=4096)
def seal(payload: bytes) -> bytes:
    """A binary frame around INV-NO, CMD, ComNo and DATA, whatever they are: 2FH, payload, SUM."""
    total = BINARY_START + sum(payload)
    return b"/%b%c" % (payload, total & 0xFF)


@lru_cache(maxsize=4096)
def is_sealed(frame: bytes) -> bool:
    """True if a frame begins with 2FH and ends with its right checksum."""
    return (
        len(frame) > 1 and frame[0] == BINARY_START and sum(frame) - frame[-1] & 0xFF == frame[-1]
    )
