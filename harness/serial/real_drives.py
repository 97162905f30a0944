"""Real inverters at a simulated gateway or communication module: the plant follows the wall clock.

An event of the plant's own clock waits until its instant has come on the wall, a millisecond ahead
of what follows at most, and takes what the port has heard meanwhile. If the machine is too slow,
the plant is behind, and catches up as soon as it can; how far it was behind is told.
"""

from collections.abc import Callable
from time import monotonic_ns
from typing import NamedTuple

from fbgen.plant import SerialLine
from fbgen.wire import modbus, modbus_rtu, toshiba_ascii, toshiba_binary
from fbgen.wire.line_frames import FrameSplitter
from fbgen.wire.line_protocols import LINE_PROTOCOLS
from fbgen.wire.toshiba import Command, Request
from harness.drives import Inverter
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S, Kernel
from harness.line import DRIVE_FORMAT, GATEWAY_FORMAT, Parity, Role, SerialFormat
from harness.serial.asking import Asking, echoes
from harness.serial.bridge import LineBridge
from harness.serial.pace import Pace
from harness.serial.ports import SettablePort

_TICK_NS = NS_PER_MS
_FIRST = -1
"""Priority of the event that waits: what is due at the same instant comes behind it."""
_STOP_TIMEOUT_NS = 300 * NS_PER_MS


class RealTime(NamedTuple):
    """How a run has kept real time: how far it was behind at most, and for how many of its ms."""

    longest_ns: int
    late_ticks: int
    ticks: int


class RealDrives:
    """Takes simulated inverters off a line and puts a port in their place.

    `unit` is the name of the gateway or of the serial line, `served` how its drives are spoken to.
    `late_ns`: from there on the plant counts as behind.
    """

    def __init__(
        self,
        plant: Installation,
        unit: str,
        served: "SpokenTo",
        names: tuple[str, ...],
        port: SettablePort,
        *,
        late_ns: int,
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        line = plant.lines[unit]
        for name in names:
            drive = plant.drives[name]
            drive.power_off()
            line.detach(drive.communication.port)
        self._kernel = plant.kernel
        self._port = port
        self._clock_ns = clock_ns
        self._late_ns = late_ns
        self._pace: Pace | None = None
        self._longest_ns = self._late_ticks = self._ticks = 0
        port.set_characters(served.characters)
        protocol = LINE_PROTOCOLS[served.protocol]
        self._bridge = LineBridge(
            *(plant.kernel, line, port, Role.SLAVE, served.drives),
            byte_times=False,
            echoes=echoes(port, clock_ns),
            replies=FrameSplitter(protocol, "reply") if served.by_silence else None,
        )
        self._kernel.at(self._kernel.now_ns, self._tick, _FIRST)

    @property
    def kept(self) -> RealTime:
        """How real time was kept up to now."""
        return RealTime(self._longest_ns, self._late_ticks, self._ticks)

    def _tick(self) -> None:
        """Wait until this instant has come; meanwhile listen."""
        kernel = self._kernel
        if self._pace is None:
            self._pace = Pace(kernel, self._clock_ns)
        behind_ns = self._pace.due_ns - kernel.now_ns
        self._ticks += 1
        self._longest_ns = max(self._longest_ns, behind_ns)
        self._late_ticks += behind_ns > self._late_ns
        while True:
            left_ns = kernel.now_ns - self._pace.due_ns
            data = self._port.read(max(left_ns, 0) / NS_PER_S)
            if data:
                self._bridge.take(data)
            else:
                self._bridge.nothing_came()
            if left_ns <= 0 and not data:
                break
        kernel.at(_next_ns(kernel), self._tick, _FIRST)


def _next_ns(kernel: Kernel) -> int:
    """The next event, but within a millisecond: it is waited for, not run ahead of."""
    ahead_ns = max(kernel.quiet_until_ns(), kernel.now_ns + NS_PER_MS // 10)
    return min(ahead_ns, kernel.now_ns + _TICK_NS)


class SpokenTo(NamedTuple):
    """How the drives of a line are spoken to: `characters` are the master's, `drives` theirs.

    `by_silence`: the master is a module that tells messages by silence, and gets whole ones.
    """

    protocol: str
    characters: SerialFormat
    drives: SerialFormat
    in_ascii: bool = False
    by_silence: bool = False

    def stop(self, drive: Inverter) -> bytes:
        """The frame that stops an inverter by its ramp."""
        series, facts = drive.series, drive.communication.facts
        word = series.command_word.encode(["network_command"])
        number = series.comno(facts.command).number
        own = drive.registers.word(facts.inv_no)
        if self.protocol == "modbus":
            return modbus_rtu.encode_request(modbus.WriteRequest(own, number, word))
        request = Request(own, Command.P, number, word)
        if self.in_ascii:
            return toshiba_ascii.encode_request(request)
        return toshiba_binary.encode_request(request)


BEHIND_A_GATEWAY = SpokenTo("toshiba", GATEWAY_FORMAT, DRIVE_FORMAT)


def on_line(line: SerialLine) -> SpokenTo:
    """How the drives of a serial line are spoken to."""
    parity = Parity[line.parity.upper()]
    return SpokenTo(
        line.family,
        SerialFormat(line.baud, parity, 1),
        SerialFormat(line.baud, parity, 2),
        in_ascii=line.protocol == "toshiba_ascii",
        by_silence=True,
    )


def stop_drives(
    drives: tuple[Inverter, ...],
    served: SpokenTo,
    port: SettablePort,
    clock_ns: Callable[[], int] = monotonic_ns,
) -> tuple[str, ...]:
    """Tell real inverters to stop by their ramps; the names of those that have not answered.

    Nothing of the plant runs any more, so nobody else sends.
    """
    protocol = LINE_PROTOCOLS[served.protocol]
    asking = Asking(port, protocol, served.characters, _STOP_TIMEOUT_NS, clock_ns)
    return tuple(drive.name for drive in drives if asking.ask(served.stop(drive)).reply is None)
