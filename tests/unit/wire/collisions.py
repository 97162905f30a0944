"""How often flipped bits pass the 8-bit sum of the Toshiba protocol, counted one by one.

What counts is that the frame is taken for a right one that says something else. A character has
eight data bits, and a ninth where there is parity; start and stop bits are left out.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations
from math import comb

from fbgen.wire import toshiba_block
from fbgen.wire.toshiba import BadRequest

_DATA_BITS = 8


@dataclass(frozen=True, slots=True)
class Collisions:
    """Of one frame: how many double flips there are without parity, quadruple ones with it."""

    size: int
    double: int
    double_passed: int
    quadruple: int
    quadruple_passed: int


def collisions(frame: bytes, is_request: bool) -> Collisions:
    """The figures of a frame."""
    places = list(combinations(range(len(frame)), 2))
    bits = [1 << bit for bit in range(_DATA_BITS)]
    # A pair of flips that parity does not see: two data bits, or one and the parity bit.
    unseen = [first | second for first, second in combinations(bits, 2)] + bits
    one_byte = [(at, mask) for at in range(len(frame)) for mask in unseen[:-_DATA_BITS]]
    double = [(at, bit, to, other) for at, to in places for bit in bits for other in bits]
    quadruple = [(at, bit, to, other) for at, to in places for bit in unseen for other in unseen]
    assert len(one_byte) + len(double) == comb(_DATA_BITS * len(frame), 2)
    within = sum(_passes(frame, is_request, ((at, mask),)) for at, mask in one_byte)
    return Collisions(
        len(frame),
        len(one_byte) + len(double),
        within + _passed(frame, is_request, double),
        len(quadruple),
        _passed(frame, is_request, quadruple),
    )


def _passed(frame: bytes, is_request: bool, flips: list[tuple[int, int, int, int]]) -> int:
    return sum(
        _passes(frame, is_request, ((at, mask), (to, other)))
        for at, mask, to, other in flips
        if _sum_holds(frame, at, mask, to, other)
    )


def _sum_holds(frame: bytes, at: int, mask: int, to: int, other: int) -> bool:
    """What most flips fail at, looked at first to save time."""
    change = (frame[at] ^ mask) - frame[at]
    second = (frame[to] ^ other) - frame[to]
    in_sum = to == len(frame) - 1
    return (change - second if in_sum else change + second) & 0xFF == 0


def _passes(frame: bytes, is_request: bool, flips: tuple[tuple[int, int], ...]) -> bool:
    damaged = bytearray(frame)
    for at, mask in flips:
        damaged[at] ^= mask
    parse = toshiba_block.parse_request if is_request else toshiba_block.parse_reply
    message = parse(bytes(damaged))
    return message is not None and not isinstance(message, BadRequest)


FRAMES = (
    ("R without INV-NO", "read with R, no number", True),
    ("R", "read with R", True),
    ("P", "rs485.g.row1.request", True),
    ("G", "tip.trip.request", True),
    ("S to all", "set-point S to all", True),
    ("reply", "rs485.g.row3.reply", False),
    ("refusal N", "tip.error.inv.0001", False),
    ("X, two words", "block X to number 11", True),
    ("Y, five words", "block Y of number 11", False),
)
"""Title, name in `tests.frames`, whether it is a request."""


def table(frames: dict[str, bytes]) -> Iterator[str]:
    """The rows of the page."""
    for title, name, is_request in FRAMES:
        found = collisions(frames[name], is_request)
        share = 100 * found.double_passed / found.double
        among = 100 * found.quadruple_passed / found.quadruple
        yield (
            f"| {title} | `{frames[name].hex(' ').upper()}` "
            f"| {found.double:,} | {found.double_passed:,} ({share:.1f} %) "
            f"| {found.quadruple:,} | {found.quadruple_passed:,} ({among:.1f} %) |"
        )
