"""A CAN bus on the virtual clock: frames take their time, and the lowest identifier goes first.

A data frame with an identifier of 11 bits has 47 bits around its data, the pause behind it
included. Stuff bits are not counted: a real frame takes up to a fifth longer. Nothing gets lost.
"""

from collections.abc import Callable

from fbgen.wire.devicenet import Frame
from harness.kernel import NS_PER_S, Kernel

Receiver = Callable[[Frame], None]


class CanPort:
    """Where a node hangs on the bus. Unplugged, it neither hears nor sends."""

    __slots__ = ("_bus", "_receive", "plugged")

    def __init__(self, bus: "CanBus", receive: Receiver) -> None:
        self._bus = bus
        self._receive = receive
        self.plugged = True

    def send(self, frame: Frame) -> None:
        """Put a frame in the row of those that wait for the bus."""
        if self.plugged:
            self._bus.queue(self, frame)

    def hear(self, frame: Frame) -> None:
        """A frame of another node is over."""
        if self.plugged:
            self._receive(frame)


class CanBus:
    """One cable. Functions in `taps` get every frame with the instant of its end and its sender,
    when everybody else has heard it."""

    __slots__ = ("_kernel", "_ports", "_sending", "_sequence", "_waiting", "bit_rate", "taps")

    def __init__(self, kernel: Kernel, bit_rate: int = 500_000) -> None:
        self._kernel = kernel
        self._ports: list[CanPort] = []
        self._waiting: list[tuple[int, int, CanPort, Frame]] = []
        self._sequence = 0
        self._sending = False
        self.bit_rate = bit_rate
        self.taps: list[Callable[[int, Frame, CanPort], None]] = []

    def attach(self, receive: Receiver) -> CanPort:
        """Connect a node, by what it does with the frames of others."""
        port = CanPort(self, receive)
        self._ports.append(port)
        return port

    def duration_ns(self, frame: Frame) -> int:
        """How long a frame takes."""
        return frame.bits * NS_PER_S // self.bit_rate

    def queue(self, port: CanPort, frame: Frame) -> None:
        """A frame waits until the bus is free and no lower identifier waits; in order if equal."""
        self._sequence += 1
        self._waiting.append((frame.identifier, self._sequence, port, frame))
        if not self._sending:
            # Nodes that begin at one instant decide among each other who goes on.
            self._sending = True
            self._kernel.after(0, self._begin, priority=1)

    def _begin(self) -> None:
        waiting = [item for item in self._waiting if item[2].plugged]
        if not waiting:
            self._waiting.clear()
            self._sending = False
            return
        first = min(waiting, key=lambda item: item[:2])
        waiting.remove(first)
        self._waiting = waiting
        _, _, sender, frame = first
        self._kernel.after(self.duration_ns(frame), lambda: self._end(sender, frame))

    def _end(self, sender: CanPort, frame: Frame) -> None:
        for port in self._ports:
            if port is not sender:
                port.hear(frame)
        for tap in self.taps:
            tap(self._kernel.now_ns, frame, sender)
        self._kernel.after(0, self._begin, priority=1)
