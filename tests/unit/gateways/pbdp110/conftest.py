"""A PBDP-110 on a bench: a master that a test plays, and a drive or a script at each port."""

from collections.abc import Mapping
from typing import Any

import pytest

from fbgen.catalog import OptionValue, load_catalog
from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import BadRequest, Command, ErrorCode, ErrorReply, Reply
from harness.drives import Inverter, InverterSettings, ReplyTime
from harness.fieldbus import Parameters
from harness.gateways.pbdp110 import DriveFacts, Pbdp110, drive_facts, pbdp110_settings
from harness.kernel import NS_PER_MS, Kernel
from harness.line import DRIVE_FORMAT, Line, Reception, Role
from tests.vectors.reading import entries

CATALOG = load_catalog()
INTERFACE = CATALOG.process_data_gateway("pbdp110")
SERIES = CATALOG.drive("vf-s11")
ENTRIES = entries("pbdp110_words")
BAUD_CODES = {1200: 0, 2400: 1, 4800: 2, 9600: 3, 19200: 4}
PARITY_CODES = {"none": 0, "even": 1, "odd": 2}
MASTER = 1


class ScriptedDrive:
    """Answers each read from `cells`, and each write as `refusal` says, 5 ms later."""

    def __init__(self, kernel: Kernel, line: Line) -> None:
        self.kernel = kernel
        self.cells: dict[int, int] = {}
        self.refusal: ErrorCode | None = None
        self.tripped = False
        self.written: list[tuple[str, int, int]] = []
        self.port = line.attach(self, Role.SLAVE, DRIVE_FORMAT)

    def receive(self, reception: Reception) -> None:
        request = toshiba_binary.parse_request(reception.data)
        if request is None or isinstance(request, BadRequest) or reception.marks is not None:
            return
        value = request.data
        if request.command is Command.R:
            value = self.cells.get(request.com_no, 0)
        else:
            self.written.append((request.command.name, request.com_no, value))
        reply: Reply | ErrorReply = Reply(
            request.address, request.command, request.com_no, value, self.tripped
        )
        if self.refusal is not None and request.com_no not in (0xFA00, 0xFA01, *self.cells):
            reply = ErrorReply(request.address, self.refusal, self.tripped)
        frame = toshiba_binary.encode_reply(reply)
        self.kernel.after(5 * NS_PER_MS, lambda: self.port.transmit(frame))


class Bench:
    """The interface with supply, its slave not yet parametrised. `module` is what the master has.

    `outputs` are the master's bytes, which `send` puts out; `inputs` what came back last.
    """

    def __init__(
        self,
        module: int = 2,
        options: Mapping[str, OptionValue] | None = None,
        facts: Mapping[str, DriveFacts] | None = None,
    ) -> None:
        self.kernel = Kernel(1)
        self.lines = {name: Line(self.kernel) for name in "ab"}
        known = dict.fromkeys("ab", drive_facts(SERIES))
        layout = INTERFACE.layout("module2")
        settings = pbdp110_settings(INTERFACE, layout, options or {}, facts or known)
        self.device = Pbdp110(self.kernel, settings, self.lines, 5, "gw1")
        self.slave = self.device.slave
        self.layout = INTERFACE.layout(f"module{module}")
        self.outputs = bytearray(self.layout.output_length)
        self.inputs = b""

    def drive(self, channel: str, baud: int = 19200, parity: str = "even") -> Inverter:
        """A VF-S11 at a port, with INV-NO 17: the interface must not care."""
        parameters = {
            "baud_rate": BAUD_CODES[baud],
            "parity": PARITY_CODES[parity],
            "inverter_number": 17,
            "maximum_frequency": 80.0,
            "upper_limit_frequency": 80.0,
            "acceleration_time": 0.1,
            "deceleration_time": 0.1,
        }
        settings = InverterSettings(
            channel, parameters, reply_time=ReplyTime(5 * NS_PER_MS, 5 * NS_PER_MS)
        )
        return Inverter(self.kernel, self.lines[channel], SERIES, settings)

    def script(self, channel: str) -> ScriptedDrive:
        """A script at a port."""
        return ScriptedDrive(self.kernel, self.lines[channel])

    def start(self, watchdog: tuple[int, int] | None = (1, 10), run_ms: float = 400) -> None:
        """Supply from drive A, parameters, configuration, and 0.4 s of zeros."""
        self.device.supply("a", True)
        self.parametrise(watchdog)
        self.send()
        self.run_ms(run_ms)

    def parametrise(self, watchdog: tuple[int, int] | None = (1, 10)) -> None:
        self.slave.set_prm(Parameters(self.slave.type.ident_number, watchdog), MASTER)
        self.slave.chk_cfg(self.layout.identifiers)

    def put(self, name: str, word: int) -> None:
        """A word into the outputs, by the name of its field."""
        at = self.layout.output_field(name).offset
        self.outputs[at : at + 2] = word.to_bytes(2, "big")

    def send(self, run_ms: float = 0, **words: int) -> None:
        """Data exchange with these words in the outputs."""
        for name, word in words.items():
            self.put(name, word)
        answer = self.slave.data_exchange(bytes(self.outputs))
        assert answer is not None, "the slave is in data exchange"
        self.run_ms(run_ms)

    def run_ms(self, duration_ms: float) -> None:
        """Let time pass, then look at the inputs."""
        self.kernel.run_for(round(duration_ms * NS_PER_MS))
        self.inputs = self.slave.inputs

    def word(self, name: str) -> int:
        """A word of the inputs as they were looked at last."""
        at = next(item.offset for item in self.layout.input if item.name == name)
        return int.from_bytes(self.inputs[at : at + 2], "big")

    def online(self, channel: str) -> bool:
        return bool(self.word(f"{channel}_status") & 0x8000)

    def request(self, channel: str, code: int, number: int, data: int = 0, ms: float = 150) -> None:
        """A request in the parameter channel: idle first, then the code."""
        self.send(40, **{f"{channel}_action": 0})
        words = {f"{channel}_number": number, f"{channel}_data": data}
        self.send(ms, **words, **{f"{channel}_action": code << 12})

    def response(self, channel: str) -> tuple[int, int, int]:
        """Response bits, number and data."""
        names = ("response", "number", "data")
        bits, number, data = (self.word(f"{channel}_{name}") for name in names)
        return bits >> 12, number, data


@pytest.fixture
def bench() -> Bench:
    """Module 2, nothing at the ports, no supply."""
    return Bench()


@pytest.fixture
def vectors() -> dict[str, dict[str, Any]]:
    """The second reading of the manual, by the id of the entry."""
    return ENTRIES


@pytest.fixture
def make_bench() -> type[Bench]:
    """Makes a bench with another module or other options."""
    return Bench
