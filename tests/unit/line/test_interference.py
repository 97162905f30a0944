"""Noise on the line: what flips, what is noticed, and that a seed repeats it."""

import pytest

from harness.kernel import NS_PER_MS, Kernel
from harness.line import (
    FRAMING_ERROR,
    GATEWAY_FORMAT,
    PARITY_ERROR,
    Line,
    Parity,
    Rate,
    Reception,
    Role,
    SerialFormat,
)
from harness.line.disturbance import flipped
from harness.line.serial_format import marks_of_mismatch, parity_bit

EIGHT_N_ONE = SerialFormat(19200, Parity.NONE, 1)


class Sink:
    """A node that writes down what it hears."""

    def __init__(self) -> None:
        self.heard: list[Reception] = []

    def receive(self, reception: Reception) -> None:
        self.heard.append(reception)


def _send(seed: int, bit_errors: float, byte_losses: float, frames: int) -> list[Reception]:
    kernel = Kernel(seed)
    line = Line(kernel)
    sink = Sink()
    line.attach(sink, Role.SLAVE, GATEWAY_FORMAT)
    master = line.attach(Sink(), Role.MASTER, GATEWAY_FORMAT)
    line.master_pair.interference.bit_errors.probability = bit_errors
    line.master_pair.interference.byte_losses.probability = byte_losses
    for _ in range(frames):
        master.transmit(bytes(range(8)))
    kernel.run_for(frames * 5 * NS_PER_MS)
    return sink.heard


def test_bit_errors_come_as_often_as_asked() -> None:
    heard = _send(7, 0.001, 0.0, 2000)
    damaged = sum(reception.data != bytes(range(8)) or bool(reception.marks) for reception in heard)
    # 88 bits a frame: 1 - 0.999^88 = 8.4 %
    assert 130 < damaged < 210


def test_bytes_get_lost_as_often_as_asked() -> None:
    heard = _send(7, 0.0, 0.01, 1000)
    lost = 8000 - sum(len(reception.data) for reception in heard)
    assert 50 < lost < 120


def test_same_seed_gives_the_same_errors() -> None:
    def outcome(seed: int) -> list[tuple[bytes, bytes | None]]:
        return [(heard.data, heard.marks) for heard in _send(seed, 0.002, 0.005, 200)]

    assert outcome(3) == outcome(3)
    assert outcome(3) != outcome(4)


def test_burst_hits_what_is_on_the_line_meanwhile_and_nothing_else() -> None:
    kernel = Kernel(5)
    line = Line(kernel)
    sink = Sink()
    line.attach(sink, Role.SLAVE, GATEWAY_FORMAT)
    master = line.attach(Sink(), Role.MASTER, GATEWAY_FORMAT)
    byte_ns = GATEWAY_FORMAT.duration_ns(1)
    line.master_pair.interference.burst(2 * byte_ns + 10, 5 * byte_ns - 10)
    master.transmit(bytes(8))
    master.transmit(bytes(8))
    kernel.run_for(20 * NS_PER_MS)
    first, second = sink.heard
    assert first.marks is not None
    touched = [first.data[at] != 0 or first.marks[at] != 0 for at in range(8)]
    assert touched == [False, False, True, True, True, False, False, False]
    assert (second.data, second.marks) == (bytes(8), None)


@pytest.mark.parametrize(
    ("mask", "expected"),
    [
        (1 << 0, (0x0F, FRAMING_ERROR)),
        (1 << 1, (0x0E, PARITY_ERROR)),
        (1 << 8, (0x8F, PARITY_ERROR)),
        (1 << 1 | 1 << 8, (0x8E, 0)),
        (1 << 9, (0x0F, PARITY_ERROR)),
        (1 << 1 | 1 << 9, (0x0E, 0)),
        (1 << 10, (0x0F, FRAMING_ERROR)),
    ],
)
def test_flipped_bits_are_noticed_by_parity_and_stop_bit(
    mask: int, expected: tuple[int, int]
) -> None:
    assert flipped(0x0F, mask, GATEWAY_FORMAT) == expected


def test_without_parity_a_flipped_data_bit_goes_unnoticed() -> None:
    assert flipped(0x0F, 1 << 1, EIGHT_N_ONE) == (0x0E, 0)
    assert flipped(0x0F, 1 << 9, EIGHT_N_ONE) == (0x0F, FRAMING_ERROR)


def test_parity_bit_completes_the_number_of_ones() -> None:
    assert [parity_bit(0x07, parity) for parity in Parity] == [1, 1, 0]
    assert [parity_bit(0x03, parity) for parity in Parity] == [1, 0, 1]


def test_receiver_without_parity_takes_the_parity_bit_for_the_stop_bit() -> None:
    marks = marks_of_mismatch(b"\x07\x03", GATEWAY_FORMAT, EIGHT_N_ONE)
    assert marks == bytes([0, FRAMING_ERROR])


def test_receiver_with_parity_takes_the_next_start_bit_for_the_stop_bit() -> None:
    marks = marks_of_mismatch(b"\x07\x03\x07", EIGHT_N_ONE, GATEWAY_FORMAT)
    assert marks == bytes([FRAMING_ERROR, FRAMING_ERROR | PARITY_ERROR, 0])


@pytest.mark.parametrize("value", [-0.1, 1.1])
def test_probability_lies_between_0_and_1(value: float) -> None:
    with pytest.raises(ValueError, match="between 0 and 1"):
        Rate(Kernel().random).probability = value


def test_probability_1_hits_always_and_0_never() -> None:
    rate = Rate(Kernel().random)
    assert rate.hits(5) == []
    rate.probability = 1.0
    assert rate.hits(5) == [0, 1, 2, 3, 4]
    rate.probability = 0.0
    assert rate.hits(5) == []
