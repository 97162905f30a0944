"""A DeviceNet option in an inverter at a CAN interface, in real time, for a master of others."""

from collections.abc import Callable
from time import monotonic_ns

from fbgen.catalog import Catalog
from fbgen.wire.devicenet import Frame
from harness.drives import Inverter, InverterSettings
from harness.gateways.dev003z import Dev003z, Dev003zSettings
from harness.kernel import NS_PER_S, Kernel
from harness.line import Line
from harness.serial.can_interfaces import TICK_S, CanInterface
from harness.serial.can_log import CanLog


class OptionServer:
    """Answers the network until it is told to stop. The virtual clock follows the wall clock."""

    def __init__(
        self,
        catalog: Catalog,
        kind: str,
        settings: Dev003zSettings,
        port: CanInterface,
        *,
        log: CanLog | None = None,
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        """Raises DiagnosticError FB7101, FB7106 and FB1109 for settings that cannot be."""
        self._port = port
        self._log = log
        self._clock_ns = clock_ns
        self.kernel = Kernel()
        self.received = self.sent = 0
        series = catalog.drive(settings.series)
        self.drive = Inverter(
            self.kernel, Line(self.kernel), series, InverterSettings(name=series.id)
        )
        gateway = catalog.devicenet_gateway(kind)
        self.option = Dev003z(self.kernel, gateway, self.drive, self._send, settings)
        self._offset_ns = clock_ns()

    @property
    def state(self) -> str:
        """One line for a person: lamps, state, and what the inverter does."""
        option, drive = self.option, self.drive
        lamps = ", ".join(
            f"{name} {light.state.replace('_', ' ')}"
            for name, light in zip(("MS", "NS"), option.lights, strict=True)
        )
        state = option.state.name.lower().replace("_", " ")
        does = f"{drive.frequency_hz:.2f} Hz" if drive.running else "stopped"
        if drive.tripped:
            does = f"tripped {drive.trip_display}"
        return f"MAC ID {option.node.settings.mac}: {lamps}; {state}; {drive.name} {does}"

    def serve(self, goes_on: Callable[[], bool]) -> None:
        """Serve while `goes_on` says so. FB9031 if the interface is not there any more."""
        while goes_on():
            self.step()

    def step(self) -> None:
        """Wait for a frame, but not longer than something is due; let time pass; answer."""
        frame = self._port.read(self._patience_s())
        self.kernel.run_until(self._now_ns())
        if frame is not None:
            self.received += 1
            self._note(frame, received=True)
            self.option.receive(frame)

    def _now_ns(self) -> int:
        return self._clock_ns() - self._offset_ns

    def _patience_s(self) -> float:
        """How long to wait for a frame: until something is due, so that no answer is late."""
        due_s = (self.kernel.quiet_until_ns() - self._now_ns()) / NS_PER_S
        return min(max(due_s, 0.0), TICK_S)

    def _send(self, frame: Frame) -> None:
        self.sent += 1
        self._note(frame, received=False)
        self._port.write(frame)

    def _note(self, frame: Frame, *, received: bool) -> None:
        if self._log is not None:
            self._log.write(self.kernel.now_ns, frame, received=received)
