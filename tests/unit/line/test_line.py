"""Who hears what on the RS-485 line, and when."""

import pytest

from harness.kernel import NS_PER_MS, Kernel
from harness.line import (
    DRIVE_FORMAT,
    FRAMING_ERROR,
    GATEWAY_FORMAT,
    PARITY_ERROR,
    Disturbance,
    Line,
    Parity,
    Reception,
    Role,
    SerialFormat,
    Topology,
    Transmission,
)

REQUEST = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")


class Listener:
    """A node that writes down what it hears."""

    def __init__(self, line: Line, role: Role, format: SerialFormat) -> None:  # noqa: A002
        self.heard: list[Reception] = []
        self.port = line.attach(self, role, format)

    def receive(self, reception: Reception) -> None:
        self.heard.append(reception)

    @property
    def data(self) -> list[bytes]:
        return [reception.data for reception in self.heard]


class Bench:
    """A master and two slaves on one line."""

    def __init__(self, topology: Topology = Topology.FOUR_WIRE, seed: int = 1) -> None:
        self.kernel = Kernel(seed)
        self.line = Line(self.kernel, topology)
        self.master = Listener(self.line, Role.MASTER, GATEWAY_FORMAT)
        self.one = Listener(self.line, Role.SLAVE, DRIVE_FORMAT)
        self.two = Listener(self.line, Role.SLAVE, DRIVE_FORMAT)


@pytest.mark.fact("tos.sub.serial")
@pytest.mark.fact("tos.t.wire")
def test_eight_bytes_take_4_58_ms_from_the_gateway_and_5_ms_from_a_drive() -> None:
    bench = Bench()
    sent = bench.master.port.transmit(REQUEST)
    bench.kernel.run_until(sent.end_ns - 1)
    assert bench.one.heard == []
    bench.kernel.run_until(sent.end_ns)
    assert bench.one.data == [REQUEST]
    assert sent.end_ns == 4_583_333
    answer = bench.one.port.transmit(REQUEST)
    assert answer.end_ns - answer.start_ns == 5_000_000


def test_receiver_can_tell_when_each_byte_was_there() -> None:
    bench = Bench()
    bench.master.port.transmit(REQUEST)
    bench.kernel.run_for(10 * NS_PER_MS)
    reception = bench.one.heard[0]
    assert [reception.byte_end_ns(at) for at in (0, 1, 7)] == [572_916, 1_145_833, 4_583_333]
    assert (reception.start_ns, reception.end_ns, reception.byte_ns) == (0, 4_583_333, 572_916)


def test_a_transmission_is_one_event() -> None:
    bench = Bench()
    sent = bench.master.port.transmit(REQUEST)
    assert bench.kernel.next_event_ns() == sent.end_ns
    bench.kernel.run_until(sent.end_ns)
    assert bench.kernel.next_event_ns() is None


def test_on_four_wires_slaves_hear_the_master_only_and_the_master_hears_slaves() -> None:
    bench = Bench()
    bench.master.port.transmit(b"ask")
    bench.one.port.transmit(b"tell")
    bench.kernel.run_for(20 * NS_PER_MS)
    assert (bench.master.data, bench.one.data, bench.two.data) == ([b"tell"], [b"ask"], [b"ask"])
    assert bench.master.heard[0].marks is None


def test_on_two_wires_everybody_hears_everybody_else() -> None:
    bench = Bench(Topology.TWO_WIRE)
    bench.one.port.transmit(b"tell")
    bench.kernel.run_for(20 * NS_PER_MS)
    assert (bench.master.data, bench.one.data, bench.two.data) == ([b"tell"], [], [b"tell"])


@pytest.mark.fact("tos.t.gap")
@pytest.mark.parametrize("topology", Topology)
def test_two_slaves_that_answer_at_once_collide(topology: Topology) -> None:
    bench = Bench(topology)
    bench.one.port.transmit(bytes(8))
    bench.kernel.run_for(3 * NS_PER_MS)
    bench.two.port.transmit(bytes(8))
    bench.kernel.run_for(20 * NS_PER_MS)
    first, second = bench.master.heard
    assert first.marks is not None
    assert second.marks is not None
    # 3 ms are 4.8 bytes of 12 bits: bytes 0 to 3 came undisturbed, the others overlap
    assert [mark != 0 for mark in first.marks] == [False] * 4 + [True] * 4
    assert [mark != 0 for mark in second.marks] == [True] * 4 + [False] * 4
    assert first.transmission.collided
    assert second.data[4:] == bytes(4)


def test_on_two_wires_master_and_slave_collide_and_a_sender_is_deaf() -> None:
    bench = Bench(Topology.TWO_WIRE)
    bench.master.port.transmit(bytes(8))
    bench.one.port.transmit(bytes(4))
    bench.kernel.run_for(20 * NS_PER_MS)
    # four characters of 12 bits overlap five of 11 bits
    assert bench.one.data == [bytes(3)]
    assert bench.one.heard[0].positions == (5, 6, 7)
    assert bench.one.heard[0].byte_end_ns(0) == GATEWAY_FORMAT.duration_ns(6)
    assert bench.master.data == []
    assert len(bench.two.heard) == 2


def test_senders_one_behind_the_other_do_not_collide() -> None:
    bench = Bench()
    end_ns = bench.one.port.transmit(b"first").end_ns
    bench.kernel.run_until(end_ns)
    bench.two.port.transmit(b"second")
    bench.kernel.run_for(20 * NS_PER_MS)
    assert bench.master.data == [b"first", b"second"]
    assert not any(reception.transmission.collided for reception in bench.master.heard)


