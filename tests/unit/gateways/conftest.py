"""A TOSPBDP001 on a bench: master on one side, a scripted inverter on the other."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from fbgen.catalog import load_catalog
from fbgen.wire.toshiba import seal
from harness.fieldbus import DpMaster, Parameters, Station, StationSettings, watchdog_factors
from harness.gateways.tospbdp001 import Tospbdp001, TosSettings, tospbdp001_settings
from harness.kernel import NS_PER_MS, Kernel
from harness.line import (
    DRIVE_FORMAT,
    PARITY_ERROR,
    Disturbance,
    Line,
    Pair,
    Reception,
    Role,
    Transmission,
)

WATCHDOG_NS = 100 * NS_PER_MS


class ScriptedInverter:
    """Hears everything and answers binary telegrams to its number with `answer`."""

    def __init__(self, kernel: Kernel, line: Line, inv_no: int, reply_ns: int) -> None:
        self.kernel = kernel
        self.inv_no = inv_no
        self.reply_ns = reply_ns
        self.heard: list[tuple[int, bytes]] = []
        self.answer: Callable[[bytes], bytes] = lambda frame: frame
        self.port = line.attach(self, Role.SLAVE, DRIVE_FORMAT)

    def receive(self, reception: Reception) -> None:
        self.heard.append((self.kernel.now_ns, reception.data))
        if reception.data[:2] == bytes((0x2F, self.inv_no)):
            self.say(self.answer(reception.data), self.reply_ns)

    def say(self, frame: bytes, delay_ns: int = 0) -> None:
        if frame:
            self.kernel.after(delay_ns, lambda: self.port.transmit(frame))

    @property
    def frames(self) -> list[bytes]:
        """The binary frames heard."""
        return [data for _, data in self.heard if data[:1] == b"/"]

    @property
    def heartbeats(self) -> list[int]:
        """When ASCII frames were heard, in nanoseconds."""
        return [time_ns for time_ns, data in self.heard if data[:1] == b"("]


class Bench:
    """The gateway with everything around it, 20 ms after power-on and in data exchange."""

    def __init__(
        self,
        settings: TosSettings,
        watchdog_ns: int | None = WATCHDOG_NS,
        parameters: Parameters | None = None,
        configuration: bytes | None = None,
    ) -> None:
        self.kernel = Kernel(1)
        self.settings = settings
        self.layout = settings.layout
        self.line = Line(self.kernel)
        self.gateway = Tospbdp001(self.kernel, settings, self.line, 2, "gw1")
        self.inverter = ScriptedInverter(self.kernel, self.line, 0x0B, 20 * NS_PER_MS)
        self.on_line: list[Transmission] = []
        self.line.taps.append(self.on_line.append)
        self.master = DpMaster(self.kernel)
        factors = None if watchdog_ns is None else watchdog_factors(watchdog_ns)
        self.station: Station = self.master.add(
            StationSettings(
                "gw1",
                2,
                configuration or self.layout.configuration,
                parameters or Parameters(settings.ident_number, factors),
            ),
            self.gateway.slave,
        )
        self.gateway.power_on()
        self.master.start()
        self.master.operate()
        self.run_ms(20)

    def run_ms(self, milliseconds: float) -> None:
        self.kernel.run_for(round(milliseconds * NS_PER_MS))

    def send(self, control: int, trigger: int, telegram: str) -> None:
        """The PLC writes a telegram (six bytes in hex); the pad, if any, stays 0."""
        outputs = bytearray(self.layout.output_length)
        outputs[0:2] = control.to_bytes(2, "big")
        outputs[self.layout.trigger_offset] = trigger
        rest = bytes.fromhex(telegram)
        for start, end in self.layout.telegram:
            outputs[start:end], rest = rest[: end - start], rest[end - start :]
        self.station.write(0, bytes(outputs))

    def control(self, control: int) -> None:
        self.station.write(0, control.to_bytes(2, "big"))

    def noise(self, data: bytes) -> None:
        """Something comes from the drives' side; the gateway has looked at it afterwards."""
        self.inverter.say(data)
        self.run_ms(20)

    def valid_reply(self) -> None:
        self.noise(seal(bytes.fromhex("0B47FE031234")))

    @property
    def status(self) -> int:
        """The status word as the PLC sees it."""
        return int.from_bytes(self.station.inputs[0:2], "big")

    @property
    def reply(self) -> bytes:
        """The six bytes behind the status word as the PLC sees them."""
        return bytes(self.station.inputs[2:8])


@pytest.fixture(scope="session")
def settings_of() -> Callable[..., TosSettings]:
    """Settings from the catalogue: settings_of("gsd10", error_counter="continue")."""
    entry = load_catalog().gateway("tospbdp001")

    def make(layout: str = "gsd10", **options: str | int | bool) -> TosSettings:
        return tospbdp001_settings(entry, entry.layout(layout), options)

    return make


@pytest.fixture
def bench_of(settings_of: Callable[..., TosSettings]) -> Callable[..., Bench]:
    """A bench with settings changed: bench_of(heartbeat_ns=...)."""

    def make(layout: str = "gsd10", **changes: object) -> Bench:
        return Bench(replace(settings_of(layout), **changes))

    return make


@pytest.fixture
def bench(bench_of: Callable[..., Bench]) -> Bench:
    """The bench as the catalogue describes the gateway, GSD layout."""
    return bench_of()


@pytest.fixture
def make_bench() -> type[Bench]:
    """The bench's class, for other parameters and configurations."""
    return Bench


@pytest.fixture
def scripted() -> Callable[[Bench, int], ScriptedInverter]:
    """Another scripted inverter on the line: scripted(bench, 0x0C)."""

    def make(bench: Bench, inv_no: int) -> ScriptedInverter:
        return ScriptedInverter(bench.kernel, bench.line, inv_no, 20 * NS_PER_MS)

    return make


@pytest.fixture
def disturb() -> Callable[[Pair], None]:
    """Give the next transmission on a pair a parity error in its third byte."""

    def apply(pair: Pair) -> None:
        pair.interference.disturb_next(Disturbance(mark={2: PARITY_ERROR}))

    return apply
