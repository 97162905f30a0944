"""A CPU with a communication module, a line, and somebody at its other end."""

from collections.abc import Mapping

from fbgen.source import Source
from harness.engine.interface import EngineFactory, Value
from harness.engine.loading import engine_named, read_program
from harness.fieldbus import DpMaster
from harness.kernel import NS_PER_MS, Kernel
from harness.line import DRIVE_FORMAT, GATEWAY_FORMAT, Line, Reception, Role, Topology
from harness.plc import Cpu, CpuFamily, CpuSettings
from harness.plc.serial import ReceiveConditions, SerialModule

PORT = 270
ENGINES = ("compiled", "reference")


class Peer:
    """Hears everything on the line and sends what it is told to."""

    def __init__(self, line: Line) -> None:
        self.port = line.attach(self, Role.SLAVE, DRIVE_FORMAT)
        self.heard: list[bytes] = []
        self.answers: dict[bytes, bytes] = {}

    def receive(self, reception: Reception) -> None:
        self.heard.append(reception.data)
        if reception.data in self.answers:
            self.port.transmit(self.answers[reception.data])


class SerialRig:
    """The module at port 270; `text` has an OB1, cycle 5 ms."""

    def __init__(
        self,
        text: str,
        *,
        engine: str = "compiled",
        family: CpuFamily = CpuFamily.S7_1500,
        dialect: str = "tia",
        conditions: ReceiveConditions | None = None,
        load: EngineFactory | None = None,
    ) -> None:
        self.kernel = Kernel(1)
        self.line = Line(self.kernel, Topology.FOUR_WIRE)
        self.peer = Peer(self.line)
        settings = CpuSettings(family=family, cycle_ns=5 * NS_PER_MS)
        self.cpu = Cpu(self.kernel, settings, DpMaster(self.kernel))
        self.module = SerialModule(self.kernel, self.line, GATEWAY_FORMAT, conditions, "cm")
        self.cpu.serial_ports.plug(PORT, self.module)
        program = read_program([Source("test.scl", text)], dialect)
        self.cpu.load(program, load or engine_named(engine, None))
        self.cpu.start()

    def run_ms(self, time_ms: float) -> None:
        self.kernel.run_for(round(time_ms * NS_PER_MS))
        assert self.cpu.diagnostics == []

    def __getitem__(self, path: str) -> Value:
        return self.cpu.engine.global_value(f"Data.{path}")

    def __setitem__(self, path: str, value: Value | Mapping[str, Value]) -> None:
        self.cpu.engine.set_global(f"Data.{path}", value)
