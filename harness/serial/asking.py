"""A master at a port that asks one question at a time and waits for its reply.

An adapter for two wires may give back what is sent. What a drive replies to a write request is the
same as the request, so an echo must be known before it can be told from a reply: a single zero
shows it, of which no drive takes notice (VF-AS1 RS485 manual E6581315, pp. 6, 20: bytes before a
start code are dropped; MODBUS over Serial Line V1.02, 2.5.1.1: a frame has four bytes at least).
"""

from collections.abc import Callable
from time import monotonic_ns
from typing import NamedTuple

from fbgen.wire.line_frames import FrameSplitter, LineFrame
from fbgen.wire.line_protocols import LineProtocol
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import SerialFormat
from harness.serial.ports import Port

_PROBE = b"\x00"
_PROBE_NS = 60 * NS_PER_MS
"""Longer than USB adapters hold a byte back."""
_QUIET_NS = 5 * NS_PER_MS
"""So long nothing comes before something is sent: silence between frames, and late replies."""
_REPLY_BYTES = 20
"""As many as a reply with one word may have in any form."""
_MOST_DRAINED_NS = 200 * NS_PER_MS


class Heard(NamedTuple):
    """What came of a question.

    `reply` is the frame that answers it, None without one. `others` are whole frames that answer
    something else; `rest` are bytes that are no frame. `took_ns` is the time up to the reply.
    """

    reply: bytes | None
    others: tuple[bytes, ...]
    rest: bytes
    took_ns: int


class Asking:
    """A port with a master behind it. `echoes` says whether what is sent comes back."""

    def __init__(
        self,
        port: Port,
        protocol: LineProtocol,
        characters: SerialFormat,
        timeout_ns: int,
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._port = port
        self._protocol = protocol
        self._characters = characters
        self._timeout_ns = timeout_ns
        self._clock_ns = clock_ns
        self._splitter = FrameSplitter(protocol, "reply")
        self.echoes: bool | None = None
        self.told: Callable[[str, bytes, int], None] = lambda direction, data, took_ns: None

    def ask(self, request: bytes, *, answered: bool = True) -> Heard:
        """Send a frame and wait for what answers it; for the time of its bytes if nothing does.

        Raises DiagnosticError FB9031 if the port is not there any more.
        """
        self._drain()
        if self.echoes is None:
            self._probe()
        self._splitter = FrameSplitter(self._protocol, "reply")
        begin_ns = self._clock_ns()
        self.told("sent", request, 0)
        self._port.write(request)
        wait_ns = self._characters.duration_ns(len(request))
        if answered:
            wait_ns += self._timeout_ns + self._characters.duration_ns(_REPLY_BYTES)
        echo = request if self.echoes else b""
        others: list[bytes] = []
        rest = b""
        while (left_ns := begin_ns + wait_ns - self._clock_ns()) > 0:
            data = self._port.read(left_ns / NS_PER_S)
            if not data:
                continue
            now_ns = self._clock_ns()
            self.told("heard", data, now_ns - begin_ns)
            data, echo = without_echo(data, echo)
            for frame in self._splitter.feed(data, now_ns):
                if answered and _answers(self._protocol, request, frame):
                    return Heard(frame.data, tuple(others), rest, now_ns - begin_ns)
                if frame.direction == "reply":
                    others.append(frame.data)
                else:
                    rest += frame.data
        took_ns = self._clock_ns() - begin_ns
        for frame in self._splitter.flush():
            if answered and _answers(self._protocol, request, frame):
                # behind the rest of another one, which looked like the begin of a frame
                return Heard(frame.data, tuple(others), rest, took_ns)
            if frame.direction == "reply":
                others.append(frame.data)
            else:
                rest += frame.data
        return Heard(None, tuple(others), rest, took_ns)

    def _drain(self) -> None:
        """Let what still comes go by."""
        end_ns = self._clock_ns() + _MOST_DRAINED_NS
        while self._port.read(_QUIET_NS / NS_PER_S) and self._clock_ns() < end_ns:
            pass

    def _probe(self) -> None:
        """Find out whether the adapter gives back what is sent."""
        self.echoes = echoes(self._port, self._clock_ns)
        self._drain()


def echoes(port: Port, clock_ns: Callable[[], int] = monotonic_ns) -> bool:
    """Whether an adapter gives back what is sent. Nothing may be on its way."""
    port.write(_PROBE)
    end_ns = clock_ns() + _PROBE_NS
    heard = b""
    while not heard and (left_ns := end_ns - clock_ns()) > 0:
        heard = port.read(left_ns / NS_PER_S)
    return heard == _PROBE


def _answers(protocol: LineProtocol, request: bytes, frame: LineFrame) -> bool:
    return frame.direction == "reply" and protocol.answers(request, frame.data)


def without_echo(data: bytes, echo: bytes) -> tuple[bytes, bytes]:
    """What is left of `data` behind the echo, and what is left of the echo to come."""
    size = min(len(data), len(echo))
    if data[:size] != echo[:size]:
        return data, b""
    return data[size:], echo[size:]
