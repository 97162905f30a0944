"""What is at a port as a node of the simulated line.

A real port takes the time of its bytes by itself: what comes from there has been on the wire
already, and what goes there is handed over when its first bit is due. A pseudo terminal takes no
time, and neither does a network socket to a program: there a request is on the simulated line for
as long as its bytes take, and a reply is handed over when its last bit is due.

A character with a parity or framing error does not get to a program, so it is not handed over.
What is sent while something else is on the wire is garbled from there on: what was handed over
before cannot be taken back, as it could not on a wire that is already being read.
"""

from fbgen.wire.line_frames import FrameSplitter
from harness.kernel import Kernel
from harness.line import Line, Reception, Role, SerialFormat, Transmission
from harness.serial.asking import without_echo
from harness.serial.ports import Port


class LineBridge:
    """Carries bytes between a port and a line. `received` and `sent` count those of the port.

    `echoes` says that the adapter gives back what is sent: that is taken off what comes. With
    `replies` what comes is put on the line by whole replies: adapters hold bytes back, and to who
    tells telegrams by silence one that comes in two pieces would be two.
    """

    def __init__(
        self,
        kernel: Kernel,
        line: Line,
        port: Port,
        role: Role,
        characters: SerialFormat,
        *,
        byte_times: bool,
        echoes: bool = False,
        replies: FrameSplitter | None = None,
    ) -> None:
        self._kernel = kernel
        self._port = port
        self._byte_times = byte_times
        self._echoes = echoes
        self._echo = b""
        self._replies = replies
        self._busy_until_ns = kernel.now_ns
        self.received = self.sent = 0
        self.node = line.attach(self, role, characters)
        self._heard_pair = line.slave_pair if role is Role.MASTER else line.master_pair
        if not byte_times:
            line.begun.append(self._begun)

    def take(self, data: bytes) -> None:
        """Bytes have come from the port, all of them up to now."""
        data, self._echo = without_echo(data, self._echo)
        if not data:
            return
        self.received += len(data)
        if self._replies is None:
            self._put_on_line(data)
            return
        for frame in self._replies.feed(data, self._kernel.now_ns):
            self._put_on_line(frame.data)

    def nothing_came(self) -> None:
        """The port was looked at: what no reply has become by now will not."""
        if self._replies is not None and not self._replies.idle:
            for frame in self._replies.end(self._kernel.now_ns):
                self._put_on_line(frame.data)

    def _put_on_line(self, data: bytes) -> None:
        if self._byte_times:
            self.node.transmit(data)
            return
        duration_ns = self.node.format.duration_ns(len(data))
        start_ns = max(self._kernel.now_ns - duration_ns, self._busy_until_ns)
        pair = self.node.pair
        pair.carry(Transmission(pair, self.node, data, start_ns, self.node.format))

    def receive(self, reception: Reception) -> None:
        """As a node: something that is for the port has ended on the line."""
        if self._byte_times:
            self._hand_over(reception)

    def _begun(self, transmission: Transmission) -> None:
        self._busy_until_ns = max(self._busy_until_ns, transmission.end_ns)
        pair = self._heard_pair
        if transmission.sender is self.node or transmission.pair is not pair or pair.broken:
            return
        heard = pair.interference.heard(transmission)
        if transmission.format.wire != self.node.format.wire:
            heard = heard.with_format(self.node.format)
        self._hand_over(heard)

    def _hand_over(self, heard: Reception) -> None:
        data = heard.data
        if heard.marks is not None:
            data = bytes(byte for byte, mark in zip(data, heard.marks, strict=True) if not mark)
        if data:
            self.sent += len(data)
            if self._echoes:
                self._echo = data
            self._port.write(data)
