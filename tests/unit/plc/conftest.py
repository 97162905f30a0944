"""A CPU whose program is a Python function, with a slave behind it."""

from collections.abc import Callable, Mapping

import pytest

from fbgen.lang.checked import Program
from fbgen.lang.types import BYTE, ArrayType, Scalar, Type
from fbgen.source import Source, Span
from harness.engine.environment import Environment
from harness.engine.interface import FunctionResult, Instance, Limits, State, Value
from harness.engine.loading import read_program
from harness.fieldbus import (
    CycleTimes,
    DpMaster,
    DpSlave,
    Parameters,
    SlaveType,
    Station,
    StationSettings,
    watchdog_factors,
)
from harness.kernel import NS_PER_MS, Kernel
from harness.plc import Cpu, CpuFamily, CpuSettings, Mounting

OB1 = 'ORGANIZATION_BLOCK "Main"\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n'
OB100 = 'ORGANIZATION_BLOCK "Startup"\nBEGIN\n;\nEND_ORGANIZATION_BLOCK\n'
SPAN = Span(Source("test.scl", "DPRD_DAT"), 0, 8)
PRINTED_GSD = "30 30 20 30 30 70 20 70"
WHOLE_FRAME = "C0 89 87"


class ScriptedEngine:
    """An engine that notes what runs, and runs `bodies` instead of PLC text."""

    def __init__(self, program: Program, environment: Environment, limits: Limits) -> None:
        self.program = program
        self.environment = environment
        self.bodies: dict[str, Callable[[], None]] = {}
        self.runs: list[tuple[float, str]] = []
        self.starts: dict[str, list[bytes]] = {}
        self.resets: list[bool] = []

    def run_block(self, name: str, start: bytes = b"") -> None:
        self.runs.append((self.environment.now_ns / NS_PER_MS, name))
        self.starts.setdefault(name, []).append(start)
        self.bodies.get(name, lambda: None)()

    def reset(self, warm: bool) -> None:
        self.resets.append(warm)

    def instance(self, block_name: str) -> Instance:
        raise AssertionError("the CPU does not ask for this")

    def global_instance(self, name: str) -> Instance:
        raise AssertionError("the CPU does not ask for this")

    def call_function(self, name: str, arguments: Mapping[str, Value]) -> FunctionResult:
        raise AssertionError("the CPU does not ask for this")

    def global_value(self, path: str) -> Value:
        raise AssertionError("the CPU does not ask for this")

    def set_global(self, path: str, value: Value) -> None:
        raise AssertionError("the CPU does not ask for this")

    def snapshot(self) -> State:
        raise AssertionError("the CPU does not ask for this")

    def restore(self, state: State) -> None:
        raise AssertionError("the CPU does not ask for this")


class Record:
    """A variable of the program used as an area."""

    def __init__(self, length: int, kind: Type | None = None) -> None:
        self.type: Type = kind or ArrayType(((0, length - 1),), BYTE)
        self.data = bytearray(b"\xee" * length)

    @property
    def length(self) -> int:
        return len(self.data)

    def read(self) -> bytes:
        return bytes(self.data)

    def write(self, data: bytes) -> None:
        self.data[: len(data)] = data


class Rig:
    """CPU, master and one slave with byte addresses 256, in RUN since 20 ms if `start`ed."""

    def __init__(
        self,
        configuration: str = PRINTED_GSD,
        *,
        process_image: bool = True,
        hardware_identifier: int | None = None,
        text: str = OB1,
        dialect: str = "tia",
        seed: int = 0,
        times: CycleTimes | None = None,
        **settings: object,
    ) -> None:
        self.kernel = Kernel(seed)
        self.received: list[tuple[float, str]] = []
        self.master = DpMaster(self.kernel, times)
        self.settings = CpuSettings(**settings)
        self.cpu = Cpu(self.kernel, self.settings, self.master)
        code = bytes.fromhex(configuration)
        station_settings = StationSettings(
            "gw", 5, code, Parameters(1, watchdog_factors(100 * NS_PER_MS)), 256, 256
        )
        self.slave = DpSlave(self.kernel, self, SlaveType(1, code), 5, (10, 8))
        self.station: Station = self.master.add(station_settings, self.slave)
        self.cpu.mount(Mounting(self.station, process_image, hardware_identifier))
        self.program = read_program([Source("test.scl", text)], dialect)
        self.cpu.load(self.program, self.make_engine)

    def make_engine(
        self, program: Program, environment: Environment, limits: Limits
    ) -> ScriptedEngine:
        self.engine = ScriptedEngine(program, environment, limits)
        return self.engine

    def body(self, action: Callable[[], None], block: str = "Main") -> None:
        """What a block does."""
        self.engine.bodies[block] = action

    def start(self) -> "Rig":
        self.slave.power_on(5)
        self.cpu.start()
        self.run_ms(20)
        self.received.clear()
        return self

    def run_ms(self, milliseconds: float) -> None:
        self.kernel.run_for(round(milliseconds * NS_PER_MS))

    def dprd(self, laddr: int, record: Record) -> Scalar:
        return self.cpu.instruction("DPRD_DAT", {"LADDR": laddr, "RECORD": record}, SPAN)

    def dpwr(self, laddr: int, record: Record) -> Scalar:
        return self.cpu.instruction("DPWR_DAT", {"LADDR": laddr, "RECORD": record}, SPAN)

    # the device behind the slave
    def exchange_started(self) -> None:
        self.received.append((self.kernel.now_ns / NS_PER_MS, "online"))

    def exchange_lost(self) -> None:
        self.received.append((self.kernel.now_ns / NS_PER_MS, "offline"))

    def outputs_received(self, outputs: bytes) -> None:
        self.received.append((self.kernel.now_ns / NS_PER_MS, outputs.hex()))


@pytest.fixture
def make_rig() -> type[Rig]:
    """The class, for other settings."""
    return Rig


@pytest.fixture
def rig() -> Rig:
    """An S7-1500 with the printed GSD in the process image, not started."""
    return Rig()


@pytest.fixture
def record_of() -> type[Record]:
    """A record of a length and a type."""
    return Record


@pytest.fixture(params=[CpuFamily.S7_300, CpuFamily.S7_400], ids=lambda family: family.value)
def classic(request: pytest.FixtureRequest) -> CpuFamily:
    """Each of the classic families."""
    family: CpuFamily = request.param
    return family
