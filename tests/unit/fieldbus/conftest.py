"""A master with one slave whose device only notes what it is told."""

import pytest

from harness.fieldbus import (
    CycleTimes,
    DpMaster,
    DpSlave,
    Parameters,
    SlaveType,
    Station,
    StationSettings,
    Transfer,
    watchdog_factors,
)
from harness.kernel import NS_PER_MS, Kernel

CONFIGURATION = bytes.fromhex("A3 91 30")


class NotedDevice:
    """4 consistent bytes out, 2 in, and a byte both ways."""

    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel
        self.events: list[tuple[float, str]] = []

    def exchange_started(self) -> None:
        self.note("started")

    def exchange_lost(self) -> None:
        self.note("lost")

    def outputs_received(self, outputs: bytes) -> None:
        self.note(outputs.hex())

    def note(self, what: str) -> None:
        self.events.append((self.kernel.now_ns / NS_PER_MS, what))

    @property
    def told(self) -> list[str]:
        return [what for _, what in self.events]


class Bus:
    """Master, station and slave; `running` brings them into data exchange (20 ms)."""

    def __init__(
        self,
        times: CycleTimes | None = None,
        *,
        watchdog_ms: int | None = 100,
        seed: int = 0,
        group: int = 0,
        ident_number: int = 0x1234,
        configuration: bytes = CONFIGURATION,
    ) -> None:
        self.kernel = Kernel(seed)
        self.device = NotedDevice(self.kernel)
        self.slave = DpSlave(self.kernel, self.device, SlaveType(0x1234, CONFIGURATION), 7, (5, 3))
        self.master = DpMaster(self.kernel, times)
        factors = None if watchdog_ms is None else watchdog_factors(watchdog_ms * NS_PER_MS)
        self.station: Station = self.master.add(
            StationSettings("valve", 7, configuration, Parameters(ident_number, factors, group)),
            self.slave,
        )
        self.transfers: list[Transfer] = []
        self.master.taps.append(self.transfers.append)

    def running(self) -> "Bus":
        self.slave.power_on(7)
        self.master.start()
        self.master.operate()
        self.run_ms(20)
        self.device.events.clear()
        self.transfers.clear()
        return self

    def run_ms(self, milliseconds: float) -> None:
        self.kernel.run_for(round(milliseconds * NS_PER_MS))


@pytest.fixture
def make_bus() -> type[Bus]:
    """The class, for other settings."""
    return Bus


@pytest.fixture
def bus() -> Bus:
    """A bus at 2 ms in data exchange since 20 ms, watchdog 100 ms."""
    return Bus().running()
