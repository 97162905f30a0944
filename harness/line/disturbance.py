"""What happens to characters on their way: flipped bits, noise bursts, bytes lost, doubled, late.

Every rate is drawn from the kernel's random source by the distance to the next hit, so an
undisturbed line costs nothing and a rarely disturbed one hardly more.
"""

from collections import deque
from collections.abc import Mapping
from dataclasses import field
from math import log
from random import Random

from fbgen.dataclass import dataclass
from harness.kernel import NS_PER_S
from harness.line.serial_format import (
    DATA_BITS,
    FRAMING_ERROR,
    PARITY_ERROR,
    Parity,
    SerialFormat,
)
from harness.line.transmission import Reception, Transmission


class Rate:
    """Independent hits with one probability each, such as bit errors."""

    __slots__ = ("_distance", "_probability", "_random", "idle")

    def __init__(self, random: Random) -> None:
        self._random = random
        self._probability = 0.0
        self._distance = -1
        self.idle = True

    @property
    def probability(self) -> float:
        """Probability of a hit per trial, 0 to 1."""
        return self._probability

    @probability.setter
    def probability(self, value: float) -> None:
        if not 0.0 <= value <= 1.0:
            raise ValueError(f"a probability lies between 0 and 1, not at {value}")
        self._probability = value
        self.idle = value == 0.0
        self._distance = self._draw()

    def hits(self, trials: int) -> list[int]:
        """Which of so many trials, counted from 0, are hit."""
        if self.idle:
            return []
        hit = []
        while self._distance < trials:
            hit.append(self._distance)
            self._distance += 1 + self._draw()
        self._distance -= trials
        return hit

    def _draw(self) -> int:
        if self.idle:
            return -1
        if self._probability == 1.0:
            return 0
        return int(log(1.0 - self._random.random()) / log(1.0 - self._probability))


@dataclass(frozen=True, slots=True)
class Disturbance:
    """What shall happen to one transmission, by index of the byte.

    `lose` bytes never arrive. `flip` inverts the bits of a mask so that nobody notices on the
    line. `mark` adds `PARITY_ERROR` or `FRAMING_ERROR`.
    """

    lose: frozenset[int] = frozenset()
    flip: Mapping[int, int] = field(default_factory=dict)
    mark: Mapping[int, int] = field(default_factory=dict)


class Interference:
    """Everything that disturbs one pair; fault classes set the rates and call the methods.

    `delays` says how often a transmission is held up: from some byte on it comes `delay_ns` later.
    """

    __slots__ = (
        "_bursts",
        "_next",
        "_random",
        "bit_errors",
        "byte_doublings",
        "byte_losses",
        "delay_ns",
        "delays",
    )

    def __init__(self, random: Random) -> None:
        self._random = random
        self.bit_errors = Rate(random)
        self.byte_losses = Rate(random)
        self.byte_doublings = Rate(random)
        self.delays = Rate(random)
        self.delay_ns = 0
        self._bursts: list[tuple[int, int]] = []
        self._next: deque[Disturbance] = deque()

    def burst(self, start_ns: int, end_ns: int) -> None:
        """Every bit on the line between the two instants takes a random level."""
        self._bursts.append((start_ns, end_ns))

    def disturb_next(self, disturbance: Disturbance) -> None:
        """Disturb the next transmission that ends, or the one after those already asked for."""
        self._next.append(disturbance)

    def heard(self, transmission: Transmission) -> Reception:
        """The transmission, now over, as it arrives at an undisturbed receiver."""
        sent, start_ns, end_ns = transmission.data, transmission.start_ns, transmission.end_ns
        undisturbed = self.bit_errors.idle and self.byte_losses.idle and self.byte_doublings.idle
        if undisturbed and not (self._bursts or self._next or transmission.overlapping):
            return Reception(transmission, sent, start_ns, end_ns)
        flips = self._flips(transmission)
        lost = set(self.byte_losses.hits(len(sent)))
        doubled = self.byte_doublings.hits(len(sent))
        planned = self._next.popleft() if self._next else None
        data = bytearray(sent)
        marks = bytearray(len(data))
        for index, mask in flips.items():
            data[index], marks[index] = flipped(data[index], mask, transmission.format)
        if planned:
            for index, mask in _inside(planned.flip, data):
                data[index] ^= mask
            for index, mark in _inside(planned.mark, data):
                marks[index] |= mark
            lost |= planned.lose
        for other in transmission.overlapping:
            for index in transmission.bytes_within(other.start_ns, other.end_ns):
                data[index] = self._random.getrandbits(8)
                marks[index] |= self._random.choice((PARITY_ERROR, FRAMING_ERROR))
        errors = bytes(marks) if any(marks) else None
        heard = Reception(transmission, bytes(data), start_ns, end_ns, errors)
        if doubled:
            heard = heard.with_doubled(frozenset(doubled))
        return heard.without(frozenset(lost)) if lost else heard

    def parted(self, heard: Reception) -> tuple[Reception, Reception] | None:
        """What arrives in time and what arrives late, if this one is held up; else None."""
        if not heard.data or not self.delays.hits(1):
            return None
        return heard.parted(self._random.randrange(len(heard.data)), self.delay_ns)

    def _flips(self, transmission: Transmission) -> dict[int, int]:
        """Masks over the bits of the characters that are hit, by index of the byte."""
        bits = transmission.format.char_bits
        flips: dict[int, int] = {}
        for hit in self.bit_errors.hits(len(transmission.data) * bits):
            index, bit = divmod(hit, bits)
            flips[index] = flips.get(index, 0) ^ (1 << bit)
        if not self._bursts:
            return flips
        for start_ns, end_ns in self._bursts:
            for index in transmission.bytes_within(start_ns, end_ns):
                mask = self._burst_mask(transmission, index, start_ns, end_ns)
                flips[index] = flips.get(index, 0) ^ mask
        past_ns = transmission.start_ns - NS_PER_S
        self._bursts = [burst for burst in self._bursts if burst[1] > past_ns]
        return {index: mask for index, mask in flips.items() if mask}

    def _burst_mask(self, transmission: Transmission, index: int, start: int, end: int) -> int:
        begin = transmission.byte_start_ns(index)
        bits = transmission.format.char_bits
        length = transmission.format.duration_ns(1)
        mask = 0
        for bit in range(bits):
            middle = begin + (2 * bit + 1) * length // (2 * bits)
            if start <= middle < end:
                mask |= self._random.getrandbits(1) << bit
        return mask


def flipped(byte: int, mask: int, format: SerialFormat) -> tuple[int, int]:  # noqa: A002
    """Byte and error mark that come out when the masked bits of a character are inverted.

    Bit 0 of the mask is the start bit, then come the data bits, the parity bit if there is one,
    and the stop bits. Receivers look at the first stop bit only. Two flipped data bits go
    unnoticed: that is what the checksum is for.
    """
    data_flips = mask >> 1 & 0xFF
    rest = mask >> (1 + DATA_BITS)
    mark = FRAMING_ERROR if mask & 1 else 0
    if format.parity is not Parity.NONE:
        if data_flips.bit_count() + (rest & 1) & 1:
            mark |= PARITY_ERROR
        rest >>= 1
    if rest & 1:
        mark |= FRAMING_ERROR
    return byte ^ data_flips, mark


def _inside(by_index: Mapping[int, int], data: bytearray) -> list[tuple[int, int]]:
    return [(index, value) for index, value in by_index.items() if 0 <= index < len(data)]
