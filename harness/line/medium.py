"""The RS-485 line: who hears whom, when bytes arrive, what happens when two send at once.

The TOSPBDP001 stands on four wires (its manual, section 1): one pair on which only the gateway
sends, and one on which only the drives send. So the gateway never collides with a drive and drives
do not hear each other, but two drives that answer at once do collide. On two wires everybody hears
everybody else. A transmission is one object and one event, at its end.
"""

from collections.abc import Callable
from enum import Enum
from functools import partial
from typing import Protocol

from harness.kernel import Kernel
from harness.line.disturbance import Interference
from harness.line.serial_format import SerialFormat
from harness.line.transmission import Reception, Transmission


class Topology(Enum):
    """How many pairs of wire the line has."""

    FOUR_WIRE = "4-wire"
    TWO_WIRE = "2-wire"


class Role(Enum):
    """Whether a node asks or answers; on four wires that decides on which pair it sends."""

    MASTER = "master"
    SLAVE = "slave"


class Node(Protocol):
    """A device on the line."""

    def receive(self, reception: Reception) -> None:
        """Take what has just ended on a pair that this node listens to."""


class Pair:
    """One twisted pair with its receivers.

    `broken` opens the whole pair; `interference` disturbs it. Both may be changed at any time and
    count for transmissions that end from then on.
    """

    __slots__ = (
        *("_begun", "_kernel", "_on_line", "_taps"),
        *("broken", "interference", "listeners", "name"),
    )

    def __init__(
        self,
        name: str,
        kernel: Kernel,
        taps: "list[Callable[[Transmission], None]]",
        begun: "list[Callable[[Transmission], None]]",
    ) -> None:
        self.name = name
        self.broken = False
        self.interference = Interference(kernel.random)
        self.listeners: list[Port] = []
        self._kernel = kernel
        self._taps = taps
        self._begun = begun
        self._on_line: list[Transmission] = []

    @property
    def busy(self) -> bool:
        """True while somebody sends."""
        now_ns = self._kernel.now_ns
        return any(other.start_ns <= now_ns < other.end_ns for other in self._on_line)

    def sending_until_ns(self, before_ns: int) -> int | None:
        """When somebody stops who has begun to send before an instant; None if nobody sends."""
        ends_ns = [other.end_ns for other in self._on_line if other.start_ns < before_ns]
        return max(ends_ns) if ends_ns else None

    def inject(self, data: bytes, format: SerialFormat) -> Transmission:  # noqa: A002
        """Put bytes on the pair that none of the nodes sent, from now on. All listeners hear it."""
        transmission = Transmission(self, None, data, self._kernel.now_ns, format)
        self.carry(transmission)
        return transmission

    def carry(self, transmission: Transmission) -> None:
        """Take a transmission on; whoever overlaps with it in time collides with it."""
        on_line = self._on_line
        for other in on_line:
            if other.start_ns < transmission.end_ns and transmission.start_ns < other.end_ns:
                other.overlapping.append(transmission)
                transmission.overlapping.append(other)
        on_line.append(transmission)
        transmission.event = self._kernel.at(
            transmission.end_ns, partial(self._deliver, transmission)
        )
        for told in self._begun:
            told(transmission)

    def cut(self, sender: "Port") -> None:
        """End what a node sends now; the byte in progress and those behind it are never sent."""
        now_ns = self._kernel.now_ns
        for transmission in [sent for sent in self._on_line if sent.sender is sender]:
            if transmission.event is not None:
                self._kernel.cancel(transmission.event)
            whole = sum(
                transmission.byte_end_ns(index) <= now_ns for index in range(len(transmission.data))
            )
            transmission.data = transmission.data[:whole]
            transmission.end_ns = max(now_ns, transmission.start_ns)
            transmission.event = self._kernel.at(now_ns, partial(self._deliver, transmission))

    def _deliver(self, transmission: Transmission) -> None:
        self._on_line.remove(transmission)
        transmission.event = None
        heard = transmission.heard = self.interference.heard(transmission)
        for tap in self._taps:
            tap(transmission)
        if not self.interference.delays.idle and (parts := self.interference.parted(heard)):
            heard, late = parts
            self._kernel.at(late.end_ns, partial(self._hand_out, transmission, late))
        self._hand_out(transmission, heard)

    def _hand_out(self, transmission: Transmission, heard: Reception) -> None:
        if self.broken:
            return
        sender, wire = transmission.sender, transmission.format.wire
        as_sent = not transmission.overlapping and len(heard.data) > 0
        for port in self.listeners:
            if port is sender or port.receive_open:
                continue
            if as_sent and port.format.wire == wire:
                port.node.receive(heard)
                continue
            reception = _heard_while_sending(port, heard)
            if port.format.wire != wire:
                reception = reception.with_format(port.format)
            if reception.data:
                port.node.receive(reception)


