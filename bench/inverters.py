"""31 inverters on one line, each asked in turn as fast as they answer, for one second of the line.

100 times real time is 10 ms for a second; 200 times, the aim at 20 ns a turn of the empty loop, is
5 ms, 250,000 turns. Where telegrams end by silence each inverter minds the time, too.
"""

from collections.abc import Iterator

from bench.measuring import Figure, measure
from fbgen.catalog import load_catalog
from fbgen.wire import modbus_rtu, toshiba_binary
from fbgen.wire.modbus import ReadRequest
from fbgen.wire.toshiba import Command, Request
from harness.drives import Inverter, InverterSettings, set_for_line
from harness.kernel import NS_PER_MS, NS_PER_S, Kernel
from harness.line import GATEWAY_FORMAT, Line, Reception, Role

INVERTERS = 31
_FE03 = 0xFE03
_PAUSE_NS = 3 * NS_PER_MS


class _Poller:
    """Asks the next inverter a little after the reply of the one before."""

    def __init__(self, kernel: Kernel, line: Line, frames: list[bytes]) -> None:
        self._kernel = kernel
        self._frames = frames
        self._next = 0
        self.replies = 0
        self._port = line.attach(self, Role.MASTER, GATEWAY_FORMAT)
        self.ask()

    def ask(self) -> None:
        self._port.transmit(self._frames[self._next])
        self._next = (self._next + 1) % len(self._frames)

    def receive(self, reception: Reception) -> None:
        self.replies += 1
        self._kernel.at(reception.end_ns + _PAUSE_NS, self.ask)


def figures() -> Iterator[Figure]:
    """A second of the line, by how telegrams end and in which protocol."""
    yield _figure("31 VF-S11, Toshiba by length", "vf-s11", False)
    yield _figure("31 VF-S15, Toshiba by silence", "vf-s15", False)
    yield _figure("31 VF-S15, MODBUS-RTU", "vf-s15", True)


def _figure(name: str, series: str, modbus: bool) -> Figure:
    kernel = Kernel(1)
    line = Line(kernel)
    known = load_catalog().drive(series)
    basis = set_for_line(known, None, 19_200, "even") | {"protocol_selection": float(modbus)}
    numbers = range(1, INVERTERS + 1)
    for number in numbers:
        settings = InverterSettings(parameters=basis | {"inverter_number": number})
        drive = Inverter(kernel, line, known, settings)
        drive.write_ram(known.comno("command_word").number, 0xC400)
        drive.write_ram(known.comno("frequency_setpoint").number, 5000)
    frames = [
        modbus_rtu.encode_request(ReadRequest(number, _FE03))
        if modbus
        else toshiba_binary.encode_request(Request(number, Command.G, _FE03))
        for number in numbers
    ]
    poller = _Poller(kernel, line, frames)
    kernel.run_for(NS_PER_S)
    assert poller.replies > INVERTERS
    second = measure("", lambda: kernel.run_for(NS_PER_S), windows=100)
    limit = f"{1 / second.seconds:.0f} times real time, at least 100"
    return Figure(f"1 s of {name}", second.seconds, second.turns, limit)
