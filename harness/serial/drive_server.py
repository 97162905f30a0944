"""Inverters at a port in real time, with whatever else looks on."""

from collections.abc import Callable
from time import monotonic_ns

from harness.serial.drives import ServedDrives
from harness.serial.pace import Pace
from harness.serial.ports import TICK_S, Port


class DriveServer:
    """Serves until it is told to stop. `longest_delay_ns`: how late something happened at most."""

    def __init__(
        self,
        served: ServedDrives,
        port: Port,
        clock_ns: Callable[[], int] = monotonic_ns,
    ) -> None:
        self._served = served
        self._port = port
        self._pace = Pace(served.kernel, clock_ns)
        self.longest_delay_ns = 0

    def serve(self, goes_on: Callable[[float], bool]) -> None:
        """Serve while `goes_on` says so.

        It is asked every 10 ms or so, and told for how many seconds nothing is due as far as can
        be seen. Raises DiagnosticError FB9031 if the port is not there any more.
        """
        self.step()
        while goes_on(self._pace.wait_s(1.0)):
            self.step()

    def step(self) -> None:
        """Wait for bytes or the next event, but not long; let happen what is due."""
        data = self._port.read(self._pace.wait_s(TICK_S))
        delay_ns = self._pace.catch_up()
        self.longest_delay_ns = max(self.longest_delay_ns, delay_ns)
        if data:
            self._served.bridge.take(data)
        self._served.log.look()
