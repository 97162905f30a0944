"""A master that writes and reads all the time over a noisy line, and counts what went wrong.

It writes F880 (free notes) with a new word each time and reads it back. A wrong value is a word in
the inverter, there or elsewhere, that was not sent for it, or one that the master takes from a
reply and that the inverter never had. Both only come to pass where a check sum collides.
"""

from collections.abc import Callable

from drive_bench import CATALOG

from fbgen.dataclass import dataclass
from fbgen.wire import modbus_rtu, toshiba_binary
from fbgen.wire.modbus import ReadReply, ReadRequest, WriteReply, WriteRequest
from fbgen.wire.toshiba import Command, Reply, Request
from harness.drives import Inverter, InverterSettings, ReplyTime, set_for_line
from harness.kernel import NS_PER_MS, NS_PER_S, Kernel
from harness.line import Line, Parity, Reception, Role, SerialFormat

FREE_NOTES = 0x0880
_REPLY = ReplyTime(5 * NS_PER_MS, 5 * NS_PER_MS)
_PATIENCE_NS = 40 * NS_PER_MS


@dataclass(slots=True)
class Count:
    """What a master and an inverter have seen."""

    telegrams: int = 0
    answered: int = 0
    wrong_in_inverter: int = 0
    wrong_in_master: int = 0

    def row(self, title: str) -> str:
        """A row of the table in docs/reference/protocols.md."""
        lost = 100 * (1 - self.answered / self.telegrams)
        return (
            f"| {title} | {self.telegrams:,} | {lost:.1f} % "
            f"| {self.wrong_in_inverter} | {self.wrong_in_master} |"
        )


class _Master:
    """Sends one telegram after the other; what it hears within its patience is its reply."""

    def __init__(self, line: Line, kernel: Kernel, format: SerialFormat) -> None:  # noqa: A002
        self._kernel = kernel
        self.port = line.attach(self, Role.MASTER, format)
        self.heard: list[bytes] = []

    def receive(self, reception: Reception) -> None:
        if reception.marks is None:
            self.heard.append(reception.data)

    def ask(self, frame: bytes) -> list[bytes]:
        self.heard.clear()
        sent = self.port.transmit(frame)
        self._kernel.run_until(sent.end_ns + _PATIENCE_NS)
        return self.heard


def count(protocol: str, parity: str, seconds: int, seed: int, rate: float = 1e-3) -> Count:
    """The figures of so many seconds of a line of 19200 bit/s whose bits flip at a rate."""
    kernel = Kernel(seed)
    line = Line(kernel)
    for pair in (line.master_pair, line.slave_pair):
        pair.interference.bit_errors.probability = rate
    series = CATALOG.drive("vf-s11")
    parameters = set_for_line(series, None, 19_200, "even" if parity == "even" else "none")
    chosen = {"protocol_selection": float(protocol == "modbus"), "inverter_number": 11.0}
    settings = InverterSettings(parameters=parameters | chosen, reply_time=_REPLY)
    drive = Inverter(kernel, line, series, settings)
    master = _Master(line, kernel, SerialFormat(19_200, Parity[parity.upper()], 1))
    write, read = _MODBUS if protocol == "modbus" else _TOSHIBA
    found, word = Count(), 0
    cells = dict(drive.registers.ram)
    while kernel.now_ns < seconds * NS_PER_S:
        word = word + 0x9E37 & 0xFFFF
        for frame, value_in in (write(word), read()):
            before = drive.registers.ram[FREE_NOTES]
            found.telegrams += 1
            replies = [value for data in master.ask(frame) if (value := value_in(data)) is not None]
            after = drive.registers.ram[FREE_NOTES]
            found.wrong_in_inverter += after not in (before, word)
            found.answered += len(replies) == 1
            found.wrong_in_master += any(value not in (before, after) for value in replies)
        cells[FREE_NOTES] = drive.registers.ram[FREE_NOTES]
        if drive.registers.ram != cells:
            found.wrong_in_inverter += 1
            drive.power_off()
            drive.power_on()
            kernel.run_for(2 * NS_PER_S)
            cells = dict(drive.registers.ram)
    return found


_Sent = tuple[bytes, Callable[[bytes], int | None]]


def _toshiba_value(data: bytes, command: Command) -> int | None:
    reply = toshiba_binary.parse_reply(data)
    good = isinstance(reply, Reply) and reply.address == 11 and reply.com_no == FREE_NOTES
    return reply.data if good and reply.command is command else None


def _write_toshiba(word: int) -> _Sent:
    frame = toshiba_binary.encode_request(Request(11, Command.P, FREE_NOTES, word))
    return frame, lambda data: _toshiba_value(data, Command.P)


def _read_toshiba() -> _Sent:
    frame = toshiba_binary.encode_request(Request(11, Command.G, FREE_NOTES))
    return frame, lambda data: _toshiba_value(data, Command.G)


def _write_modbus(word: int) -> _Sent:
    def value(data: bytes) -> int | None:
        reply = modbus_rtu.parse_reply(data)
        good = isinstance(reply, WriteReply) and reply.address == 11 and reply.start == FREE_NOTES
        return reply.word if good else None

    return modbus_rtu.encode_request(WriteRequest(11, FREE_NOTES, word)), value


def _read_modbus() -> _Sent:
    def value(data: bytes) -> int | None:
        reply = modbus_rtu.parse_reply(data)
        good = isinstance(reply, ReadReply) and reply.address == 11 and len(reply.words) == 1
        return reply.words[0] if good else None

    return modbus_rtu.encode_request(ReadRequest(11, FREE_NOTES, 1)), value


_TOSHIBA = (_write_toshiba, _read_toshiba)
_MODBUS = (_write_modbus, _read_modbus)
KINDS = (
    ("Toshiba binary, even parity", "toshiba", "even"),
    ("Toshiba binary, no parity", "toshiba", "none"),
    ("MODBUS-RTU, even parity", "modbus", "even"),
    ("MODBUS-RTU, no parity", "modbus", "none"),
)
"""Title, protocol, parity."""