class Port:
    """One node's connection to the line.

    `format` is the node's own setting and may change. `receive_open` breaks the wire to this
    node's receiver for transmissions that end from then on.
    """

    __slots__ = ("_kernel", "_last", "_transmit_open", "format", "node", "pair", "receive_open")

    def __init__(
        self,
        kernel: Kernel,
        node: Node,
        pair: Pair,
        format: SerialFormat,  # noqa: A002 - the field's term
    ) -> None:
        self._kernel = kernel
        self._last: Transmission | None = None
        self._transmit_open = False
        self.node = node
        self.pair = pair
        self.format = format
        self.receive_open = False

    def transmit(self, data: bytes) -> Transmission:
        """Send bytes from now on, or behind what this node is still sending."""
        start_ns = self._kernel.now_ns
        if self._last is not None and self._last.end_ns > start_ns:
            start_ns = self._last.end_ns
        transmission = Transmission(self.pair, self, data, start_ns, self.format)
        self._last = transmission
        if not self._transmit_open:
            self.pair.carry(transmission)
        return transmission

    @property
    def transmitting(self) -> bool:
        """True while bytes of this node are going out."""
        return self._last is not None and self._last.end_ns > self._kernel.now_ns

    def abort(self) -> None:
        """Stop sending in the middle, as a device does that loses its supply."""
        if self.transmitting:
            self.pair.cut(self)
            self._last = None

    @property
    def transmit_open(self) -> bool:
        """True if the wire from this node's transmitter is broken."""
        return self._transmit_open

    @transmit_open.setter
    def transmit_open(self, is_open: bool) -> None:
        if is_open:
            self.abort()
        self._transmit_open = is_open


class Line:
    """The RS-485 line of one gateway or PLC, with everything that hangs on it.

    `master_pair` carries what masters send and `slave_pair` what slaves send; with two wires they
    are the same pair. Each function in `taps` gets every transmission when it is over, and each in
    `begun` when somebody has begun to send it or has put it behind what is still on its way.
    """

    __slots__ = ("_kernel", "begun", "master_pair", "ports", "slave_pair", "taps", "topology")

    def __init__(self, kernel: Kernel, topology: Topology = Topology.FOUR_WIRE) -> None:
        self._kernel = kernel
        self.topology = topology
        self.taps: list[Callable[[Transmission], None]] = []
        self.ports: list[Port] = []
        self.begun: list[Callable[[Transmission], None]] = []
        self.master_pair = self.slave_pair = Pair("master", kernel, self.taps, self.begun)
        if topology is not Topology.TWO_WIRE:
            self.slave_pair = Pair("slave", kernel, self.taps, self.begun)

    def attach(self, node: Node, role: Role, format: SerialFormat) -> Port:  # noqa: A002
        """Connect a node; `format` is how it sends and what it expects to receive."""
        sends_on, hears = self.master_pair, self.slave_pair
        if role is Role.SLAVE:
            sends_on, hears = hears, sends_on
        port = Port(self._kernel, node, sends_on, format)
        self.ports.append(port)
        hears.listeners.append(port)
        return port

    def detach(self, port: Port) -> None:
        """Take a node off the line, in the middle of what it sends if need be."""
        port.abort()
        self.ports.remove(port)
        for pair in {id(pair): pair for pair in (self.master_pair, self.slave_pair)}.values():
            if port in pair.listeners:
                pair.listeners.remove(port)


def _heard_while_sending(port: Port, heard: Reception) -> Reception:
    """What is left for a node that was sending itself: its receiver is off meanwhile."""
    transmission = heard.transmission
    deaf = [other for other in transmission.overlapping if other.sender is port]
    lost = {at for own in deaf for at in transmission.bytes_within(own.start_ns, own.end_ns)}
    return heard.without(frozenset(lost)) if lost else heard
