"""Block communication of the Toshiba protocol: X writes up to two words and reads up to five.

    2FH [INV-NO] 58H nW nR W1 W2 SUM            2FH [INV-NO] 59H nR STATUS R1 .. R5 SUM

Which ComNos the words belong to is chosen in the drive: F870 and F871 for those written, F875 to
F879 for those read. Binary only. Sources: VF-S15 RS485 manual E6581913, pp. 13-16; VF-AS1 RS485
manual E6581315, pp. 13-16, 19.

A number of words to write above 2 is a format error, which a drive meets with silence; a number of
words to read above 5 is taken as 0 (E6581913, p. 13). A wrong sum is refused with code 4
(E6581315, p. 19). Inferred: how Y is divided into fields, from its printed example; that there are
as many W as nW says; that a tripped drive answers with y, 79H, as with all other commands.
"""

from functools import lru_cache
from struct import Struct

from fbgen.dataclass import dataclass
from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import (
    BINARY_START,
    TRIPPED_BIT,
    Address,
    BadRequest,
    ErrorCode,
    ErrorReply,
    Reply,
    Request,
    seal,
)

MOST_WRITTEN = 2
MOST_READ = 5
REQUEST_CMD = 0x58
REPLY_CMD = 0x59

_HEAD = Struct(">BBB").pack
_WORDS = tuple(Struct(f">{count}H") for count in range(MOST_READ + 1))


@dataclass(frozen=True, slots=True)
class BlockRequest:
    """X: write `words`, at most two, then read the first `reads` of the five chosen ComNos."""

    address: Address
    words: tuple[int, ...]
    reads: int


@dataclass(frozen=True, slots=True)
class BlockReply:
    """Y: the words read. Of `status` only 00H is known."""

    address: Address
    words: tuple[int, ...]
    status: int = 0
    tripped: bool = False


def encode_request(request: BlockRequest) -> bytes:
    """The frame of a request. ValueError for more words than there can be."""
    words, reads = request.words, request.reads
    if len(words) > MOST_WRITTEN or not 0 <= reads <= MOST_READ:
        raise ValueError(f"a block has at most 2 words to write and 5 to read, not {request}")
    number = toshiba_binary.number_bytes(request.address)
    return seal(number + _HEAD(REQUEST_CMD, len(words), reads) + _WORDS[len(words)].pack(*words))


def encode_reply(reply: BlockReply) -> bytes:
    """The frame of a reply. ValueError for more than five words."""
    words = reply.words
    if len(words) > MOST_READ:
        raise ValueError(f"a block has at most 5 words to read, not {len(words)}")
    number = toshiba_binary.number_bytes(reply.address)
    cmd = REPLY_CMD | TRIPPED_BIT if reply.tripped else REPLY_CMD
    return seal(number + _HEAD(cmd, len(words), reply.status) + _WORDS[len(words)].pack(*words))


def is_request(begin: bytes | bytearray) -> bool:
    """True if a block request begins so."""
    return REQUEST_CMD in begin[1:3] and begin[_command_at(begin)] == REQUEST_CMD


def request_length(begin: bytes | bytearray) -> int | None:
    """Length of the request, block or not, that begins so: None while open, 0 if it is none."""
    if not is_request(begin):
        return toshiba_binary.frame_length(begin, toshiba_binary.REQUEST_TAILS)
    return _length(begin, MOST_WRITTEN)


def reply_length(begin: bytes | bytearray) -> int | None:
    """Length of the reply, block or not, that begins so: None while open, 0 if it is none."""
    at = _command_at(begin) if len(begin) > 1 else 1
    if len(begin) <= at or begin[at] & ~TRIPPED_BIT != REPLY_CMD:
        return toshiba_binary.frame_length(begin, toshiba_binary.REPLY_TAILS)
    return _length(begin, MOST_READ)


@lru_cache(maxsize=4096)
def parse_request(frame: bytes) -> Request | BadRequest | BlockRequest | None:
    """What a binary request says, block or not; None if these bytes are not exactly one."""
    if not is_request(frame):
        return toshiba_binary.parse_request(frame)
    if frame[0] != BINARY_START or request_length(frame) != len(frame):
        return None
    address, at = toshiba_binary.split(frame)
    if sum(frame) - frame[-1] & 0xFF != frame[-1]:
        return BadRequest(address, ErrorCode.CHECKSUM)
    reads = frame[at + 2]
    words = _WORDS[frame[at + 1]].unpack_from(frame, at + 3)
    return BlockRequest(address, words, reads if reads <= MOST_READ else 0)


def parse_reply(frame: bytes) -> Reply | ErrorReply | BlockReply | None:
    """What a binary reply says, block or not; None if it is not exactly one with a right sum."""
    at = _command_at(frame) if len(frame) > 2 else 0
    if not at or frame[at] & ~TRIPPED_BIT != REPLY_CMD:
        return toshiba_binary.parse_reply(frame)
    if frame[0] != BINARY_START or reply_length(frame) != len(frame):
        return None
    if sum(frame) - frame[-1] & 0xFF != frame[-1]:
        return None
    address, at = toshiba_binary.split(frame)
    words = _WORDS[frame[at + 1]].unpack_from(frame, at + 3)
    return BlockReply(address, words, frame[at + 2], bool(frame[at] & TRIPPED_BIT))


def _command_at(begin: bytes | bytearray) -> int:
    return 2 if toshiba_binary.is_number(begin[1]) else 1


def _length(begin: bytes | bytearray, most: int) -> int | None:
    """Behind the CMD: the number of words, another byte, the words and the sum."""
    at = _command_at(begin) + 1
    if len(begin) <= at:
        return None
    count = begin[at]
    return at + 2 * count + 3 if count <= most else 0
