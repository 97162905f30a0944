"""Real inverters at the line of a simulated gateway: the plant's clock follows the wall clock.

An event of the plant's own clock waits until its instant has come on the wall, a millisecond ahead
of what follows at most, and takes what the port has heard meanwhile. If the machine is too slow,
the plant is behind, and catches up as soon as it can; how far it was behind is told.
"""

from collections.abc import Callable
from time import monotonic_ns
from typing import NamedTuple

from fbgen.wire import toshiba_binary
from fbgen.wire.line_protocols import LINE_PROTOCOLS
from fbgen.wire.toshiba import Command, Request
from harness.drives import Inverter
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S, Kernel
from harness.line import DRIVE_FORMAT, GATEWAY_FORMAT, Role
from harness.serial.asking import Asking, echoes
from harness.serial.bridge import LineBridge
from harness.serial.pace import Pace
from harness.serial.ports import Port

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

    `late_ns`: from there on the plant counts as behind.
    """

    def __init__(
        self,
        plant: Installation,
        gateway: str,
        names: tuple[str, ...],
        port: Port,
        *,
        late_ns: int,
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        line = plant.lines[gateway]
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
        self._bridge = LineBridge(
            *(plant.kernel, line, port, Role.SLAVE, DRIVE_FORMAT),
            byte_times=False,
            echoes=echoes(port, clock_ns),
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
            if left_ns <= 0 and not data:
                break
        kernel.at(_next_ns(kernel), self._tick, _FIRST)


def _next_ns(kernel: Kernel) -> int:
    """The next event, but within a millisecond: it is waited for, not run ahead of."""
    ahead_ns = max(kernel.quiet_until_ns(), kernel.now_ns + NS_PER_MS // 10)
    return min(ahead_ns, kernel.now_ns + _TICK_NS)


def stop_drives(
    drives: tuple[Inverter, ...], port: Port, clock_ns: Callable[[], int] = monotonic_ns
) -> tuple[str, ...]:
    """Tell real inverters to stop by their ramps; the names of those that have not answered.

    Nothing of the plant runs any more, so nobody else sends.
    """
    asking = Asking(port, LINE_PROTOCOLS["toshiba"], GATEWAY_FORMAT, _STOP_TIMEOUT_NS, clock_ns)
    silent = []
    for drive in drives:
        series = drive.series
        word = series.command_word.encode(["network_command"])
        number = series.comno(series.link.command).number
        own = drive.registers.word(series.link.inv_no)
        frame = toshiba_binary.encode_request(Request(own, Command.P, number, word))
        if asking.ask(frame).reply is None:
            silent.append(drive.name)
    return tuple(silent)