def test_one_sender_sends_one_thing_behind_the_other() -> None:
    bench = Bench()
    first = bench.master.port.transmit(b"first")
    second = bench.master.port.transmit(b"second")
    assert second.start_ns == first.end_ns
    bench.kernel.run_for(20 * NS_PER_MS)
    assert bench.one.data == [b"first", b"second"]


def test_pair_is_busy_while_somebody_sends() -> None:
    bench = Bench()
    pairs = (bench.line.master_pair, bench.line.slave_pair)
    sent = bench.master.port.transmit(REQUEST)
    assert [pair.busy for pair in pairs] == [True, False]
    bench.kernel.run_until(sent.end_ns)
    assert [pair.busy for pair in pairs] == [False, False]


@pytest.mark.parametrize("role", [Role.MASTER, Role.SLAVE])
def test_sender_that_stops_in_the_middle_leaves_the_whole_bytes(role: Role) -> None:
    bench = Bench()
    sender, hearer = (bench.master, bench.one) if role is Role.MASTER else (bench.one, bench.master)
    sender.port.transmit(REQUEST)
    sender.port.transmit(REQUEST)
    bench.kernel.run_for(2 * NS_PER_MS)
    sender.port.abort()
    bench.kernel.run_for(20 * NS_PER_MS)
    assert hearer.data == [REQUEST[:3]]
    assert hearer.heard[0].end_ns == 2 * NS_PER_MS
    assert not sender.port.transmitting


def test_broken_wire_cuts_off_the_node_behind_it() -> None:
    bench = Bench()
    bench.one.port.receive_open = True
    bench.two.port.transmit_open = True
    bench.master.port.transmit(b"ask")
    bench.two.port.transmit(b"tell")
    bench.kernel.run_for(20 * NS_PER_MS)
    assert (bench.master.data, bench.one.data, bench.two.data) == ([], [], [b"ask"])
    bench.one.port.receive_open = False
    bench.two.port.transmit_open = False
    bench.master.port.transmit(b"ask")
    bench.two.port.transmit(b"tell")
    bench.kernel.run_for(20 * NS_PER_MS)
    assert (bench.master.data, bench.one.data) == ([b"tell"], [b"ask"])


def test_wire_that_breaks_while_sending_takes_the_rest() -> None:
    bench = Bench()
    bench.master.port.transmit(REQUEST)
    bench.kernel.run_for(1 * NS_PER_MS)
    bench.master.port.transmit_open = True
    bench.kernel.run_for(20 * NS_PER_MS)
    assert bench.one.data == [REQUEST[:1]]


def test_broken_pair_carries_nothing() -> None:
    bench = Bench()
    bench.line.slave_pair.broken = True
    bench.one.port.transmit(b"tell")
    bench.master.port.transmit(b"ask")
    bench.kernel.run_for(20 * NS_PER_MS)
    assert (bench.master.data, bench.one.data) == ([], [b"ask"])


def test_detached_node_hears_nothing_and_breaks_off() -> None:
    bench = Bench()
    bench.master.port.transmit(b"ask")
    bench.one.port.transmit(b"tell")
    bench.kernel.run_for(1 * NS_PER_MS)
    bench.line.detach(bench.one.port)
    bench.kernel.run_for(20 * NS_PER_MS)
    assert (bench.master.data, bench.one.data, bench.two.data) == ([b"t"], [], [b"ask"])


def test_tap_gets_every_transmission_when_it_is_over() -> None:
    bench = Bench()
    seen: list[tuple[str, bytes, int]] = []

    def tap(transmission: Transmission) -> None:
        assert transmission.heard is not None
        seen.append((transmission.pair.name, transmission.heard.data, bench.kernel.now_ns))

    bench.line.taps.append(tap)
    bench.master.port.transmit(b"ask")
    bench.one.port.transmit(b"tell")
    bench.kernel.run_for(20 * NS_PER_MS)
    assert seen == [("master", b"ask", 1_718_750), ("slave", b"tell", 2_500_000)]


def test_bytes_from_outside_are_heard_and_collide() -> None:
    bench = Bench()
    bench.line.master_pair.inject(b"\x2f\x2f", GATEWAY_FORMAT)
    bench.kernel.run_for(20 * NS_PER_MS)
    assert bench.one.data == [b"\x2f\x2f"]
    bench.master.port.transmit(REQUEST)
    bench.line.master_pair.inject(b"\x00", GATEWAY_FORMAT)
    bench.kernel.run_for(20 * NS_PER_MS)
    assert bench.one.heard[-1].marks is not None


@pytest.mark.fact("tos.prm.restart")
def test_receiver_with_another_setting_hears_errors() -> None:
    bench = Bench()
    bench.one.port.format = SerialFormat(9600, Parity.EVEN, 1)
    bench.two.port.format = SerialFormat(19200, Parity.ODD, 1)
    bench.master.port.transmit(REQUEST)
    bench.kernel.run_for(20 * NS_PER_MS)
    assert bench.one.heard[0].marks == bytes([FRAMING_ERROR]) * 8
    assert bench.two.heard[0].marks == bytes([PARITY_ERROR]) * 8


def test_planned_disturbance_hits_the_next_transmission_only() -> None:
    bench = Bench()
    bench.line.master_pair.interference.disturb_next(
        Disturbance(lose=frozenset({1}), flip={2: 0x01, 99: 0xFF}, mark={3: FRAMING_ERROR})
    )
    bench.master.port.transmit(b"abcd")
    bench.master.port.transmit(b"abcd")
    bench.kernel.run_for(20 * NS_PER_MS)
    first, second = bench.one.heard
    assert (first.data, first.marks, first.positions) == (b"abd", bytes([0, 0, 2]), (0, 2, 3))
    assert (second.data, second.marks) == (b"abcd", None)
