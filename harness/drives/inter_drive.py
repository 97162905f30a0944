"""Drive to drive: what a master inverter sends of its own accord, and how a slave takes it.

Facts: VF-AS1 RS485 manual E6581315, pp. 19 and 35 to 39: S from a sound master, s from one that has
tripped, to all, at the set-point ComNo of the port; 100.00 % is the maximum frequency. Which value
of F806 or F826 means what is the catalogue's. F811 to F814 make the percentage a frequency
(TOSPBDP001 manual v1.1, 8 F).

Inferred: a master sends again 20 ms after the end of its last telegram, waiting while others send.
A port without such a ComNo takes s like S. A slave that runs on takes what a tripped master sends;
one that trips with its master does so by an emergency stop. A word that is no set-point is written
as it is, and dropped if it is out of range: nobody answers.
"""

from collections.abc import Callable
from math import isclose
from typing import TYPE_CHECKING, Literal

from fbgen.catalog import Drive, SerialPort
from fbgen.catalog.communication import Role
from fbgen.wire import toshiba_inter_drive
from fbgen.wire.toshiba_inter_drive import SetPoint
from harness.drives.registers import Registers
from harness.kernel import NS_PER_MS, Event

if TYPE_CHECKING:
    from harness.drives.communication import Communication

PAUSE_NS = 20 * NS_PER_MS
SCALING = ("point_1_percent", "point_1_frequency", "point_2_percent", "point_2_frequency")
"""Names of the ComNos that make a percentage a frequency."""

_WHOLE_PERCENT = 100
MasterTrip = Literal["zero", "keep", "trip"]


def role_of(series: Drive, port: SerialPort, registers: Registers) -> Role | None:
    """What a port does on its own by its ComNo; None if it has none or that says nothing."""
    known = series.communication
    if known is None or known.inter_drive is None or port.inter_drive is None:
        return None
    return known.inter_drive.roles.get(registers.word(port.inter_drive))


def set_point_word(series: Drive, port: SerialPort, registers: Registers, word: int) -> int:
    """The set-point that a word of S means: a straight line through two points, from 0 to FH.

    10000 are 100.00 %.
    """
    value = registers.value
    low, low_hz, high, high_hz = (value(name) for name in SCALING)
    if isclose(low, high):
        hz = high_hz
    else:
        hz = low_hz + (word / _WHOLE_PERCENT - low) * (high_hz - low_hz) / (high - low)
    hz = min(max(hz, 0.0), value(series.link.maximum_frequency))
    return series.comno(port.setpoint).to_word(hz)


class MasterPort:
    """Sends the set-points of a master inverter at one port, as long as it is one."""

    __slots__ = ("_event", "_port", "_read", "_registers", "_series", "_tripped")

    def __init__(
        self,
        port: "Communication",
        series: Drive,
        registers: Registers,
        read: Callable[[int], int | None],
        tripped: Callable[[], bool],
    ) -> None:
        self._port = port
        self._series = series
        self._registers = registers
        self._read = read
        self._tripped = tripped
        self._event: Event | None = None

    def start(self) -> None:
        """Begin to send if the port is that of a master, as soon as it is no longer silent."""
        self.stop()
        port = self._port
        role = role_of(self._series, port.facts, self._registers)
        if role is not None and role.sends is not None:
            begin_ns = max(port.deaf_until_ns, port.kernel.now_ns)
            self._event = port.kernel.at(begin_ns + PAUSE_NS, self._send)

    def stop(self) -> None:
        """Send nothing more."""
        if self._event is not None:
            self._port.kernel.cancel(self._event)
            self._event = None

    def _send(self) -> None:
        port = self._port
        role = role_of(self._series, port.facts, self._registers)
        if role is None or role.sends is None:
            self._event = None
            return
        now_ns = until_ns = port.kernel.now_ns
        if port.deaf_until_ns > now_ns:
            until_ns = port.deaf_until_ns
        elif not port.port.pair.busy:
            until_ns = port.port.transmit(self._frame(role.sends)).end_ns
        self._event = port.kernel.at(until_ns + PAUSE_NS, self._send)

    def _frame(self, sends: str) -> bytes:
        series, comno = self._series, self._series.comno(sends)
        assert series.communication is not None
        assert series.communication.inter_drive is not None
        full = series.communication.inter_drive.full_scale
        value = comno.to_value(self._read(comno.number) or 0)
        whole = float(_WHOLE_PERCENT)
        if comno.unit == "Hz":
            whole = self._registers.value(series.link.maximum_frequency)
        word = min(0xFFFF, round(value / whole * full))
        com_no = self._registers.number(self._port.facts.setpoint)
        return toshiba_inter_drive.encode(SetPoint(word, self._tripped(), com_no))
